#include "support/looks.h"

#include "base/result.h"
#include "math/vec.h"
#include "space/trace.h"

namespace enfilade::test {

SectorId sector_named(const Map& map, const std::string& name) {
    std::size_t i = 0;
    while (i < map.sectors.size() && map.sectors[i].name != name) ++i;
    ENFILADE_CHECK(i < map.sectors.size());
    return SectorId(i);
}

WallId wall_between(const Map& map, SectorId sector, Vec2 a, Vec2 b) {
    const Sector& s = map[sector];
    const std::uint32_t end = s.first_wall + s.wall_count;
    std::uint32_t i = s.first_wall;
    while (i < end && !(map.walls[i].a == a && map.walls[i].b == b)) ++i;
    ENFILADE_CHECK(i < end);
    return WallId(i);
}

View look_from(const Map& map, Vec2 eye, double eye_z, double yaw_degrees) {
    View view;
    view.eye = snap_to_point_grid(eye);
    view.sector = locate(map, view.eye);
    ENFILADE_CHECK(view.sector);
    view.eye_z = eye_z;
    view.forward = direction(Angle::from_degrees(yaw_degrees));
    return view;
}

}  // namespace enfilade::test
