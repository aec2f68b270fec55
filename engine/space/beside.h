// Points next to a wall: which grid points lie just on one side of it.
#pragma once
#include <array>
#include <optional>

#include "map/map.h"

namespace enfilade {

/// Steps tried when a point has to get to one side of a wall it lies on, up to rounding [grid steps]: a point that was
/// rounded once or twice is less than two steps off, and a step along an axis is at worst 45 degrees off the
/// shortest way.
inline constexpr std::array<double, 4> kStepsBeside{1, 2, 3, 4};

/// One grid step along the axis that leads most directly from the wall into its sector.
Vec2 step_inward(const Wall& wall);

/// p, or where p is not there the first grid point straight beside it, on the side of the wall's line where its sector
/// is (side = 1) or on the other (side = -1). None where p is more than a few grid steps off.
std::optional<Vec2> put_on_side(const Wall& wall, Vec2 p, int side);

}  // namespace enfilade
