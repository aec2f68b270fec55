#include "space/beside.h"

#include <cmath>

#include "math/predicates.h"

namespace enfilade {

Vec2 step_inward(const Wall& wall) {
    const Vec2 inward = right_of(wall.b - wall.a);
    if (std::fabs(inward.x) >= std::fabs(inward.y)) return {inward.x > 0 ? kPointGrid : -kPointGrid, 0};
    return {0, inward.y > 0 ? kPointGrid : -kPointGrid};
}

std::optional<Vec2> put_on_side(const Wall& wall, Vec2 p, int side) {
    if (side_of_line(wall.a, wall.b, p) == side) return p;
    for (double steps : kStepsBeside) {
        const Vec2 moved = p + step_inward(wall) * (steps * side);
        if (side_of_line(wall.a, wall.b, moved) == side) return moved;
    }
    return {};
}

}  // namespace enfilade
