// What stands in one room, in the order in which a ray meets it.
#pragma once
#include <vector>

#include "render/reference/pane.h"

namespace enfilade {

/// Adds the things and panels that the ray goes through, the nearest first; of a thing and a panel at one depth, in
/// steps (render/sprite.h), the thing. True where a shift of kAmbiguous would have met something else, or in another
/// order.
bool add_room_panes(const Scene& scene, const RoomRay& ray, std::vector<Pane>& panes);

}  // namespace enfilade
