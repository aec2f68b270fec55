// Is a point inside these walls? The one definition of "inside" that all of the engine uses.
#pragma once
#include <span>

#include "map/map.h"

namespace enfilade {

/// True where the loops of `walls` wind around the moving point p. Exact, under the tie rule (math/predicates.h): of
/// sectors that share an edge exactly one contains each point. Cost: the walls.
bool is_inside(std::span<const Wall> walls, Vec2 p);

/// The same for a sector of a map, looking at its bounding box first.
bool is_inside(const Map& map, SectorId sector, Vec2 p);

}  // namespace enfilade
