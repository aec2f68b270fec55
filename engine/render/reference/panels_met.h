// The panels that a ray goes through on its way through one room.
#pragma once
#include <vector>

#include "render/reference/pane.h"

namespace enfilade {

/// Adds the panels that the ray goes through, the nearest first. True where a shift of kAmbiguous would have met
/// another one, or missed one.
bool find_panels_met(const Scene& scene, const RoomRay& ray, std::vector<MetPane>& met);

}  // namespace enfilade
