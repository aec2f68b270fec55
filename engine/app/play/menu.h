// The menu behind Escape: driven by keyboard, mouse or gamepad, drawn over the picture.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "app/draw/overlay.h"
#include "platform/input_event.h"

namespace enfilade {

// What a player may change while playing.

struct PlaySettings {
    double fov_degrees = 90;  ///< horizontal, kSmallestFov..kLargestFov
    double mouse_speed = 1;   ///< factor, kSlowestMouse..kFastestMouse
    bool fullscreen = false;
    double volume = 1;             ///< of all sounds, 0..1
    bool pauses_unfocused = true;  ///< the menu opens when the window loses the focus
    bool true_pitch = false;  ///< looking up and down turns the picture where the renderer can, else its horizon shifts
};

// The ends and steps of the menu's sliders.
// Beyond these fields of view nobody finds the way: a keyhole, and all of it at the rim.
inline constexpr double kSmallestFov = 10, kLargestFov = 160, kFovStep = 5;        ///< [degrees]
inline constexpr double kSlowestMouse = 0.2, kFastestMouse = 5, kMouseStep = 0.2;  ///< [1]
inline constexpr double kVolumeStep = 0.1;                                         ///< [1]

/// One step along a slider, staying on whole steps, low..high.
inline double slide(double value, int steps, double step, double low, double high) {
    return std::clamp((std::round(value / step) + steps) * step, low, high);
}

/// steps > 0: sees more.
inline void widen_view(PlaySettings& settings, int steps) {
    settings.fov_degrees = slide(settings.fov_degrees, steps, kFovStep, kSmallestFov, kLargestFov);
}

/// What choosing in the menu asks the game to do.
enum class MenuAction : std::uint8_t { none, resume, restart, settings_changed, quit };

class Menu {
public:
    bool is_open() const { return open_; }
    /// Opens with the first entry chosen.
    void open();
    void close() { open_ = false; }

    /// Takes one event; changes settings where it moves a slider. Ignores everything while closed.
    MenuAction handle(const InputEvent& event, PlaySettings& settings);

    /// The scale at which all of the menu fits into a picture of this height.
    static int scale_for(int height_px);

    /// Remembers where the entries are, so that the mouse can point at them. Draws nothing while closed.
    void draw(Overlay& overlay, const PlaySettings& settings);

private:
    enum class MenuEntry : std::uint8_t {
        resume,
        restart,
        fov,
        mouse_speed,
        fullscreen,
        true_pitch,
        volume,
        pause,
        quit
    };
    static constexpr int kEntries = 9;

    MenuAction handle_key(KeyCode key, PlaySettings& settings);
    MenuAction handle_button(GamepadButton button, PlaySettings& settings);
    MenuAction handle_click(const MouseButtonChange& click, PlaySettings& settings);
    MenuAction choose(PlaySettings& settings);
    MenuAction adjust(int steps, PlaySettings& settings);
    void move(int steps);
    /// The entry under a point, or -1.
    int entry_at(double x, double y) const;
    static std::string label(MenuEntry entry, const PlaySettings& settings);

    bool open_ = false;
    int chosen_ = 0;
    std::array<Rect, kEntries> boxes_{};
};

}  // namespace enfilade
