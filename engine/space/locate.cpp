#include "space/locate.h"

#include "math/predicates.h"

namespace enfilade {
namespace {

/// 1 where the half line from p along +x, moved by the tie rule, crosses an a -> b that runs towards +y, -1 where it
/// crosses one that runs towards -y, 0 where it misses. p counts as p + (e, e^2): a vertex at p's height lies below it.
int winding_step(Vec2 a, Vec2 b, Vec2 p) {
    const bool a_beyond = a.y > p.y, b_beyond = b.y > p.y;
    if (a_beyond == b_beyond) return 0;
    if (b_beyond) return side_of_line(a, b, p) > 0 ? 1 : 0;
    return side_of_line(a, b, p) < 0 ? -1 : 0;
}

bool in_box(const Sector& sector, Vec2 p) {
    return p.x >= sector.min.x && p.x <= sector.max.x && p.y >= sector.min.y && p.y <= sector.max.y;
}

}  // namespace

bool contains(const Map& map, SectorId sector, Vec2 p) {
    const Sector& s = map[sector];
    if (!in_box(s, p)) return false;
    int winding = 0;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        winding += winding_step(map.walls[i].a, map.walls[i].b, p);
    return winding != 0;
}

SectorId locate(const Map& map, Vec2 p) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (contains(map, SectorId(i), p)) return SectorId(i);
    return {};
}

}  // namespace enfilade
