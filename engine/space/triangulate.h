// Sectors as triangles.
#pragma once
#include <array>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// Three corners, clockwise on the drawing, never on one line. Each is the `a` of a wall of the sector.
using Triangle = std::array<WallId, 3>;

/// Cuts a sector into triangles whose corners are its vertices: they cover it without gap or overlap, and no vertex
/// lies inside an edge of a triangle. Any outlines and holes, also such that touch in vertices.
///
/// Exact (math/predicates.h). Holes are joined to their outline by bridges, then ears are cut off (David Eberly,
/// "Triangulation by Ear Clipping", 2002), with a rule for vertices that several walls pass through.
/// Returns: at least one triangle. Cost: the square of the walls as a rule, their cube at worst.
std::vector<Triangle> triangulate(const Map& map, SectorId sector);

}  // namespace enfilade
