#include "world/one_way.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// The largest radius on the point grid at which a disc around p does not touch the wall: rounded down exactly, so that
/// who keeps it keeps it however often it is worked out again.
double distance_below(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 to_it = nearest_point({a, b}, p) - p;
    double distance = snap_to_point_grid(std::sqrt(dot(to_it, to_it)));
    while (!segment_is_nearer(a, b, p, distance + kPointGrid)) distance += kPointGrid;
    while (segment_is_nearer(a, b, p, distance)) distance -= kPointGrid;
    return distance;
}

}  // namespace

std::optional<double> distance_kept(const Map& map, const ReachedWall& wall, Vec2 from, double radius) {
    if (!is_one_way_exit(map, wall)) return radius;
    if (side_of_line(wall.a, wall.b, from) < 0) return {};
    return std::min(radius, distance_below(wall.a, wall.b, from));
}

void drop_exits_left(const Map& map, Vec2 from, const Rigid& way, double radius, Reach& around) {
    around.walls.erase_if([&](const ReachedWall& wall) {
        const Vec2 from_there = snap_to_point_grid(then(way, wall.passage).apply(from));
        const auto kept = distance_kept(map, wall, from_there, radius);
        return !kept || (*kept < radius && !segment_is_nearer(wall.a, wall.b, wall.centre, *kept));
    });
}

}  // namespace enfilade
