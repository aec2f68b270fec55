// Things, panels and hanging pictures where columns tell nothing about what is met first: in tilted pictures.
#pragma once
#include <vector>

#include "render/stencil/pane.h"
#include "render/stencil/plan.h"

namespace enfilade::stencil {

// In which order the rays of a tilted picture meet things, panels and what hangs in portals.

/// A picture with holes, and the room that it stands or hangs in.
struct PaneInRoom {
    SectorId room;
    Pane pane;
};

/// The panes of one layer, along every ray the nearer before the farther, as far as they are shown (shown_left_v,
/// shown_right_v). One that goes through another, or past the eye, is cut in two, so that there is such an order.
/// Given: room by room, and within a room the one that counts as nearer first where two are equally near.
/// Cost: for each pane a look at each other one.
std::vector<Pane> in_order(const std::vector<PaneInRoom>& panes);

/// Adds all that stands or hangs in the layer's sectors, once, each thing in every sector only as far as it is there.
void note_tilted_panes(Layer& layer, const FrameInput& input);

}  // namespace enfilade::stencil
