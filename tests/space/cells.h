// Sectors put together from convex cells: what grids and splinters have in common.
#pragma once
#include <vector>

#include "base/hash.h"
#include "formats/map_file.h"
#include "map/map.h"

namespace enfilade::test {

/// A convex piece of ground.
struct Cell {
    std::vector<int> corners;  ///< clockwise, into a list of points
    SectorId sector;           ///< none: rock
};

/// How the walls of a sector become loops.
struct LoopStyle {
    bool is_tangled = false;  ///< go on at random where walls touch; else visit no corner twice
    double slits = 0;  ///< share of the edges within a sector that are walls all the same, back to back [1]; only
                       ///< where loops are tangled
};

/// Cells with one label, 0 to labels - 1, are one sector, however they lie; all walls are solid. Labels that no cell
/// has make no sector: afterwards the cells hold the sectors of the map.
MapFile map_of_cells(const std::vector<Vec2>& corners, std::vector<Cell>& cells, int labels, const LoopStyle& style,
                     Random& random);

}  // namespace enfilade::test
