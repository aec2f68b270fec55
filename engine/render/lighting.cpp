#include "render/lighting.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

Shade shade_at(LightModel model, double light, double contrast, double depth) {
    return Dimming(model, light, contrast).at(depth);
}

FogPart fog_part_at(double reach, double depth, FogPart step) {
    if (reach == 0) return 0;
    const double part = std::min(depth, kFarthest) / reach;
    const auto whole = static_cast<FogPart>(256 * (1 - 1 / (1 + part * part)) + 0.5);
    return (whole + step / 2) / step * step;
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

LightGrids::LightGrids(const Map& map, int points_per_m) : map_(map), per_m_(points_per_m) {
    ENFILADE_CHECK(1 <= points_per_m && points_per_m <= kMostLightPoints);
    if (map.lights.empty() && map.suns.empty()) return;
    images_ = LightImages(map);
    memos_.resize(map.walls.size() + map.panels.size() + map.things.size() + map.sectors.size());
}

LightGrids::Memo& LightGrids::memo(std::size_t number) {
    const Held held(lock_);
    if (!memos_[number]) memos_[number] = std::make_unique<Memo>();
    return *memos_[number];
}

void LightGrids::note_sectors(SectorId home, Memo& memo) const {
    memo.sectors = {home};
    for (const LampOnSurface& lamp : memo.lamps) {
        memo.sectors.push_back(map_.lights[lamp.image.light].sector);
        lamp.rays.add_sectors(map_, memo.sectors);
    }
    std::ranges::sort(memo.sectors);
    memo.sectors.erase(std::ranges::unique(memo.sectors).begin(), memo.sectors.end());
}

/// own_height: of a thing; else 0.
bool LightGrids::heights_changed(const Snapshot& snapshot, Memo& memo, double own_height) {
    const std::size_t count = 2 * memo.sectors.size() + 1;
    bool changed = memo.heights.size() != count;
    memo.heights.resize(count);
    const auto note = [&](std::size_t i, double height) {
        changed |= memo.heights[i] != height;
        memo.heights[i] = height;
    };
    for (std::size_t i = 0; i < memo.sectors.size(); ++i) {
        const Heights heights = heights_at(snapshot, memo.sectors[i]);
        note(2 * i, heights.floor_z);
        note(2 * i + 1, heights.ceiling_z);
    }
    note(count - 1, own_height);
    return changed;
}

bool LightGrids::colors_changed(const Snapshot& snapshot, Memo& memo) const {
    bool changed = memo.colors.size() != memo.lamps.size();
    memo.colors.resize(memo.lamps.size());
    for (std::size_t i = 0; i < memo.lamps.size(); ++i) {
        const LampColor color = lamp_color(map_, snapshot, memo.lamps[i].image.light);
        changed |= memo.colors[i] != color;
        memo.colors[i] = color;
    }
    return changed;
}

namespace {

/// That the grid of all lamps covers [m^2].
double area_of(const std::vector<LampOnSurface>& lamps, double per_m) {
    LightBox all;
    for (const LampOnSurface& lamp : lamps) all = box_around(all, lamp.box);
    return all.columns / per_m * (all.rows / per_m);
}

}  // namespace

/// make(image, per_m): the lamp on this surface.
template <class Make>
void LightGrids::note_lamps(std::span<const LightImage> images, Make make, Memo& memo) const {
    for (memo.per_m = per_m_;; memo.per_m /= 2) {
        memo.lamps.clear();
        for (const LightImage& image : images) {
            memo.lamps.push_back(make(image, memo.per_m));
            if (memo.lamps.back().box.columns == 0) memo.lamps.pop_back();
        }
        if (area_of(memo.lamps, memo.per_m) * (memo.per_m * memo.per_m) <= kMostGridArea * (per_m_ * per_m_)) return;
    }
}

/// make: as for note_lamps(). patch(lamp, side): what arrives of it now.
template <class Make, class Patch>
const LightGrid* LightGrids::grid(const Snapshot& snapshot, std::size_t number, SectorId home, int side,
                                  double own_height, const Suns& suns, Make make, Patch patch) {
    const auto images = images_.in(home);
    if (images.empty() && suns == Suns{}) return nullptr;
    Memo& memo = this->memo(number);
    const Held held(memo.lock);
    if (memo.is_new) {
        note_lamps(images, make, memo);
        note_sectors(home, memo);
        memo.is_new = false;
    }
    if (memo.lamps.empty() && suns == Suns{}) return nullptr;
    const bool moved = heights_changed(snapshot, memo, own_height);
    const bool recolored = colors_changed(snapshot, memo);
    for (int s = 0; s < 2 && (moved || recolored); ++s) {
        if (moved) memo.patches[s].clear();
        for (const LampOnSurface& lamp : memo.lamps)
            if (moved) memo.patches[s].push_back(patch(lamp, s));
        memo.grids[s] = in_sun(sum_of(memo.patches[s], memo.colors, memo.per_m), suns[static_cast<std::size_t>(s)]);
    }
    return memo.grids[side].columns > 0 ? &memo.grids[side] : nullptr;
}

namespace {

UprightSurface upright(const Map& map, WallId id) {
    const Wall& wall = map[id];
    return {wall.sector, id, wall.a, wall.b, wall.length};
}
UprightSurface upright(const Map& map, PanelId id) {
    const Panel& panel = map[id];
    return {panel.sector, {}, panel.a, panel.b, panel.length};
}

/// Only the first side of what has but one.
template <class Patch>
auto one_sided(Patch patch) {
    return [=](const LampOnSurface& lamp, int side) { return side == 0 ? patch(lamp) : LightPatch{}; };
}

}  // namespace

const LightGrid* LightGrids::on_wall(const Snapshot& snapshot, WallId id) {
    const UprightSurface surface = upright(map_, id);
    const Heights room = heights_at(snapshot, surface.sector);
    const auto make = [&](const LightImage& image, double per_m) { return lamp_on(map_, surface, image, per_m); };
    const auto patch = [&](const LampOnSurface& lamp) {
        return patch_on(map_, snapshot, surface, lamp, room.floor_z, room.ceiling_z);
    };
    return grid(snapshot, id.index, surface.sector, 0, 0, {sunlight_on(map_, map_[id])}, make, one_sided(patch));
}

const LightGrid* LightGrids::on_panel(const Snapshot& snapshot, PanelId id) {
    const UprightSurface surface = upright(map_, id);
    const Heights room = heights_at(snapshot, surface.sector);
    const double bottom = std::max(map_[id].bottom, room.floor_z), top = std::min(map_[id].top, room.ceiling_z);
    const auto make = [&](const LightImage& image, double per_m) { return lamp_on(map_, surface, image, per_m); };
    const auto patch = [&](const LampOnSurface& lamp) { return patch_on(map_, snapshot, surface, lamp, bottom, top); };
    return grid(snapshot, map_.walls.size() + id.index, surface.sector, 0, 0, {sunlight_on(map_, map_[id])}, make,
                one_sided(patch));
}

const LightGrid* LightGrids::on_thing(const Snapshot& snapshot, ThingId id) {
    const Thing& thing = map_[id];
    const double z = thing_at(map_, snapshot, id).z + thing.height / 2;
    const auto make = [&](const LightImage& image, double) {
        return lamp_on(map_, thing.sector, thing.position, image);
    };
    const auto patch = [&](const LampOnSurface& lamp) { return patch_at(map_, snapshot, thing.position, z, lamp); };
    const std::size_t number = map_.walls.size() + map_.panels.size() + id.index;
    return grid(snapshot, number, thing.sector, 0, z, {sunlight_on(map_, thing)}, make, one_sided(patch));
}

namespace {
constexpr int kFloor = 0, kCeiling = 1;  ///< sides
}

const LightGrid* LightGrids::on_floor(const Snapshot& snapshot, SectorId sector) {
    return on_flat(snapshot, sector, kFloor);
}

const LightGrid* LightGrids::on_ceiling(const Snapshot& snapshot, SectorId sector) {
    return on_flat(snapshot, sector, kCeiling);
}

const LightGrid* LightGrids::on_flat(const Snapshot& snapshot, SectorId sector, int side) {
    const Heights room = heights_at(snapshot, sector);
    const auto flat = [&](int which) -> const Flat& {
        return which == kFloor ? map_[sector].floor : map_[sector].ceiling;
    };
    if (flat(side).sky) return nullptr;
    const auto make = [&](const LightImage& image, double per_m) { return lamp_on(map_, sector, image, per_m); };
    const auto patch = [&](const LampOnSurface& lamp, int which) {
        if (flat(which).sky) return LightPatch{};
        return patch_on(map_, snapshot, which == kFloor ? room.floor_z : room.ceiling_z, lamp);
    };
    const std::size_t number = map_.walls.size() + map_.panels.size() + map_.things.size() + sector.index;
    return grid(snapshot, number, sector, side, 0, {sunlight_on_floor(map_, sector)}, make, patch);
}

}  // namespace enfilade
