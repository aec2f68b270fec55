#include "world/body.h"

#include <algorithm>
#include <cmath>

#include "world/contact.h"
#include "world/one_way.h"

namespace enfilade {
namespace {

/// Rounded down, and a step more, so that a disc of the result certainly does not touch.
double grid_length_below(double length) { return std::max(0.0, snap_to_point_grid(length) - 2 * kPointGrid); }

double distance_to(const ReachedWall& wall) {
    const Vec2 to_it = nearest_point(wall.stretch, wall.centre) - wall.centre;
    return std::sqrt(dot(to_it, to_it));
}

}  // namespace

Clearance clearance(const Instant& now, const Body& body, std::span<const ReachedSector> sectors) {
    Clearance free{-kWorldLimit, kWorldLimit};
    for (const ReachedSector& s : sectors) {
        const Heights heights = heights_of(now, s.sector);
        free.floor_z = std::max(free.floor_z, heights.floor_z - s.passage.rise);
        free.ceiling_z = std::min(free.ceiling_z, heights.ceiling_z - s.passage.rise);
    }
    for (const Obstacle& thing : obstacles_near(now, body, 0)) {
        if (is_beside(thing, body)) continue;
        if (is_at_most(thing.top, body.feet_z))
            free.floor_z = std::max(free.floor_z, thing.top);
        else
            free.ceiling_z = std::min(free.ceiling_z, thing.bottom);
    }
    return free;
}

bool can_pass(const Instant& now, const Body& body, WallId portal, const Rigid& passage) {
    const Wall& wall = now.map[portal];
    if (wall.blocks || !is_portal(now, portal)) return false;
    const double rise = passage.rise, rise_behind = rise + now.map.passage(wall).rise;
    const Heights here = heights_of(now, wall.sector), behind = heights_of(now, wall.behind);
    const double floor_z = behind.floor_z - rise_behind;
    if (!is_at_most(floor_z - body.feet_z, kMaxStep)) return false;
    const double bottom = std::max(floor_z, body.feet_z);
    const double top = std::min({body.ceiling_z, here.ceiling_z - rise, behind.ceiling_z - rise_behind});
    return is_at_most(body.height, top - bottom);
}

MayCross bodies_may_cross(const Map& map) {
    return [&map](const MetPanel& met) { return !map[met.panel].blocks; };
}

Reach around(const Instant& now, const Body& body) {
    return reach(now.map, body.place, body.radius,
                 [&](WallId portal, const Rigid& passage) { return can_pass(now, body, portal, passage); });
}

bool fits(const Instant& now, const Body& body, const Reach& around) {
    if (!around.walls.empty()) return false;
    const Clearance free = clearance(now, body, around.sectors);
    return is_at_most(body.height, free.ceiling_z - std::max(free.floor_z, body.feet_z));
}

Body squeezed(const Instant& now, Body body) {
    const Heights here = heights_of(now, body.place.sector);
    body.ceiling_z = here.ceiling_z;
    body.height = std::clamp(here.ceiling_z - body.feet_z, 0.0, body.height);
    Reach found = around(now, body);
    for (const ReachedWall& wall : found.walls)
        if (!is_one_way_exit(now.map, wall)) body.radius = std::min(body.radius, grid_length_below(distance_to(wall)));
    if (!found.walls.empty()) found = around(now, body);
    body.ceiling_z = clearance(now, body, found.sectors).ceiling_z;
    body.height = std::clamp(body.ceiling_z - body.feet_z, 0.0, body.height);
    return body;
}

}  // namespace enfilade
