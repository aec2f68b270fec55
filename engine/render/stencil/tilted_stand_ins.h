// What stands in where rounding behind a link left a tilted picture without a wall.
#pragma once
#include <vector>

#include "render/stencil/plan.h"

namespace enfilade::stencil {

/// Behind a link the eye is rounded onto its grid, and the tie rule moves it there in that space's own way. If it is at
/// the doorway's very end, walls that meet there may turn their backs on it, and a part of what is seen through the
/// doorway has no wall in the room behind. Each such part is cut into pieces of a degree or so, and in each one sees,
/// before everything else, the wall that comes nearest to its middle (render/segment.h).
/// Given from left to right. Cost: for n walls of that room n log n, and n for each piece.
std::vector<WallOnScreen> tilted_stand_ins(const Layer& layer, const Map& map);

}  // namespace enfilade::stencil
