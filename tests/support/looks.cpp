#include "support/looks.h"

#include "base/check.h"
#include "math/grid.h"
#include "space/locate.h"

namespace enfilade::test {

SectorId sector_named(const Map& map, const std::string& name) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (map.sectors[i].name == name) return SectorId(i);
    ENFILADE_CHECK(!"the map has a sector of that name");
    return {};
}

WallId wall_between(const Map& map, SectorId sector, Vec2 a, Vec2 b) {
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (map.walls[i].a == a && map.walls[i].b == b) return WallId(i);
    ENFILADE_CHECK(!"the sector has such a wall");
    return {};
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
