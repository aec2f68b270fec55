// What `enfilade` alone opens: the title screen, from which one goes into a map.
#pragma once
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/draw/overlay.h"
#include "app/play/map_list.h"
#include "app/play/menu.h"
#include "app/play/pacing.h"
#include "app/play/readout.h"
#include "app/play/settings.h"
#include "platform/input_event.h"
#include "platform/window.h"

namespace enfilade {

// Its page of maps: a picture and a name for each, in rows.

/// What choosing on the page asks for.
enum class MapPageAction : std::uint8_t { none, leave, choose };

class MapPage {
public:
    bool is_open() const { return is_open_; }
    void open() { is_open_ = true; }
    void close() { is_open_ = false; }
    void set_maps(std::vector<ListedMap> maps);
    /// Goes to the map of that path, if there is one.
    void choose(const std::string& path);

    /// Ignores everything while closed.
    MapPageAction handle(const InputEvent& event);
    /// The one that was chosen; there is one after `choose`.
    const ListedMap& chosen() const { return maps_[static_cast<std::size_t>(chosen_)]; }

    /// note : below the maps, instead of what is said about the chosen one; may be empty. Draws nothing while closed.
    void draw(Overlay& overlay, MapPictures& pictures, const std::string& note);

private:
    struct MapBox {
        Rect area;
        int map;
    };
    MapPageAction press(KeyCode key);
    MapPageAction press(GamepadButton button);
    MapPageAction choose() const { return maps_.empty() ? MapPageAction::none : MapPageAction::choose; }
    void move(int steps);
    int map_at(double x, double y) const;
    void draw_map(Overlay& overlay, const ListedMap& map, const Rect& area, bool is_chosen, MapPictures& pictures);

    std::vector<ListedMap> maps_;
    std::vector<MapBox> boxes_;  ///< of the maps that were drawn last
    int chosen_ = 0, columns_ = 1;
    bool is_open_ = false;
};

// The screen itself.

/// Where the title screen was left to.
struct TitleChoice {
    std::string map;       ///< empty: out of the program
    bool goes_on = false;  ///< with the game that was played last, instead of from the start
};

class TitleScreen {
public:
    /// note : what the player should know, e.g. why a map could not be opened; may be empty
    TitleScreen(Window& window, SettingsStore& store, const std::string& note);

    /// Until the player has chosen. An error where the window fails.
    Result<TitleChoice> run();

private:
    void handle(const InputEvent& event);
    void obey(const MenuChoice& choice);
    void choose_map(const ListedMap& map);
    void change_settings(const Settings& changed);
    /// Whether something came that the picture does not show yet.
    bool has_news();
    Result<void> show();
    /// The tour's first view, as large as the window.
    void draw_background();

    Window& window_;
    SettingsStore& store_;
    Font font_;
    Frame background_, frame_;
    Menu menu_;
    MapPage maps_;
    MapPictures pictures_;
    std::size_t shown_pictures_ = 0;
    std::future<Result<std::string>> conversion_;  ///< of a WAD, while it lasts: the first level
    std::string note_;                             ///< at the foot of the page of maps
    Notices notices_;
    Pacing pacing_;
    TitleChoice choice_;
    bool is_over_ = false, is_changed_ = true;
};

}  // namespace enfilade
