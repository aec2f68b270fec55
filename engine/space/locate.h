// Where is this point? Exact: under the tie rule (math/predicates.h) the answer is one sector or none.
#pragma once
#include "map/map.h"

namespace enfilade {

/// True where the sector's outline, holes taken out, contains the moving point p. Exact. Cost: its walls.
bool contains(const Map& map, SectorId sector, Vec2 p);

/// The sector with the lowest number that contains p, or none. Where sectors overlap there may be others.
/// Cost: all bounding boxes; for places on a path use trace, which knows the way.
SectorId locate(const Map& map, Vec2 p);

}  // namespace enfilade
