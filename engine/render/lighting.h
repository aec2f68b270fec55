// How the light of a room falls on a surface of it, shared by all renderers: chosen once for each surface.
#pragma once
#include <algorithm>
#include <cmath>

#include "map/map.h"
#include "math/predicates.h"
#include "render/light_patch.h"
#include "render/shade.h"

namespace enfilade {

// The light of one surface at many depths: shade_at() with all that does not depend on the depth worked out before.

inline constexpr double kFarthest = 1e9;  ///< stands for an infinite depth, which times 0 would be no number [m]

/// shade_at() of one surface, made ready for many depths.
class Dimming {
public:
    Dimming() = default;
    Dimming(LightModel model, double light, double contrast);

    Shade at(double depth) const { return model_ == LightModel::classic ? classic(depth) : smooth(depth); }

    /// shades[i] of depths[i]; both [count].
    void at_all(const double* depths, int count, Shade* shades) const;

private:
    Shade classic(double depth) const;
    Shade smooth(double depth) const;

    LightModel model_ = LightModel::smooth;
    int dark_levels_ = 0;       ///< classic: where nothing is won back
    double per_metre_ = 0;      ///< smooth: 1 / reach; 0 at full light
    double brightest_ = kFull;  ///< smooth: at depth 0

    static constexpr double kFull = 256;
    static constexpr int kClassicLevels = 32;         ///< COLORMAP's levels from full to black
    static constexpr double kClassicDepth = 40;       ///< levels won back at 1 m: 1280 map units / 32
    static constexpr double kClassicNearest = 23;     ///< most levels that are won back, as for Doom's walls
    static constexpr double kClassicTouching = 0.01;  ///< nearer than this counts as this [m]
};

inline Shade Dimming::classic(double depth) const {
    const double touching = depth > kClassicTouching ? depth : kClassicTouching;
    const double won = on_nearest_step(kClassicDepth / touching);
    const int level = dark_levels_ - static_cast<int>(won < kClassicNearest ? won : kClassicNearest);
    const int seen = level > 0 ? (level < kClassicLevels ? level : kClassicLevels - 1) : 0;
    return static_cast<Shade>((kClassicLevels - seen) * (static_cast<int>(kFull) / kClassicLevels));
}

inline Shade Dimming::smooth(double depth) const {
    const double nearness = per_metre_ * (depth < kFarthest ? depth : kFarthest);
    return static_cast<Shade>(static_cast<int>(brightest_ * (1 / (1 + nearness * nearness)) + 0.5));
}

/// What shade_at() asks of a surface.
struct Lighting {
    LightModel model = LightModel::smooth;
    double light = 1;     ///< 0..1
    double contrast = 1;  ///< as Wall::contrast
};

/// Of a surface in a sector that has this light, 0..1. contrast: Wall::contrast, 1 for flats and things.
inline Lighting lighting_in(const Map& map, SectorId sector, double light, double contrast) {
    if (!map[sector].unlit) return {map.render.light, light, contrast};
    // Full smooth light does not fall off; what contrast leaves of it is then all that is left of the colours.
    return {LightModel::smooth, 1, std::clamp(light, 0.0, 1.0)};
}

inline Dimming dimming_of(const Lighting& lighting) { return {lighting.model, lighting.light, lighting.contrast}; }

/// depth: >= 0 [m], infinity allowed.
inline Shade shade_at(const Lighting& lighting, double depth) {
    return shade_at(lighting.model, lighting.light, lighting.contrast, depth);
}

// What a sector's sun adds to the light of its surfaces: worked out once for each, the same all over it.

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
