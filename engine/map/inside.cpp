#include "map/inside.h"

#include "math/predicates.h"

namespace enfilade {
namespace {

/// 1 where the half line from p along +x, moved by the tie rule, crosses an a -> b that runs towards +y, -1 where it
/// crosses one that runs towards -y, 0 where it misses. p counts as p + (e, e^2): a vertex at p's height lies above
/// it on the drawing.
int winding_step(const Wall& w, Vec2 p) {
    const bool a_beyond = w.a.y > p.y, b_beyond = w.b.y > p.y;
    if (a_beyond == b_beyond) return 0;
    if (b_beyond) return side_of_line(w.a, w.b, p) > 0 ? 1 : 0;
    return side_of_line(w.a, w.b, p) < 0 ? -1 : 0;
}

}  // namespace

bool is_inside(std::span<const Wall> walls, Vec2 p) {
    int winding = 0;
    for (const Wall& w : walls) winding += winding_step(w, p);
    return winding != 0;
}

bool is_inside(const Map& map, SectorId sector, Vec2 p) {
    const Sector& s = map[sector];
    if (p.x < s.min.x || p.x > s.max.x || p.y < s.min.y || p.y > s.max.y) return false;
    return is_inside(std::span(map.walls).subspan(s.first_wall, s.wall_count), p);
}

}  // namespace enfilade
