#include "world/contact.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "math/vec.h"
#include "world/one_way.h"

namespace enfilade {

namespace {

void add_things_of(const Instant& now, const ReachedSector& reached, const Body& body, double way, Obstacles& found) {
    const Sector& sector = now.map[reached.sector];
    const Vec2 centre = snap_to_point_grid(reached.passage.apply(body.place.point));
    for (std::uint32_t i = sector.first_solid; i < sector.first_solid + sector.solid_count; ++i) {
        const ThingId id = now.map.solid_things[i];
        const Thing& thing = now.map[id];
        const double limit = thing.radius + body.radius;
        if (!segment_is_nearer(thing.position, thing.position, centre, limit + way)) continue;
        const double bottom = foot_of(now, id) - reached.passage.rise;
        found.push_back({id, reached.passage, centre, limit, bottom, bottom + thing.height});
    }
}

}  // namespace

Obstacles obstacles_near(const Instant& now, const Body& body, double way) {
    Obstacles found;
    if (now.map.widest_solid_m == 0) return found;
    const double way_on_grid = way > 0 ? snap_to_point_grid(way) + kPointGrid : 0;
    const Reach around = reach(now.map, body.place, body.radius + now.map.widest_solid_m + way_on_grid);
    for (const ReachedSector& reached : around.sectors) add_things_of(now, reached, body, way_on_grid, found);
    return found;
}

bool is_beside(const Obstacle& obstacle, const Body& body) {
    return !is_at_most(obstacle.top, body.feet_z) && !is_at_most(body.feet_z + body.height, obstacle.bottom);
}

bool overlaps(const Map& map, const Obstacle& obstacle) {
    const Vec2 thing = map[obstacle.thing].position;
    return segment_is_nearer(thing, thing, obstacle.centre, obstacle.limit);
}

namespace {

/// The disc's way in the space of one wall or panel.
struct Way {
    Vec2 from, move;
    double radius;
};

std::optional<Contact> contact_with_face(const ReachedWall& wall, const Way& way) {
    const Stretch& stretch = wall.stretch;
    const double length = std::sqrt(dot(wall.b - wall.a, wall.b - wall.a));
    const Vec2 along = (wall.b - wall.a) * (1 / length), normal = right_of(along);
    const double approach = -dot(way.move, normal);
    if (approach < kPointGrid) return {};
    const double gap = exact_cross(wall.a, wall.b, way.from) / length - way.radius;
    const double fraction = std::max(0.0, gap / approach);
    if (fraction > 1) return {};
    const Vec2 moved = way.move * fraction;
    if (dot(way.from - stretch.a + moved, along) < 0 || dot(way.from - stretch.b + moved, along) > 0) return {};
    return Contact{fraction, normal};
}

std::optional<Contact> contact_with_end(Vec2 end, const Way& way) {
    if (!segment_is_nearer(way.from, way.from + way.move, end, way.radius - kPointGrid)) return {};
    const double length = std::sqrt(dot(way.move, way.move));
    const Vec2 to_end = end - way.from;
    const double ahead = dot(way.move, to_end) / length;
    if (ahead <= 0) return {};
    const double beside_squared = dot(to_end, to_end) - ahead * ahead;
    const double depth_squared = std::max(0.0, way.radius * way.radius - beside_squared);
    const double fraction = std::clamp((ahead - std::sqrt(depth_squared)) / length, 0.0, 1.0);
    const Vec2 from_end = way.move * fraction - to_end;
    return Contact{fraction, from_end * (1 / std::sqrt(dot(from_end, from_end)))};
}

void keep_first(std::optional<Contact>& first, const std::optional<Contact>& next, const Rigid& passage) {
    if (!next || (first && first->fraction <= next->fraction)) return;
    first = Contact{next->fraction, inverse(passage).turn(next->normal)};
}

}  // namespace

std::optional<Contact> first_contact(const Map& map, const Reach& around, Vec2 target, double radius) {
    std::optional<Contact> first;
    for (const ReachedWall& wall : around.walls) {
        const Vec2 to = snap_to_point_grid(wall.passage.apply(target));
        const auto kept = distance_kept(map, wall, wall.centre, radius);
        if (!kept) continue;
        const Way way{wall.centre, to - wall.centre, *kept};
        keep_first(first, contact_with_face(wall, way), wall.passage);
        if (wall.stretch.a == wall.a) keep_first(first, contact_with_end(wall.a, way), wall.passage);
        if (wall.stretch.b == wall.b) keep_first(first, contact_with_end(wall.b, way), wall.passage);
    }
    return first;
}

std::optional<Contact> first_contact(const Map& map, const Obstacles& obstacles, Vec2 target) {
    std::optional<Contact> first;
    for (const Obstacle& obstacle : obstacles) {
        const Vec2 to = snap_to_point_grid(obstacle.passage.apply(target));
        const Way way{obstacle.centre, to - obstacle.centre, obstacle.limit};
        keep_first(first, contact_with_end(map[obstacle.thing].position, way), obstacle.passage);
    }
    return first;
}

}  // namespace enfilade
