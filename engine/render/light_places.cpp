// Where on a surface the light of a lamp is worked out, and how it gets there.
#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "render/light_patch.h"
#include "space/locate.h"
#include "space/reach.h"

namespace enfilade {
namespace {

/// How far from the ends of a wall, from a panel, and from the walls around a floor places are moved, so that they are
/// surely inside [m].
constexpr double kInside = 1.0 / 64;

/// A point outside its sector matters where the nearest place inside is in a cell that it is a corner of [m].
constexpr double kNextCell = 1.5 * kLightCell;

/// The point of the sector's walls that is nearest to q, and its square distance.
struct NearestPoint {
    Vec2 point;
    WallId wall;
    double distance_squared;
};
NearestPoint nearest_of_walls(const Map& map, SectorId id, Vec2 q) {
    const Sector& sector = map[id];
    NearestPoint nearest{{}, {}, kNextCell * kNextCell};
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Vec2 p = nearest_point({map.walls[i].a, map.walls[i].b}, q);
        const double distance = dot(p - q, p - q);
        if (distance < nearest.distance_squared) nearest = {p, WallId(i), distance};
    }
    return nearest;
}

/// A place inside the sector that stands for the point q of its grid, or none: nobody looks there.
std::optional<Vec2> place_for(const Map& map, SectorId sector, Vec2 q) {
    if (contains(map, sector, snap_to_point_grid(q))) return q;
    const NearestPoint nearest = nearest_of_walls(map, sector, q);
    if (!nearest.wall) return {};
    const Wall& wall = map[nearest.wall];
    const double distance = std::sqrt(nearest.distance_squared);
    const Vec2 inward =
        distance > 0 ? (nearest.point - q) * (1 / distance) : right_of(wall.b - wall.a) * (1 / wall.length);
    const Vec2 inside = snap_to_point_grid(nearest.point + inward * kInside);
    return contains(map, sector, inside) ? std::optional(inside) : std::nullopt;
}

}  // namespace

LampOnSurface lamp_on(const Map& map, const UprightSurface& surface, const LightImage& image) {
    LampOnSurface lamp{image, {}, {}};
    const Vec2 along = (surface.b - surface.a) * (1 / surface.length);
    const Vec2 to_light = image.from - surface.a;
    const double reach = map.lights[image.light].reach, aside = dot(right_of(along), to_light);
    if (std::fabs(aside) >= reach || (surface.wall && aside <= 0)) return lamp;
    const double before = dot(along, to_light), half = std::sqrt(reach * reach - aside * aside);
    lamp.box = light_box(std::max(before - half, 0.0), std::min(before + half, surface.length), 0, 0);
    const double margin = std::min(kInside, surface.length / 2);
    const Vec2 off = surface.wall ? Vec2{} : right_of(along) * std::copysign(kInside, aside);
    for (int i = 0; i < lamp.box.columns; ++i) {
        const double u = std::clamp((lamp.box.column + i) * kLightCell, margin, surface.length - margin);
        lamp.rays.add(map, image, {surface.sector, surface.a + along * u + off, surface.wall});
    }
    return lamp;
}

LampOnSurface lamp_on(const Map& map, SectorId id, const LightImage& image) {
    LampOnSurface lamp{image, {}, {}};
    const Sector& sector = map[id];
    const double reach = map.lights[image.light].reach;
    lamp.box = light_box(std::max(sector.min.x, image.from.x - reach), std::min(sector.max.x, image.from.x + reach),
                         std::max(sector.min.y, image.from.y - reach), std::min(sector.max.y, image.from.y + reach));
    for (int i = 0; i < lamp.box.columns; ++i)
        for (int j = 0; j < lamp.box.rows; ++j) {
            const Vec2 point{(lamp.box.column + i) * kLightCell, (lamp.box.row + j) * kLightCell};
            const bool is_near = dot(point - image.from, point - image.from) < reach * reach;
            const std::optional<Vec2> place = is_near ? place_for(map, id, point) : std::nullopt;
            if (place)
                lamp.rays.add(map, image, {id, *place, {}});
            else
                lamp.rays.add_none();
        }
    return lamp;
}

LampOnSurface lamp_on(const Map& map, SectorId sector, Vec2 place, const LightImage& image) {
    LampOnSurface lamp{image, {0, 1, 0, 1}, {}};
    lamp.rays.add(map, image, {sector, place, {}});
    return lamp;
}

}  // namespace enfilade
