// Views aimed at ties: eyes on vertices, on walls' lines and a grid step aside, one column's ray along an axis, a
// diagonal or a wall or through a far vertex, rows through the edges of steps; exactly, and up to rounding.
#pragma once
#include "base/hash.h"
#include "hard_cases/poses.h"
#include "map/map.h"

namespace enfilade::test {

/// A view, the size of its picture, and the column whose rays are aimed at something.
struct TiedView {
    View view;
    PictureSize size;
    int column = 0;
};

/// In a sector that contains the eye.
TiedView tied_view(const Map& map, Random& random);

}  // namespace enfilade::test
