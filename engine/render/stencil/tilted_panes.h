// Things, panels and hanging pictures where columns tell nothing about what is met first: in tilted pictures.
#pragma once
#include <vector>

#include "render/stencil/pane.h"
#include "render/stencil/plan.h"

namespace enfilade::stencil {

/// A picture with holes, and the room that it stands or hangs in.
struct PaneInRoom {
    SectorId room;
    std::size_t number;  ///< parts of one picture have the same; of two that are equally near the smaller is the nearer
    Pane pane;
};

inline bool is_thing(const Pane& pane) { return std::holds_alternative<ThingOnScreen>(pane); }

/// All that stands or hangs in the layer's sectors, as far as it is shown (shown_left_v, shown_right_v): each thing in
/// every sector only as far as it is there, and in two where it goes through a panel. So none goes through another.
/// Cost: for each panel a look at each thing.
std::vector<PaneInRoom> tilted_panes(const Layer& layer, const FrameInput& input);

/// How deep a thing is inside its room [m]: what stands in the very plane of a doorway is in the room behind it,
/// whatever rounding did (render/sprite.h).
double depth_in_room(const ThingOnScreen& thing);

}  // namespace enfilade::stencil
