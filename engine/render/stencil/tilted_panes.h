// Things, panels and hanging pictures where columns tell nothing about what is met first: in tilted pictures.
#pragma once
#include "render/stencil/plan.h"

namespace enfilade::stencil {

/// Adds all that stands or hangs in the layer's sectors, once, each thing in every sector only as far as it is there.
void note_tilted_panes(Layer& layer, const World& world);

}  // namespace enfilade::stencil
