// The polygons of one frame, layer by layer.
#pragma once
#include <vector>

#include "render/stencil/mesh.h"
#include "render/stencil/surfaces.h"

namespace enfilade::stencil {

/// Where one layer's polygons are in the mesh.
struct LayerRanges {
    std::vector<KindRange> surfaces;  ///< what hides everything behind it
    std::vector<Range> exits;         ///< by Layer::exits: the portal's opening
    KindRange panes;                  ///< farthest first
};

/// Adds the polygons of all layers to the mesh. Cost: the walls of the layers' sectors.
std::vector<LayerRanges> build_mesh(Mesh& mesh, const Scene& scene, const Plan& plan);

}  // namespace enfilade::stencil
