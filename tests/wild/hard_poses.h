// Poses in which things coincide, or almost: eyes on vertices, lines and pinches, a grid step and a nanometre off.
#pragma once
#include "base/hash.h"
#include "hard_cases/poses.h"
#include "map/map.h"

namespace enfilade::test {

/// A view and the size of its picture.
struct HardPose {
    View view;
    PictureSize size;
};

/// Any field of view that there is, and any size up to `largest`, from one pixel on. In a sector that contains it.
HardPose hard_pose(const Map& map, PictureSize largest, Random& random);

}  // namespace enfilade::test
