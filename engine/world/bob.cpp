#include "world/bob.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"

namespace enfilade {
namespace {

/// The triangle that goes through the same points as the sine where that is 0, 1 and -1. part: of the period, 0..1.
double triangle(double part) {
    if (part < 0.25) return 4 * part;
    return part < 0.75 ? 2 - 4 * part : 4 * part - 4;
}

double height_of(const Flat& flat, const Boxed<BobRecord>& bob, double time_s) {
    return bob ? flat.z + offset_at(*bob, time_s) : flat.z;
}

}  // namespace

double offset_at(const BobRecord& bob, double time_s) {
    const double periods = time_s / bob.period + bob.phase;
    const double part = periods - std::floor(periods);
    if (bob.shape == BobShape::triangle) return bob.amplitude * triangle(part);
    return bob.amplitude * direction(Angle::from_degrees(part * 360)).y;
}

Heights bobbing_heights(const Sector& sector, double time_s) {
    const double floor_z = height_of(sector.floor, sector.floor_bob, time_s);
    return {floor_z, std::max(floor_z, height_of(sector.ceiling, sector.ceiling_bob, time_s))};
}

}  // namespace enfilade
