// What a player may change while playing.
#pragma once

namespace enfilade {

struct PlaySettings {
    double fov_degrees = 90;  ///< horizontal, kSmallestFov..kLargestFov
    double mouse_speed = 1;   ///< factor, kSlowestMouse..kFastestMouse
    bool fullscreen = false;
    double volume = 1;        ///< of all sounds, 0..1
    bool true_pitch = false;  ///< looking up and down turns the picture where the renderer can, else its horizon shifts
};

// The ends and steps of the menu's sliders.
inline constexpr double kSmallestFov = 50, kLargestFov = 140, kFovStep = 5;        ///< [degrees]
inline constexpr double kSlowestMouse = 0.2, kFastestMouse = 5, kMouseStep = 0.2;  ///< [1]
inline constexpr double kVolumeStep = 0.1;                                         ///< [1]

}  // namespace enfilade
