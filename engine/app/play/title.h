// What `enfilade` alone opens: the title screen, from which one goes into a map.
#pragma once
#include <future>
#include <string>

#include "app/draw/overlay.h"
#include "app/play/map_page.h"
#include "app/play/menu.h"
#include "app/play/pacing.h"
#include "app/play/readout.h"
#include "app/play/settings_file.h"
#include "platform/window.h"

namespace enfilade {

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
    std::future<Result<void>> conversion_;  ///< of a WAD, while it lasts
    std::string wad_;                       ///< the one that is, or was last, converted
    std::string note_;                      ///< at the foot of the page of maps
    Notices notices_;
    Pacing pacing_;
    TitleChoice choice_;
    bool is_over_ = false, is_changed_ = true;
};

}  // namespace enfilade
