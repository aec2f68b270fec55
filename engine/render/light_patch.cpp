#include "render/light_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/vec.h"
#include "space/reach.h"
#include "space/trace.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

/// What a surface takes of light that only grazes it [1]. Without it, floors far from a low lamp were black.
constexpr double kGrazing = 1.0 / 3;

/// Numbers for the lots of lights, apart from those of sectors (world/snapshot.h).
constexpr std::uint64_t kLightSeeds = std::uint64_t{1} << 32;

/// What arrives at a place, were nothing in between. normal_way: how far the light is from the surface's plane [m].
double unhindered(double way, double normal_way, double reach) {
    return way < reach ? light_falloff(way, reach) * light_facing(way > 0 ? normal_way / way : 1) : 0;
}

}  // namespace

double light_falloff(double way, double reach) {
    const double left = 1 - way / reach;
    return left > 0 ? left * left : 0;
}

LightBox light_box(double u_low, double u_high, double v_low, double v_high, double per_m) {
    if (!(u_low <= u_high && v_low <= v_high)) return {};
    const auto first = [&](double metres) { return static_cast<int>(std::floor(metres * per_m)); };
    const auto count = [&](double low, double high) {
        return std::max(static_cast<int>(std::ceil(high * per_m)) - first(low) + 1, 2);
    };
    return {first(u_low), count(u_low, u_high), first(v_low), count(v_low, v_high)};
}

LightBox box_around(const LightBox& a, const LightBox& b) {
    if (a.columns == 0 || b.columns == 0) return a.columns == 0 ? b : a;
    const int column = std::min(a.column, b.column), row = std::min(a.row, b.row);
    return {column, std::max(a.column + a.columns, b.column + b.columns) - column, row,
            std::max(a.row + a.rows, b.row + b.rows) - row};
}

double light_facing(double cosine) { return kGrazing + (1 - kGrazing) * std::fabs(cosine); }

LightPatch patch_on(const Map& map, const Snapshot& snapshot, const UprightSurface& surface, const LampOnSurface& lamp,
                    double bottom, double top) {
    const double reach = map.lights[lamp.image.light].reach;
    const Vec2 along = (surface.b - surface.a) * (1 / surface.length);
    const double aside = dot(right_of(along), lamp.image.from - surface.a);
    const double above = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
    const LightBox rows =
        light_box(0, 0, std::max(bottom, lamp.image.z - above), std::min(top, lamp.image.z + above), lamp.per_m);
    LightPatch patch{{lamp.box.column, lamp.box.columns, rows.row, rows.rows}, {}};
    patch.arrives.reserve(static_cast<std::size_t>(patch.box.columns) * static_cast<std::size_t>(rows.rows));
    for (int i = 0; i < patch.box.columns; ++i) {
        const Vec2 place = surface.a + along * ((patch.box.column + i) / lamp.per_m);
        const Vec2 flat_way = place - lamp.image.from;
        for (int j = 0; j < rows.rows; ++j) {
            const double z = (rows.row + j) / lamp.per_m, up = z - lamp.image.z;
            const double free = unhindered(std::sqrt(dot(flat_way, flat_way) + up * up), aside, reach);
            const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, static_cast<std::size_t>(i),
                                                              std::clamp(z, bottom, top));
            patch.arrives.push_back(is_lit ? static_cast<float>(free) : 0);
        }
    }
    return patch;
}

LightPatch patch_on(const Map& map, const Snapshot& snapshot, double z, const LampOnSurface& lamp) {
    const double reach = map.lights[lamp.image.light].reach, up = z - lamp.image.z;
    LightPatch patch{lamp.box, {}};
    if (std::fabs(up) >= reach) patch.box = {};
    patch.arrives.reserve(static_cast<std::size_t>(patch.box.columns) * static_cast<std::size_t>(patch.box.rows));
    for (int i = 0; i < patch.box.columns; ++i)
        for (int j = 0; j < patch.box.rows; ++j) {
            const Vec2 place{(patch.box.column + i) / lamp.per_m, (patch.box.row + j) / lamp.per_m};
            const Vec2 flat_way = place - lamp.image.from;
            const double free = unhindered(std::sqrt(dot(flat_way, flat_way) + up * up), up, reach);
            const std::size_t ray = patch.arrives.size();
            const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, ray, z);
            patch.arrives.push_back(is_lit ? static_cast<float>(free) : 0);
        }
    return patch;
}

LightPatch patch_at(const Map& map, const Snapshot& snapshot, Vec2 place, double z, const LampOnSurface& lamp) {
    const Vec2 flat_way = place - lamp.image.from;
    const double up = z - lamp.image.z, way = std::sqrt(dot(flat_way, flat_way) + up * up);
    const double free = unhindered(way, way, map.lights[lamp.image.light].reach);
    const bool is_lit = free > 0 && lamp.rays.arrives(map, snapshot, lamp.image, 0, z);
    return {{0, 2, 0, 2}, std::vector<float>(4, is_lit ? static_cast<float>(free) : 0)};
}

LampColor color_of_light(std::uint32_t color, double brightness) {
    const double bright = brightness * 256 * kLightSteps / 255;
    const auto channel = [&](int shift) { return static_cast<float>((color >> shift & 0xFF) * bright); };
    return {channel(16), channel(8), channel(0)};
}

LampColor lamp_color(const Map& map, const Snapshot& snapshot, std::uint32_t number) {
    const PointLight& light = map.lights[number];
    const double time_s = std::max(snapshot.time_s, 0.0);
    const bool changes = light.effect && !snapshot.is_light_still;
    const double level = changes ? level_of(*light.effect, 1, kLightSeeds + number, time_s) : 1;
    return color_of_light(light.color, light.brightness * level);
}

// What all lamps together throw onto a surface.

namespace {

// Where on a surface the light of a lamp is worked out, and how it gets there.

/// How far from the ends of a wall, from a panel, and from the walls around a floor places are moved, so that they are
/// surely inside [of the way to the next point].
constexpr double kInside = 1.0 / 16;

/// A point outside its sector matters where the nearest place inside is in a cell that it is a corner of [cells].
constexpr double kNextCell = 1.5;

/// The point of the sector's walls that is nearest to q, and its square distance.
struct NearestPoint {
    Vec2 point;
    WallId wall;
    double distance_squared;
};
/// Within kNextCell.
NearestPoint nearest_of_walls(const Map& map, SectorId id, Vec2 q, double per_m) {
    const Sector& sector = map[id];
    NearestPoint nearest{{}, {}, kNextCell * kNextCell / (per_m * per_m)};
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Vec2 p = nearest_point({map.walls[i].a, map.walls[i].b}, q);
        const double distance = dot(p - q, p - q);
        if (distance < nearest.distance_squared) nearest = {p, WallId(i), distance};
    }
    return nearest;
}

/// A place inside the sector that stands for the point q of its grid, or none: nobody looks there.
std::optional<Vec2> place_for(const Map& map, SectorId sector, Vec2 q, double per_m) {
    if (contains(map, sector, snap_to_point_grid(q))) return q;
    const NearestPoint nearest = nearest_of_walls(map, sector, q, per_m);
    if (!nearest.wall) return {};
    const Wall& wall = map[nearest.wall];
    const double distance = std::sqrt(nearest.distance_squared);
    const Vec2 inward =
        distance > 0 ? (nearest.point - q) * (1 / distance) : right_of(wall.b - wall.a) * (1 / wall.length);
    const Vec2 inside = snap_to_point_grid(nearest.point + inward * (kInside / per_m));
    return contains(map, sector, inside) ? std::optional(inside) : std::nullopt;
}

/// The box around all of them.
LightBox box_around(std::span<const LightPatch> patches) {
    LightBox all;
    for (const auto& [box, arrives] : patches)
        if (!arrives.empty()) all = box_around(all, box);
    return all;
}

std::uint32_t lane_of(float light) {
    return static_cast<std::uint32_t>(std::min(light, static_cast<float>(kMostLight) - 0.5f) + 0.5f);
}

/// Where in a grid there is light: points [column, column + columns) x [row, row + rows), none where all is dark.
LightBox lit_points(const LightGrid& grid) {
    LightBox lit;
    int right = 0, end = 0;
    for (int i = 0; i < grid.columns; ++i)
        for (int j = 0; j < grid.rows; ++j) {
            if (is_dark(grid.cells[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid.rows) +
                                   static_cast<std::size_t>(j)]))
                continue;
            lit.column = right == 0 ? i : lit.column;
            lit.row = right == 0 ? j : std::min(lit.row, j);
            right = i + 1;
            end = std::max(end, j + 1);
        }
    lit.columns = right - lit.column;
    lit.rows = end - lit.row;
    return lit;
}

/// Without what is dark around the light, but for a rim one point wide.
LightGrid trimmed(const LightGrid& grid) {
    const LightBox lit = lit_points(grid);
    if (lit.columns == 0) return {};
    const int left = std::max(lit.column - 1, 0), right = std::min(lit.column + lit.columns + 1, grid.columns);
    const int first = std::max(lit.row - 1, 0), end = std::min(lit.row + lit.rows + 1, grid.rows);
    LightGrid part{grid.u + left / grid.per_m, grid.v + first / grid.per_m, grid.per_m, right - left, end - first, {}};
    part.is_dark_before_u = left < lit.column;
    part.is_dark_after_u = right > lit.column + lit.columns;
    part.is_dark_before_v = first < lit.row;
    part.is_dark_after_v = end > lit.row + lit.rows;
    part.cells.reserve(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
    for (int i = left; i < right; ++i) {
        const auto column = grid.cells.begin() + std::ptrdiff_t{i} * grid.rows;
        part.cells.insert(part.cells.end(), column + first, column + end);
    }
    return part;
}

}  // namespace

LampOnSurface lamp_on(const Map& map, const UprightSurface& surface, const LightImage& image, double per_m) {
    LampOnSurface lamp{image, per_m, {}, {}};
    const Vec2 along = (surface.b - surface.a) * (1 / surface.length);
    const Vec2 to_light = image.from - surface.a;
    const double reach = map.lights[image.light].reach, aside = dot(right_of(along), to_light);
    if (std::fabs(aside) >= reach || (surface.wall && aside <= 0)) return lamp;
    const double before = dot(along, to_light), half = std::sqrt(reach * reach - aside * aside);
    lamp.box = light_box(std::max(before - half, 0.0), std::min(before + half, surface.length), image.z - half,
                         image.z + half, per_m);
    const double inside = kInside / per_m, margin = std::min(inside, surface.length / 2);
    const Vec2 off = surface.wall ? Vec2{} : right_of(along) * std::copysign(inside, aside);
    for (int i = 0; i < lamp.box.columns; ++i) {
        const double u = std::clamp((lamp.box.column + i) / per_m, margin, surface.length - margin);
        lamp.rays.add(map, image, {surface.sector, surface.a + along * u + off, surface.wall});
    }
    return lamp;
}

LampOnSurface lamp_on(const Map& map, SectorId id, const LightImage& image, double per_m) {
    LampOnSurface lamp{image, per_m, {}, {}};
    const Sector& sector = map[id];
    const double reach = map.lights[image.light].reach;
    lamp.box =
        light_box(std::max(sector.min.x, image.from.x - reach), std::min(sector.max.x, image.from.x + reach),
                  std::max(sector.min.y, image.from.y - reach), std::min(sector.max.y, image.from.y + reach), per_m);
    for (int i = 0; i < lamp.box.columns; ++i)
        for (int j = 0; j < lamp.box.rows; ++j) {
            const Vec2 point{(lamp.box.column + i) / per_m, (lamp.box.row + j) / per_m};
            const bool is_near = dot(point - image.from, point - image.from) < reach * reach;
            const std::optional<Vec2> place = is_near ? place_for(map, id, point, per_m) : std::nullopt;
            if (place)
                lamp.rays.add(map, image, {id, *place, {}});
            else
                lamp.rays.add_none();
        }
    return lamp;
}

LampOnSurface lamp_on(const Map& map, SectorId sector, Vec2 place, const LightImage& image) {
    LampOnSurface lamp{image, kUsualLightPoints, {0, 1, 0, 1}, {}};
    lamp.rays.add(map, image, {sector, place, {}});
    return lamp;
}

LightGrid sum_of(std::span<const LightPatch> patches, std::span<const LampColor> colors, double per_m) {
    const LightBox all = box_around(patches);
    LightGrid grid{all.column / per_m, all.row / per_m, per_m, all.columns, all.rows, {}};
    std::vector<LampColor> sums(static_cast<std::size_t>(all.columns) * static_cast<std::size_t>(all.rows));
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const float* arrives = patches[p].arrives.data();
        const LightBox& box = patches[p].box;
        if (patches[p].arrives.empty()) continue;
        for (int i = box.column - all.column; i < box.column - all.column + box.columns; ++i)
            for (int j = box.row - all.row; j < box.row - all.row + box.rows; ++j, ++arrives) {
                LampColor& sum = sums[static_cast<std::size_t>(i) * static_cast<std::size_t>(all.rows) +
                                      static_cast<std::size_t>(j)];
                sum.red += *arrives * colors[p].red;
                sum.green += *arrives * colors[p].green;
                sum.blue += *arrives * colors[p].blue;
            }
    }
    grid.cells.reserve(sums.size());
    for (const LampColor& sum : sums)
        grid.cells.push_back(light_cell(lane_of(sum.red), lane_of(sum.green), lane_of(sum.blue)));
    return trimmed(grid);
}

}  // namespace enfilade
