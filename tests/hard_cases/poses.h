// Places to look from: some anywhere, some where ties happen.
#pragma once
#include "base/hash.h"
#include "map/map.h"
#include "render/view.h"

namespace enfilade::test {

/// The size of a picture [px].
struct PictureSize {
    int width = 0;
    int height = 0;
};

/// Anywhere inside a random sector, with any look, up or down, narrow or wide.
View random_pose(const Map& map, Random& random);

/// Where coordinates coincide, because maps are lattices and players stand against things: an eye on whole or half
/// metres, exactly on a portal's line or on a vertex, or so placed that a vertex is on a pixel's centre; often at the
/// very height of a floor or a ceiling; looking along an axis, a diagonal or a wall.
View lattice_pose(const Map& map, PictureSize size, Random& random);

}  // namespace enfilade::test
