// Which sectors share ground with others: rooms that are bigger inside.
#pragma once
#include <vector>

#include "map/map.h"

namespace enfilade {

/// For each sector 1 where it overlaps another one in the plane that it is joined to by any number of plain doorways,
/// else 0. Sectors that are joined by links only may lie on one another as they like: they are never in the same space.
/// Touching does not count. Exact; but sectors of thousands of walls whose bounding boxes overlap count as overlapping.
/// Cost: once for a map; all pairs of sectors side by side, and their triangles.
std::vector<char> overlapping_sectors(const Map& map);

}  // namespace enfilade
