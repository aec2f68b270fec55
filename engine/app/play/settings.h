// What a player may set, and the one table from which the menu, the settings file and the options of `play` are made.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/options.h"
#include "base/finding.h"
#include "base/result.h"
#include "formats/dials.h"
#include "formats/script.h"
#include "map/map.h"
#include "platform/input_event.h"

namespace enfilade {

// What keys can do, and which ones do it.

/// In the order in which the menu lists them.
enum class Control : std::uint8_t {
    forward,
    back,
    step_left,
    step_right,
    turn_left,
    turn_right,
    look_up,
    look_down,
    look_ahead,
    run,
    slowly,
    crouch,
    use,
    rewind,
    automap,
    zoom_in,
    zoom_out,
    save,
    load,
    show_keys,
    change_renderer,
    readout,
    outside,
    outside_side,
    pixel,
    fly,
    fullscreen,
    screenshot
};
inline constexpr int kControls = static_cast<int>(Control::screenshot) + 1;

/// Two keys for each control; unknown: none.
using ControlKeys = std::array<KeyCode, 2>;
using Bindings = std::array<ControlKeys, kControls>;

struct ControlInfo {
    std::string_view name;   ///< in the settings file: "step_left"
    std::string_view label;  ///< in the menu: "Step left"
    ControlKeys usual;
};
const ControlInfo& info_of(Control control);
/// None where there is none of that name.
std::optional<Control> control_named(std::string_view name);

Bindings usual_bindings();

inline const ControlKeys& keys_for(const Bindings& bindings, Control control) {
    return bindings[static_cast<std::size_t>(control)];
}

/// "E, Space"; "none" where no key does it.
std::string keys_text(const ControlKeys& keys);

/// The key does this from now on, and nothing else: it takes the place of the first key, and that of the second.
void bind(Bindings& bindings, Control control, KeyCode key);

// The settings.

/// Which colours the automap's lines have: those of today, or some that all eyes tell apart.
enum class AutomapColors : std::uint8_t { usual, safe };

/// The promises that have a name (formats/dials.h).
enum class NamedAccuracy : std::uint8_t { exact, fine, fast };

/// Which texels the column renderer shows (formats/dials.h). as_map: without glitter in the distance, but as painted
/// in maps of Doom's light, whose pictures are looked at as they are.
enum class TextureFilter : std::uint8_t { as_map, nearest, mip, bilinear, trilinear };

struct Settings {
    RendererKind renderer = RendererKind::column;
    double samples = 1;                             ///< rays along each side of a pixel, 1..kMostSamples
    NamedAccuracy accuracy = NamedAccuracy::exact;  ///< by the column renderer, as is the next
    TextureFilter sampling = TextureFilter::as_map;
    std::optional<PictureSize> size;  ///< of the picture, scaled to the window; none: as large as the window
    double scale = 1;                 ///< without a size: pixels of the window along each side of one of the picture
    bool fullscreen = false;
    bool vsync = true;
    double frame_limit = 0;  ///< pictures in a second; 0: as often as the display shows
    double fov_degrees = 90;
    bool true_pitch = false;  ///< looking up and down turns the picture where the renderer can, else its horizon shifts
    double brightness = 1;    ///< the exponent of the light is 1 / brightness
    double view_bob = 0.5;    ///< how far the view goes up and down as one walks, 0..1
    double mouse_speed = 1;   ///< factor
    bool invert_mouse = false;
    double volume = 1;  ///< of all sounds, 0..1
    AutomapColors automap_colors = AutomapColors::usual;
    bool pause_when_away = true;  ///< the menu opens when the window loses the focus
    Bindings bindings = usual_bindings();
};

/// What a renderer is told of them. kind: of the renderer that is.
Dials dials_of(const Settings& settings, RendererKind kind, const Map& map);

// Beyond these fields of view nobody finds the way: a keyhole, and all of it at the rim.
inline constexpr double kSmallestFov = 10, kLargestFov = 160;  ///< [degrees]

/// One row of the table. Values are texts: numbers, "on" and "off", or words.
struct Setting {
    std::string_view name;               ///< in the settings file: "mouse_speed"; its option is --mouse-speed
    std::string_view label;              ///< in the menu
    std::string_view help;               ///< what it does, as a sentence without its end
    double low = 0, high = 0, step = 0;  ///< of numbers
    std::string (*text)(const Setting&, const Settings&) = nullptr;
    /// An error that says what was expected leaves the settings as they are.
    Result<void> (*read)(const Setting&, std::string_view text, Settings&) = nullptr;
    /// Goes on by so many steps: numbers stay within their ends, words begin again.
    void (*turn)(const Setting&, int steps, Settings&) = nullptr;
    bool is_word = false;  ///< whether a file has the text in quotes
    bool is_flag = false;  ///< whether its option may stand without a value
};

/// All but the keys, in the order in which menu, file and help show them.
std::span<const Setting> all_settings();

/// The row of that name; it must be there.
const Setting& setting_named(std::string_view name);

/// "--mouse-speed".
std::string option_of(const Setting& setting);

/// The values in which `now` differs from `before`, in `kept` as well.
void keep_changes(const Settings& before, const Settings& now, Settings& kept);

// Where the settings are kept from one start of the program to the next: a TOML file with a comment for every key.

/// Lines of keys that nobody knows: another version may.
struct UnknownKeys {
    std::string settings, keys;  ///< at the top of the file, and in its table [keys]
    bool operator==(const UnknownKeys&) const = default;
};

/// A text as settings, and what is wrong with it. What is wrong or missing is as usual.
struct SettingsReading {
    Settings settings;
    Findings findings;
    UnknownKeys unknown;
};
SettingsReading read_settings(std::string_view text);

/// The whole file: every key with what it does.
std::string write_settings(const Settings& settings, const UnknownKeys& unknown = {});

/// settings.toml in the user's folder for configuration (app/user_folders.h); empty where there is none.
std::string settings_path();

/// The settings of a player: those that are kept, and those that hold now, which options may have changed.
class SettingsStore {
public:
    /// Nothing is read, and nothing kept.
    SettingsStore() = default;
    /// Reads the file where there is one. path : empty: nothing is read, and nothing kept
    explicit SettingsStore(std::string path);

    /// What the player should know of the file: sentences, none where all is well.
    const std::vector<std::string>& notes() const { return notes_; }

    const Settings& now() const { return now_; }
    /// For this start of the program only.
    void change_for_now(const Settings& settings) { now_ = settings; }
    /// They hold now; what changed is kept by the next save().
    void change(const Settings& settings);

    /// Writes what changed, where something did. A file with errors is first set aside (set_aside(), base).
    Result<void> save();

private:
    std::string path_;
    Settings now_, kept_;
    UnknownKeys unknown_;
    std::vector<std::string> notes_;
    bool is_damaged_ = false, is_changed_ = false;
};

}  // namespace enfilade
