#include "render/shade.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

// render/stencil/shaders.cpp says both models once more, in the graphics card's language.

constexpr double kClassicLevels = 32;   ///< COLORMAP's levels from full to black
constexpr double kClassicLights = 32;   ///< steps of sector light, of two levels each; contrast moves by two
constexpr double kClassicDepth = 40;    ///< levels won back at 1 m: 1280 map units / 32
constexpr double kClassicNearest = 23;  ///< most levels that are won back, as for Doom's walls
constexpr double kReachAtHalf = 9;      ///< smooth: depth at which light 1/2 has halved [m]; chosen by eye
constexpr double kFarthest = 1e9;       ///< stands for infinity, which times 0 would be no number [m]

Shade classic(double light, double contrast, double depth) {
    const double step = contrast < 1 ? -2 : contrast > 1 ? 2 : 0;  // walls along x darker, along y brighter
    const double number = std::clamp(std::floor(light * kClassicLights) + step, 0.0, kClassicLights - 1);
    const double won = std::min(std::floor(on_nearest_step(kClassicDepth / std::max(depth, 0.01))), kClassicNearest);
    const double level = 2 * (kClassicLights - 2 - number) - won;
    return static_cast<Shade>((kClassicLevels - std::clamp(level, 0.0, kClassicLevels - 1)) * (256 / kClassicLevels));
}

Shade smooth(double light, double contrast, double depth) {
    // 1 / reach: 0 at full light, 1 / kReachAtHalf at half light.
    const double nearness = (1 - light) * 2 / kReachAtHalf * std::min(depth, kFarthest);
    const double falloff = 1 / (1 + nearness * nearness);
    return static_cast<Shade>(256 * std::min(light * contrast, 1.0) * falloff + 0.5);
}

}  // namespace

Shade shade_at(LightModel model, double light, double contrast, double depth) {
    light = std::clamp(light, 0.0, 1.0);
    return model == LightModel::classic ? classic(light, contrast, depth) : smooth(light, contrast, depth);
}

Mist mist_at(double reach, double depth) {
    if (reach == 0) return 0;
    const double part = std::min(depth, kFarthest) / reach;
    return static_cast<Mist>(256 * (1 - 1 / (1 + part * part)) + 0.5);
}

double fraction(double tiles) {
    const double f = tiles - std::floor(tiles);
    return f < 1 ? f : 0;
}

SkyTexel sky_texel(Vec2 tile, Vec2 offset_tiles, double turns, double elevation) {
    return {fraction(turns * tile.x - offset_tiles.x), std::clamp(1 - elevation / tile.y - offset_tiles.y, 0.0, 1.0)};
}

}  // namespace enfilade
