// What all lamps together throw onto a surface.
#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "render/light_patch.h"
#include "space/reach.h"
#include "space/trace.h"

namespace enfilade {
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
