// The pictures of things that a ray meets on its way through one room.
#pragma once
#include <vector>

#include "render/reference/pane.h"

namespace enfilade {

/// Adds the pictures that the ray goes through, the nearest first, by the rules of render/sprite.h. True where a shift
/// of kAmbiguous would have met another picture.
bool find_things_met(const Scene& scene, const RoomRay& ray, std::vector<MetPane>& met);

}  // namespace enfilade
