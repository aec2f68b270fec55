#include "space/locate.h"

#include "map/sector_finder.h"

namespace enfilade {

bool contains(const Map& map, SectorId sector, Vec2 p) { return is_inside(map, sector, p); }

SectorId locate(const Map& map, Vec2 p) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (contains(map, SectorId(i), p)) return SectorId(i);
    return {};
}

}  // namespace enfilade
