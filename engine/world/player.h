// The player: a body with a will and an eye.
#pragma once
#include <cstdint>

#include "map/map.h"
#include "math/angle.h"
#include "space/trace.h"
#include "world/body.h"

namespace enfilade {

/// Everything about the player that the next tick depends on. A plain value.
struct Player {
    Place place;
    double feet_z = 0;                ///< [m]
    Vec2 velocity;                    ///< [m/s]
    double fall_speed = 0;            ///< downward, >= 0 [m/s]
    double height = kStandingHeight;  ///< of the body, between crouched and standing [m]
    double eye_lag = 0;               ///< how far the eye is still above where it goes, after a step [m]
    double eye_z = 0;                 ///< above the map's zero [m]; below every ceiling over the body
    Angle yaw;
    std::uint32_t yaw_rest =
        0;  ///< what links turned it beyond whole steps of yaw, so that nothing adds up [2^-64 turn]
    std::int32_t pitch_steps = 0;  ///< up positive, within ±kMaxPitchSteps [2^-32 turn]
    bool on_ground = true;

    bool operator==(const Player&) const = default;
};

/// How far up and down one can look: 60 degrees. The column renderer shears the picture, which at more than that
/// stretches it beyond recognition.
inline constexpr std::int32_t kMaxPitchSteps = 0x2AAAAAAA;

/// The eye above the feet of a body of this height [m]: 1.55 standing, 0.85 crouched.
double eye_height(double height);

/// How near the eye may come to a ceiling [m]: as near as it is to the top of a crouched head.
inline constexpr double kEyeBelowCeiling = 0.15;

/// Stands the player at the start: on the floor if the eye's height there says so, else above it, to fall. Too near to
/// a wall, it is moved off as far as there is room.
Player player_at(const Instant& now, const PlayerStart& start);

/// The player's body, as wide and high as there is room.
Body body_of(const Instant& now, const Player& player);

/// Where the eye belongs: above the feet, with its lag, below the ceiling.
double eye_z_of(const Player& player, double ceiling_z);

}  // namespace enfilade
