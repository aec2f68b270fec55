// What stands in where rounding behind a link left a tilted picture without the wall that is met there.
#pragma once
#include <vector>

#include "render/stencil/plan.h"

namespace enfilade::stencil {

/// Behind a link the eye is rounded onto its grid, and the tie rule moves it there in that space's own way. Then some
/// of the rays that are in the doorway's picture stray: they come past the doorway itself. All others are in the room
/// behind it and meet a wall of it first. A stray ray might meet none, as walls of the room may turn their backs on the
/// eye; or it meets one of another outline of the room, and other rooms' walls on the way there. What is seen there, as
/// in the reference, is nonetheless a wall of the room, before everything else: the nearest that is met, or where there
/// is none, in each piece of a degree or so, the one that comes nearest to its middle (render/segment.h).
/// layer: all of its sectors are known. Given from left to right.
/// Cost: where rays stray, the walls of all sectors of the layer, and those of the room for each piece.
std::vector<WallOnScreen> tilted_stand_ins(const Layer& layer, const Map& map);

}  // namespace enfilade::stencil
