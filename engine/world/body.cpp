#include "world/body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade {
namespace {

/// Rounded down, and a step more, so that a disc of the result certainly does not touch.
double grid_length_below(double length) { return std::max(0.0, snap_to_point_grid(length) - 2 * kPointGrid); }

/// Who is under a lower ceiling gets through fewer portals, is narrower, and may be under a higher one again: each time
/// narrower, at most by so many walls.
constexpr int kMostSqueezes = 8;

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
    const Clearance rooms = free;
    for (const Obstacle& thing : obstacles_overlapped(now, body)) {
        if (is_beside(thing, body)) continue;
        const bool is_below = is_at_most(thing.top, body.feet_z);
        if (is_below && thing.top <= rooms.ceiling_z) free.floor_z = std::max(free.floor_z, thing.top);
        if (!is_below && thing.bottom >= rooms.floor_z) free.ceiling_z = std::min(free.ceiling_z, thing.bottom);
    }
    return free;
}

double height_through(const Instant& now, const Body& body, WallId portal, const Rigid& passage) {
    constexpr double kNobody = -1;
    const Wall& wall = now.map[portal];
    if (wall.blocks || !is_portal(now, portal)) return kNobody;
    const double rise = passage.rise, rise_behind = rise + now.map.passage(wall).rise;
    const Heights here = heights_of(now, wall.sector), behind = heights_of(now, wall.behind);
    const double floor_z = behind.floor_z - rise_behind;
    if (!is_at_most(floor_z - body.feet_z, kMaxStep)) return kNobody;
    const double bottom = std::max(floor_z, body.feet_z);
    const double top = std::min({body.ceiling_z, here.ceiling_z - rise, behind.ceiling_z - rise_behind});
    return top - bottom;
}

bool can_pass(const Instant& now, const Body& body, WallId portal, const Rigid& passage) {
    return is_at_most(body.height, height_through(now, body, portal, passage));
}

MayCross bodies_may_cross(const Map& map) {
    return [&map](const MetPanel& met) { return !map[met.panel].blocks; };
}

Reach around(const Instant& now, const Body& body, EnteredPortals* entered) {
    // In one piece, since a function that remembers more than two pointers takes memory.
    const struct {
        const Instant& now;
        const Body& body;
        EnteredPortals* entered;
    } asked{now, body, entered};
    return reach(now.map, body.place, body.radius, [&asked](WallId portal, const Rigid& passage) {
        const bool is_open = can_pass(asked.now, asked.body, portal, passage);
        if (is_open && asked.entered) asked.entered->push_back({portal, passage});
        return is_open;
    });
}

double height_in(const Instant& now, const Body& body, const EnteredPortals& entered) {
    double height = kWorldLimit;
    for (const EnteredPortal& e : entered) height = std::min(height, height_through(now, body, e.portal, e.passage));
    return height;
}

double lowest_feet_in(const Instant& now, const EnteredPortals& entered) {
    double feet_z = -kWorldLimit;
    for (const EnteredPortal& e : entered) {
        const Wall& wall = now.map[e.portal];
        const double rise_behind = e.passage.rise + now.map.passage(wall).rise;
        feet_z = std::max(feet_z, heights_of(now, wall.behind).floor_z - rise_behind - kMaxStep);
    }
    return feet_z;
}

bool fits(const Instant& now, const Body& body, const Reach& around, const EnteredPortals& entered) {
    if (!around.walls.empty()) return false;
    const Clearance free = clearance(now, body, around.sectors);
    Body there = body;
    there.ceiling_z = std::min(body.ceiling_z, free.ceiling_z);
    there.feet_z = std::max(body.feet_z, free.floor_z);
    return is_at_most(body.height, std::min(free.ceiling_z - there.feet_z, height_in(now, there, entered)));
}

PlacedBody placed(const Instant& now, Body body) {
    PlacedBody found;  // without braces, which would clear kilobytes of empty lists
    Body& it = found.body = body;
    const auto look_around = [&] {
        found.entered.clear();
        found.around = around(now, it, &found.entered);
    };
    const auto be_as_high_as_it_can = [&] { it.height = std::clamp(it.ceiling_z - it.feet_z, 0.0, body.height); };
    it.ceiling_z = heights_of(now, it.place.sector).ceiling_z;
    for (int tries = 0; tries < kMostSqueezes; ++tries) {
        be_as_high_as_it_can();
        look_around();
        for (const ReachedWall& wall : found.around.walls)
            if (!is_one_way_exit(now.map, wall)) it.radius = std::min(it.radius, grid_length_below(distance_to(wall)));
        if (!found.around.walls.empty()) look_around();
        found.free = clearance(now, it, found.around.sectors);
        const double before = std::exchange(it.ceiling_z, found.free.ceiling_z);
        if (it.ceiling_z == before) return found;
    }
    be_as_high_as_it_can();
    look_around();
    found.free = clearance(now, it, found.around.sectors);
    return found;
}

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

namespace {

/// Adds what a body may touch whose middle comes into a sector. to_sector: from the space of the body's place.
void add_things_near(const Instant& now, SectorId sector, const Rigid& to_sector, const Body& body, double way,
                     Obstacles& found) {
    for (const NearThing& near : now.map.near(sector)) {
        const Thing& thing = now.map[near.thing];
        const Rigid passage = then(to_sector, near.passage);
        const Vec2 centre = snap_to_point_grid(passage.apply(body.place.point));
        const double limit = thing.radius + body.radius;
        if (!segment_is_nearer(thing.position, thing.position, centre, limit + way)) continue;
        const double bottom = foot_of(now, near.thing) - passage.rise;
        found.push_back({near.thing, passage, centre, limit, bottom, bottom + thing.height});
    }
}

}  // namespace

Obstacles obstacles_overlapped(const Instant& now, const Body& body) {
    Obstacles found;
    add_things_near(now, body.place.sector, {}, body, 0, found);
    return found;
}

Obstacles obstacles_on_way(const Instant& now, const Body& body, Vec2 target) {
    Obstacles found;
    if (now.map.near_things.empty()) return found;
    const Vec2 move = target - body.place.point;
    const double way = snap_to_point_grid(std::sqrt(dot(move, move))) + kPointGrid;
    add_things_near(now, body.place.sector, {}, body, way, found);
    Rigid passage;
    for (const Crossing& crossing : trace(now.map, body.place, target).crossings) {
        const Wall& portal = now.map[crossing.portal];
        passage = then(passage, now.map.passage(portal));
        add_things_near(now, portal.behind, passage, body, way, found);
    }
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
