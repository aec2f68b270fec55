// The eye between two ticks.
#pragma once
#include "world/world.h"

namespace enfilade {

/// Where the eye is and how it looks.
struct Eye {
    Place place;
    double z = 0;  ///< [m]
    Angle yaw;
    std::int32_t pitch_steps = 0;  ///< up positive [2^-32 turn]
};

/// The player's eye, `part` of the way from the tick before to this one, 0..1. It follows the player through portals
/// and links: place, height and yaw are those of the space that the eye is in at that moment, and its sector contains
/// it. part = 1 is exactly where the player is.
Eye eye_between_ticks(const Map& map, const World& world, double part);

}  // namespace enfilade
