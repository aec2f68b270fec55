#include "world/obstacle.h"

#include "math/predicates.h"

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

}  // namespace enfilade
