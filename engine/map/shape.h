// What follows from where each wall begins and which wall is next. Private to map/.
#pragma once
#include "map/map.h"

namespace enfilade {

/// Fills in the other ends, lengths, previous walls and sector of the sector's walls, and its bounding box.
void settle_shape(Map& map, SectorId sector);

}  // namespace enfilade
