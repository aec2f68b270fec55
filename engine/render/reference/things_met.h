// The pictures of things that a ray meets on its way through one room.
#pragma once
#include <vector>

#include "render/reference/pane.h"

namespace enfilade {

/// The stretch of a ray in one room: from where it comes in to the wall it meets.
struct RoomRay {
    const RayHit& hit;
    double slope;
    double climb;
    double entry_depth;  ///< 0 in the eye's own room [m]
};

/// Adds the pictures that the ray goes through, the nearest first, by the rules of render/sprite.h. True where a shift
/// of kAmbiguous would have met another picture, or in another order.
bool add_things_met(const Scene& scene, const RoomRay& ray, std::vector<Pane>& panes);

}  // namespace enfilade
