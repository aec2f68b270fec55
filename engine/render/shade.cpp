#include "render/shade.h"

#include <algorithm>
#include <cmath>

#include "render/lighting.h"

namespace enfilade {
namespace {

constexpr double kFarthest = 1e9;  ///< stands for infinity, which times 0 would be no number [m]

}  // namespace

Shade shade_at(LightModel model, double light, double contrast, double depth) {
    return Dimming(model, light, contrast).at(depth);
}

FogPart fog_part_at(double reach, double depth) {
    if (reach == 0) return 0;
    const double part = std::min(depth, kFarthest) / reach;
    return static_cast<FogPart>(256 * (1 - 1 / (1 + part * part)) + 0.5);
}

double fraction(double tiles) {
    const double f = tiles - std::floor(tiles);
    return f < 1 ? f : 0;
}

SkyTexel sky_texel(Vec2 tile, Vec2 offset_tiles, double turns, double elevation) {
    return {fraction(turns * tile.x - offset_tiles.x), std::clamp(1 - elevation / tile.y - offset_tiles.y, 0.0, 1.0)};
}

}  // namespace enfilade
