// Which of the walls, things and pictures of a tilted picture's layer is the nearer, where there are no columns to ask.
#pragma once
#include <vector>

#include "render/stencil/pane.h"
#include "render/stencil/plan.h"

namespace enfilade::stencil {

/// All upright edges of one layer of a tilted picture. Their ranks (WallOnScreen::rank) grow along every ray; one that
/// would take part in a ring of edges, each before the next, is there twice, cut in two (sweep.h).
struct TiltedLayer {
    std::vector<WallOnScreen> walls;
    std::vector<Pane> panes;  ///< by rank
};

/// The walls of the layer's sectors that face the eye beyond the doorway one looks in through, and what stands and
/// hangs in those sectors. Walls, panels and what hangs in portals are ordered exactly.
/// Cost: for n of them n log n side tests.
TiltedLayer tilted_order(const Layer& layer, const FrameInput& input);

}  // namespace enfilade::stencil
