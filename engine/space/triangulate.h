// Sectors as triangles.
#pragma once
#include <array>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// Three corners, clockwise on the drawing, never on one line. Each is the `a` of a wall of the sector: where several
/// walls start in one vertex, of the one that bounds the ground around this corner. So corners are the same wall where
/// one can turn about the vertex from one to the other inside the sector, and two walls where they only touch in it;
/// and the edge that is a wall starts with that wall.
using Triangle = std::array<WallId, 3>;

/// Cuts a sector into triangles whose corners are its vertices: they cover it without gap or overlap, and no vertex
/// lies inside an edge of a triangle. Any walls that build_map() accepts: outlines and holes that touch themselves and
/// one another in vertices, walls back to back; which walls make up a loop decides nothing.
///
/// Exact (math/predicates.h). A line sweeps over the sector and cuts off what it has seen whole (Stefan Hertel, Kurt
/// Mehlhorn: "Fast triangulation of simple polygons", 1983).
/// Returns: at least one triangle; two less than there are walls in a sector of one loop that does not touch itself,
/// two more for each hole. Cost: O(n log n) in the number of walls.
std::vector<Triangle> triangulate(const Map& map, SectorId sector);

}  // namespace enfilade
