// The polygons of one frame, layer by layer.
#pragma once
#include <array>
#include <vector>

#include "render/stencil/mesh.h"
#include "render/stencil/surfaces.h"

namespace enfilade::stencil {

/// Where one layer's polygons are in the mesh.
struct LayerRanges {
    std::array<Range, kKinds> surfaces;  ///< what hides everything behind it, by kind
    std::vector<Range> exits;            ///< by Layer::exits: the portal's opening
    Kind panes_kind = Kind::plain;       ///< one program draws all of them, as they are in order
    Range panes;                         ///< farthest first
};

/// Adds the polygons of all layers to the mesh. Cost: the walls of the layers' sectors.
std::vector<LayerRanges> build_mesh(Mesh& mesh, const Scene& scene, const Plan& plan);

}  // namespace enfilade::stencil
