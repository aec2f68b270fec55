// Angles as binary fractions of a turn, with sines of our own: the same bits on every machine.
#pragma once
#include <cstdint>

#include "math/vec.h"

namespace enfilade {

/// An angle: 2^32 steps make a full turn, so it wraps by itself and quarter turns are exact. One step is 8.4e-8
/// degrees. As a yaw, 0 looks along +x and growing values turn right.
struct Angle {
    std::uint32_t steps = 0;

    /// The nearest step; any finite number of degrees, also negative or beyond a turn.
    static Angle from_degrees(double degrees);
    static Angle from_radians(double radians);
    /// In [0, 360).
    double degrees() const { return steps * (360.0 / 4294967296.0); }

    constexpr bool operator==(const Angle&) const = default;
};

/// Beyond a full turn, and below none, the angle goes round.
constexpr Angle operator+(Angle a, Angle b) { return {a.steps + b.steps}; }
constexpr Angle operator-(Angle a, Angle b) { return {a.steps - b.steps}; }

/// (cos, sin) of the angle: the direction a yaw looks in. Each within 2^-52 of the true value; exact at the
/// quarter turns; at odd multiples of 45 degrees both have exactly the same size.
Vec2 direction(Angle angle);

/// tan of the angle in (-90, 90) degrees: sin / cos of direction(). At a right angle it is infinite, of whatever sign.
double tangent(Angle angle);

/// The fraction of a full turn, in [0, 1), by which `v` is turned right from +x. Error below 1e-15 turn.
/// v = (0, 0) gives 0.
double turn_of(Vec2 v);

/// The nearest Angle to the direction of `v`: exact along the axes. v = (0, 0) gives 0.
Angle angle_of(Vec2 v);

/// The angle of a unit vector in steps of 2^-64 turn, for what is added up very often: within 1e-15 radians of the
/// true value, exact along the axes, and that of (x, -y) is exactly the opposite of that of (x, y).
std::uint64_t fine_turn_of(Vec2 unit);

}  // namespace enfilade
