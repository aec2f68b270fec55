// What a sector's sun adds to the light of its surfaces: worked out once for each, the same all over it.
#pragma once
#include <cmath>

#include "math/predicates.h"
#include "render/light_patch.h"

namespace enfilade {

/// Of the sector's sun, as much as falls on what takes `part` of it, 0..1. None where it has no sun.
inline LampColor sunlight(const Map& map, SectorId sector, double part) {
    if (!map[sector].sun || part <= 0) return {};
    const Sun& sun = map[map[sector].sun];
    return color_of_light(sun.color, sun.brightness * part);
}

/// By the angle between the way to the sun and the wall's normal; none on what faces away.
inline LampColor sunlight_on(const Map& map, const Wall& wall) {
    if (!map[wall.sector].sun) return {};
    return sunlight(map, wall.sector, dot(right_of(wall.b - wall.a), map[map[wall.sector].sun].level) / wall.length);
}

/// Panels are so thin that both sides have the light of either.
inline LampColor sunlight_on(const Map& map, const Panel& panel) {
    if (!map[panel.sector].sun) return {};
    const Vec2 to_sun = map[map[panel.sector].sun].level;
    return sunlight(map, panel.sector, std::fabs(dot(right_of(panel.b - panel.a), to_sun)) / panel.length);
}

/// By the sun's elevation.
inline LampColor sunlight_on_floor(const Map& map, SectorId sector) {
    return map[sector].sun ? sunlight(map, sector, map[map[sector].sun].up) : LampColor{};
}

/// A picture that faces whoever looks takes all of it, as it does of lamps.
inline LampColor sunlight_on(const Map& map, const Thing& thing) { return sunlight(map, thing.sector, 1); }

/// A grid with the sun added everywhere; of an empty one, a grid that has nothing else. The same where there is no sun.
LightGrid in_sun(LightGrid grid, const LampColor& sun);

}  // namespace enfilade
