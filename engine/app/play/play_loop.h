// Playing: the window, the game and what is drawn over it, sixty ticks a second.
#pragma once
#include <optional>
#include <string>

#include "app/options.h"
#include "app/play/game.h"
#include "app/play/menu.h"
#include "app/play/outside_view.h"
#include "app/play/readout.h"
#include "app/sounds.h"
#include "flight/renderer.h"
#include "platform/window.h"

namespace enfilade {

struct PlayOptions {
    RendererKind renderer = RendererKind::column;
    std::optional<PictureSize> size;  ///< of the picture, scaled to the window; none: as large as the window
    bool fullscreen = false;
    bool true_pitch = false;  ///< the stencil renderer turns its picture when the player looks up or down
    bool mute = false;        ///< no sound device is opened
    std::string tape;         ///< where to record to; empty: nowhere
    std::string save;         ///< where F5 saves to and F9 loads from
};

/// Plays until the player quits. Fixed ticks; drawing is interpolated between them and as often as the display shows.
class PlayLoop {
public:
    /// renderer: of the game's map.
    PlayLoop(Game& game, Window& window, const PlayOptions& options, std::unique_ptr<Renderer> renderer);

    /// Runs until the end; an error where the window fails or the tape cannot be written. Where the game cannot go on,
    /// it is saved first, and the error says where.
    Status run();

private:
    /// All of run() but what has to be done when it breaks off.
    Status play();
    /// Why the game cannot go on, and where it was saved.
    Error save_what_was_played(const Error& why);
    void handle(const InputEvent& event);
    /// Away from the window the game stands still, if the player wishes.
    void change_focus(bool focused);
    void handle_key(KeyCode key);
    void handle_gamepad(GamepadButton button);
    /// With Control the field of view, else zoom(). steps > 0: nearer.
    void turn_wheel(int steps);
    /// The automap's zoom while it is open, else that of the view from outside.
    void zoom(int steps);
    void obey(MenuAction action);
    void open_menu();
    void close_menu();
    void apply_settings();
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
    void leave_map();
    /// From the column to the stencil renderer or back; false, with a notice, where there is no OpenGL.
    bool change_renderer();
    /// Draws the map that is played now by a renderer of this kind.
    Status use_renderer(RendererKind kind);
    /// After another map was loaded: by a renderer of the same kind or, with a notice, by the column renderer.
    void draw_another_map();
    View view_now(double part) const;
    /// Leaves the body, or comes back to it.
    void fly_or_land();
    /// Whether the eye is somewhere that renderers can look from: always, unless one flies.
    bool is_in_room(double part);
    /// What the free camera sees where it is in no room: the rooms from outside, and the body's view in them.
    void draw_surroundings(double part);
    Status try_to_draw(double part);
    /// Draws the view, by the other renderer where this one fails.
    Status draw_view(double part);
    /// Lets as many ticks pass as time has; none while the menu is open, and the picture then stands still, too.
    void pass_time(std::int64_t now);
    /// The automap learns what is in the picture.
    void remember_seen(std::int64_t now);
    Status show(std::int64_t now);
    void draw_over(double part);
    /// F7: what is in the middle of the picture, or under the mouse where that is free; over the menu while it is open.
    void draw_pixel_text(Overlay& overlay, const View& view, double part);
    void take_screenshot();
    /// Says so where the recording could not be written on.
    void follow_recording();
    /// Shows a notice for a while.
    void tell(const std::string& text);
    double now_s() const;
    /// How much of the present tick has passed, 0..1.
    double part_of_tick(std::int64_t now) const;

    static constexpr std::int64_t kBetweenLooks = 250'000'000;  ///< at the map's files, and at what the map shows [ns]

    Game& game_;
    Window& window_;
    PlayOptions options_;
    std::unique_ptr<Renderer> renderer_;                 ///< of the map that is played; null: none could be made
    std::unique_ptr<OutsideRenderer> outside_renderer_;  ///< of the same map
    Font font_;
    Frame frame_;
    PlaySettings settings_;
    PlayerInput input_;
    Menu menu_;
    Notices notices_;
    OutsideView outside_;
    std::optional<FreeCamera> free_camera_;  ///< while one flies
    bool was_cut_short_ = false;             ///< the last picture was
    Soundscape sounds_;
    FrameTimes times_;
    std::int64_t started_ns_ = 0, passed_until_ns_ = 0, ticked_until_ns_ = 0, looked_ns_ = 0, remembered_ns_ = 0;
    std::uint64_t told_ = 0;         ///< tick of the message that was told last
    std::size_t rewound_ticks_ = 0;  ///< since R is held
    bool rewinding_ = false;
    MouseMotion mouse_;  ///< the last one
    bool keys_open_ = false, readout_open_ = false, pixel_text_open_ = false, screenshot_wanted_ = false, quit_ = false;
};

}  // namespace enfilade
