// Maps generated from labelled cells, those of a grid or splinters of a square: sectors of any shape, with holes,
// islands and corners that touch.
#pragma once
#include <cstdint>
#include <vector>

#include "map/map.h"
#include "space/cells.h"

namespace enfilade::test {

/// What a grid is laid of.
struct MosaicPlan {
    int columns = 8, rows = 8;
    double spacing = 4;  ///< width and height of a cell before the corners are moved [m]
    double jitter =
        0;  ///< corners inside are moved by up to this along each axis, by whole jitter_steps; < spacing / 4 [m]
    double jitter_step = 0x1p-10;  ///< [m]
    Vec2 origin{};                 ///< of the top left corner [m]
    int labels = 4;
    double solid = 0;  ///< share of cells that are rock [1]
};

/// What a square about the origin is shattered into.
struct SplinterPlan {
    double size = 8;  ///< of the square [m]
    int points = 24;  ///< strewn into it: anywhere, on a lattice, and on or a grid step beside what is there
    double rim = 0;   ///< share of them that go onto the sides of the square instead [1]
    int labels = 4;
    double solid = 0;  ///< share of splinters that are rock [1]
    LoopStyle loops;
};

/// Cells with one label are one sector, however they lie.
struct Mosaic {
    Map map;
    MosaicPlan plan;            ///< of a grid
    std::vector<Vec2> corners;  ///< of a grid: (columns + 1) * (rows + 1), row by row
    std::vector<Cell> cells;    ///< of a grid: columns * rows, row by row

    Vec2 corner(int column, int row) const { return corners[std::size_t(row * (plan.columns + 1) + column)]; }
    /// The sector of the cell that p, under the tie rule, lies in: an oracle that only asks about convex cells.
    SectorId sector_at(Vec2 p) const;
};

/// A grid: between two labels is a portal, next to rock and around the whole a wall. The same seed gives the same map.
Mosaic lay_mosaic(const MosaicPlan& plan, std::uint64_t seed);

/// Triangles of any shape, however long and thin, with solid walls. The same seed gives the same map.
Mosaic lay_splinters(const SplinterPlan& plan, std::uint64_t seed);

}  // namespace enfilade::test
