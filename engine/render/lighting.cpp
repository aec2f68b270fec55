#include "render/lighting.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
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

SkyTexel sky_texel(Vec2 tile, Vec2 offset_tiles, double turns, double elevation, SkyRows rows) {
    const double u = fraction(turns * tile.x - offset_tiles.x), v = 1 - elevation / tile.y - offset_tiles.y;
    if (rows == SkyRows::round) return {u, std::clamp(v, 0.0, 1.0)};
    return {u, fraction(std::clamp(v, 0.0, last_of_sky(rows)))};
}

namespace {

// render/stencil/shaders.cpp says both models once more, in the graphics card's language.

constexpr double kClassicLights = 32;  ///< steps of sector light, of two levels each; contrast moves by two
constexpr double kReachAtHalf = 9;     ///< smooth: depth at which light 1/2 has halved [m]; chosen by eye

/// Levels of a classic surface that is far away.
int levels_far_away(double light, double contrast) {
    const double step = contrast < 1 ? -2 : contrast > 1 ? 2 : 0;  // walls along x darker, along y brighter
    const double number = std::clamp(std::floor(light * kClassicLights) + step, 0.0, kClassicLights - 1);
    return 2 * (static_cast<int>(kClassicLights) - 2 - static_cast<int>(number));
}

}  // namespace

Dimming::Dimming(LightModel model, double light, double contrast) : model_(model) {
    light = std::clamp(light, 0.0, 1.0);
    dark_levels_ = levels_far_away(light, contrast);
    per_metre_ = (1 - light) * 2 / kReachAtHalf;
    brightest_ = kFull * std::min(light * contrast, 1.0);
}

void Dimming::at_all(const double* depths, int count, Shade* shades) const {
    if (model_ == LightModel::classic)
        for (int i = 0; i < count; ++i) shades[i] = classic(depths[i]);
    else
        for (int i = 0; i < count; ++i) shades[i] = smooth(depths[i]);
}

namespace {

std::uint32_t sum_of(std::uint32_t lane, float light) {
    return static_cast<std::uint32_t>(
        std::min(static_cast<float>(lane) + light + 0.5f, static_cast<float>(kMostLight)));
}

}  // namespace

LightGrid in_sun(LightGrid grid, const LampColor& sun) {
    if (sun == LampColor{}) return grid;
    if (grid.columns == 0) grid = {0, 0, kUsualLightPoints, 2, 2, std::vector<LightCell>(4)};
    for (LightCell& cell : grid.cells)
        cell = light_cell(sum_of(lane(cell, 0), sun.red), sum_of(lane(cell, 1), sun.green),
                          sum_of(lane(cell, 2), sun.blue));
    grid.is_dark_before_u = grid.is_dark_after_u = grid.is_dark_before_v = grid.is_dark_after_v = false;
    return grid;
}

}  // namespace enfilade
