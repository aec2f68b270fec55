// Finding things again in a built map by what a test knows about them, and looking from somewhere.
#pragma once
#include <string>

#include "map/map.h"
#include "render/view.h"

namespace enfilade::test {

/// The sector of that name; stops the test program where there is none.
SectorId sector_named(const Map& map, const std::string& name);

/// The wall a -> b of a sector; stops the test program where there is none.
WallId wall_between(const Map& map, SectorId sector, Vec2 a, Vec2 b);

/// The view from a point of the map, put onto the point grid, in the direction of a yaw.
View look_from(const Map& map, Vec2 eye, double eye_z, double yaw_degrees);

}  // namespace enfilade::test
