// Playing: the window, the game and what is drawn over it, sixty ticks a second.
#pragma once
#include <optional>
#include <string>

#include "app/draw/overlay.h"
#include "app/play/game.h"
#include "app/play/menu.h"
#include "app/play/pacing.h"
#include "app/play/player_input.h"
#include "app/play/readout.h"
#include "app/play/settings.h"
#include "app/sounds.h"
#include "map/map.h"
#include "platform/window.h"
#include "render/choice/renderer.h"
#include "render/outside/outside_renderer.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

// F8: an eye that leaves the player's body and flies, through walls and out of rooms. It is nothing to the world: the
// body stands where it was left, the world goes on, and no tape knows of the flight.

/// Where the camera is.
enum class Whereabouts : std::uint8_t { in_room, above_ceiling, below_floor, outside };

class FreeCamera {
public:
    /// Begins where the eye is.
    explicit FreeCamera(const Eye& eye) : eye_(eye) {}

    /// Flies for a tick of so many seconds, the way it looks; use rises, crouch sinks, run is four times as fast.
    /// Through portals it goes as a body would, wherever they lead, at any height; through what is solid straight on,
    /// into the room that has that place (of several the first in the map) or out of all rooms.
    void move(const Map& map, const TickInput& input, double seconds);

    /// Its sector contains its point unless it is outside; then it is the last one that did.
    const Eye& eye() const { return eye_; }

    Whereabouts whereabouts(const Snapshot& snapshot) const;

    /// "Free flight: above the ceiling of 'hall', x 1.00 y 2.00 z 9.00. F8 goes back."
    std::string text(const Map& map, const Snapshot& snapshot) const;

private:
    void go_to(const Map& map, Vec2 to);

    Eye eye_;
    bool is_outside_ = false;
};

// F4: the world from outside, in a corner or instead of the player's own view, which then takes the corner.

class OutsideView {
public:
    enum class Shown : std::uint8_t { nowhere, inset, full };

    Shown shown() const { return shown_; }
    /// Nowhere, in a corner, in full, nowhere.
    void show_next();
    OutsideFrom from() const { return from_; }
    void change_side() { from_ = from_ == OutsideFrom::above ? OutsideFrom::behind : OutsideFrom::above; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// Puts it into the frame, which holds the player's view. Draws nothing where it is shown nowhere.
    /// threads: to draw with, >= 1. Cost: that of OutsideRenderer.
    void draw(Overlay& overlay, Frame& frame, OutsideRenderer& renderer, const Snapshot& snapshot, const View& view,
              std::size_t threads);

private:
    Shown shown_ = Shown::nowhere;
    OutsideFrom from_ = OutsideFrom::above;
    int zoom_steps_ = 0;
    Frame large_, inset_;
};

// The game with all that belongs to it.

struct PlayOptions {
    bool mute = false;               ///< no sound device is opened
    std::string tape;                ///< where to record to; empty: nowhere
    std::string save;                ///< where F5 saves to and F9 loads from; empty: there is no place for it
    std::string note;                ///< what the player should know at the beginning; empty: nothing
    std::vector<std::string> dials;  ///< "NAME=VALUE", as set_dial() takes them, beside the settings; a renderer that
                                     ///< has not all is drawn by those that it has
};

/// Plays until the player leaves. Fixed ticks; drawing is interpolated between them and as often as the settings say,
/// and left out where it would show nothing new.
class PlayLoop {
public:
    /// renderer: of the game's map; null: one is made, as the settings say.
    PlayLoop(Game& game, Window& window, SettingsStore& store, const PlayOptions& options,
             std::unique_ptr<Renderer> renderer = nullptr);

    /// Runs until the end; an error where the window fails or the tape cannot be written. Where the game cannot go on,
    /// it is saved first, and the error says where.
    Result<void> run();

    /// Whether it ended because the player wants to see the title screen.
    bool is_left_for_title() const { return to_title_; }

private:
    /// All of run() but what has to be done when it breaks off.
    Result<void> play();
    /// Why the game cannot go on, and where it was saved.
    Error save_what_was_played(const Error& why);
    void begin();
    void handle(const InputEvent& event);
    /// Away from the window the game stands still, if the player wishes.
    void change_focus(bool focused);
    void press(Control control);
    void press_gamepad(GamepadButton button);
    /// Whether the event moved the automap, which is open.
    bool move_automap(const InputEvent& event);
    /// With Control the field of view, else zoom(). steps > 0: nearer.
    void turn_wheel(int steps);
    /// The automap's zoom while it is open, else that of the view from outside.
    void zoom(int steps);
    void obey(const MenuChoice& choice);
    void open_menu();
    void close_menu();
    /// They hold from now on, and are kept.
    void change_settings(Settings settings);
    const Settings& settings() const { return store_.now(); }
    /// Whether the world stands still: in the menu, and when a map lies behind one.
    bool is_paused() const { return menu_.is_open() || end_.has_value(); }
    /// As long as nobody does anything, there is less to look for.
    void set_pace(std::int64_t now);
    void look_for_changes(std::int64_t now);
    void reload();
    /// Opens the sound device if the map calls for it.
    void begin_sounds();
    void hear();
    /// Sound is what one can play without.
    void play_without_sound(const Error& why);
    void save_game();
    void load_game();
    /// Tells what has come to be known, and goes on in the next map where this one was left.
    void follow_events();
    void follow_health(std::int64_t now);
    /// Shows how it went, and from there goes on.
    void leave_map();
    void enter_next_map();
    /// From the column to the stencil renderer or back; false, with a notice, where there is no OpenGL.
    bool change_renderer();
    /// Draws the map that is played now by a renderer of this kind; none is left where it cannot be had.
    Result<void> use_renderer(RendererKind kind);
    /// The same; where it cannot be had, with a notice, by the column renderer.
    void use_or_replace(RendererKind kind);
    /// After another map was loaded: by a renderer of the same kind or, with a notice, by the column renderer.
    void draw_another_map();
    View view_now(double part) const;
    /// With the bob of one who walks, and lower where one is dead.
    void sway(View& view, double part) const;
    /// Leaves the body, or comes back to it.
    void fly_or_land();
    /// Whether the eye is somewhere that renderers can look from: always, unless one flies.
    bool is_in_room(double part);
    /// What the free camera sees where it is in no room: the rooms from outside, and the body's view in them.
    void draw_surroundings(double part);
    Result<void> try_to_draw(double part);
    /// Draws the view, by the other renderer where this one fails.
    Result<void> draw_view(double part);
    /// Whether the picture may stay on the graphics card.
    bool is_on_card(double part);
    /// Lets as many ticks pass as time has; none while paused, and the picture then stands still, too.
    void pass_time(std::int64_t now);
    /// The automap learns what is in the picture.
    void remember_seen(std::int64_t now);
    PixelSize picture_size() const;
    /// Whether a picture would show anything new.
    bool is_worth_showing(double part);
    void note_drawn(double part);
    Result<void> show(std::int64_t now);
    /// Waits until the picture is due, and shows it.
    Result<void> present();
    void draw_over(double part);
    void draw_automap(Overlay& overlay, const View& view);
    /// What is written at the lower edge, and over the middle.
    void draw_words(Overlay& overlay, const View& view, double part);
    /// The row at which it begins.
    int draw_facts(Overlay& overlay, const View& view, double part);
    /// F7: what is in the middle of the picture, or under the mouse where that is free; over the menu while it is open.
    /// bottom : the row above which it is written; the row at which it begins
    int draw_pixel_text(Overlay& overlay, const View& view, double part, int bottom);
    void take_screenshot();
    /// Says so where the recording could not be written on.
    void follow_recording();
    /// Shows a notice for a while.
    void tell(const std::string& text);
    void tell_warnings();
    double now_s() const;
    /// How much of the present tick has passed, 0..1.
    std::int64_t tick_ns() const;
    double part_of_tick(std::int64_t now) const;

    static constexpr std::int64_t kBetweenLooks = 250'000'000;  ///< at the map's files, and at what the map shows [ns]

    Game& game_;
    Window& window_;
    SettingsStore& store_;
    PlayOptions options_;
    std::unique_ptr<Renderer> renderer_;                 ///< of the map that is played; null: none could be made
    std::unique_ptr<OutsideRenderer> outside_renderer_;  ///< of the same map
    std::optional<Stillness> stillness_;                 ///< of the same map
    RendererKind drawn_by_ = RendererKind::column;
    std::optional<RendererKind> untilted_renderer_;  ///< the one before true pitch was wanted
    Font font_;
    Frame frame_;                       ///< the picture; while that stays on the card, what lies over it
    std::optional<GlPicture> on_card_;  ///< the picture, if it stayed there
    PlayerInput input_;
    Menu menu_;
    std::optional<MapEnd> end_;  ///< while it is shown
    Notices notices_;
    OutsideView outside_;
    std::optional<FreeCamera> free_camera_;  ///< while one flies
    bool was_cut_short_ = false;             ///< the last picture was
    Soundscape sounds_;
    FrameTimes times_;
    Pacing pacing_;
    std::optional<View> last_view_;  ///< of the last picture
    std::int64_t started_ns_ = 0, passed_until_ns_ = 0, ticked_until_ns_ = 0, looked_ns_ = 0, remembered_ns_ = 0,
                 acted_ns_ = 0, hurt_ns_ = 0, died_ns_ = 0, began_ns_ = 0;
    double hurt_ = 0;                ///< how much, when one last was, 0..1
    int last_health_ = kFullHealth;  ///< when it was last looked at
    std::uint64_t told_ = 0;         ///< tick of the message that was told last
    std::size_t rewound_ticks_ = 0;  ///< since R is held
    bool rewinding_ = false;
    MouseMotion mouse_;  ///< the last one
    bool keys_open_ = false, readout_open_ = false, pixel_text_open_ = false, screenshot_wanted_ = false, quit_ = false,
         to_title_ = false, is_changed_ = true;
};

}  // namespace enfilade
