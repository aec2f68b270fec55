// What a player may change while playing.
#pragma once
#include <algorithm>
#include <cmath>

namespace enfilade {

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

}  // namespace enfilade
