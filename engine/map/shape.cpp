#include "map/shape.h"

#include <algorithm>
#include <cmath>

#include "math/vec.h"

namespace enfilade {

void settle_shape(Map& map, SectorId id) {
    Sector& sector = map.sectors[id.index];
    sector.min = {kWorldLimit, kWorldLimit};
    sector.max = {-kWorldLimit, -kWorldLimit};
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        Wall& wall = map.walls[i];
        Wall& next = map.walls[wall.next.index];
        wall.sector = id;
        wall.b = next.a;
        wall.length = std::sqrt(dot(wall.b - wall.a, wall.b - wall.a));
        next.previous = WallId(i);
        sector.min = {std::min(sector.min.x, wall.a.x), std::min(sector.min.y, wall.a.y)};
        sector.max = {std::max(sector.max.x, wall.a.x), std::max(sector.max.y, wall.a.y)};
    }
}

}  // namespace enfilade
