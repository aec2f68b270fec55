// Whether triangles are what triangulate() promises, in whole numbers and by none of the engine's predicates.
#pragma once
#include <span>
#include <string>

#include "space/triangulate.h"

namespace enfilade::test {

/// What is wrong first; empty: nothing.
///
/// That nothing overlaps and nothing is left out is told by edges: every edge is a wall, each wall once, or has its
/// reverse exactly once. So all edges together wind about any point as often as the walls do: once in the sector, never
/// outside. Every triangle, being clockwise, winds once about the points in it and never the other way about any: a
/// point in two of them, or in none, would be wound about twice or never. Areas are added up all the same.
std::string triangle_fault(const Map& map, SectorId sector, std::span<const Triangle> triangles);

}  // namespace enfilade::test
