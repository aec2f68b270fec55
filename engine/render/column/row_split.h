// Which rows of a column show ceiling, wall, opening and floor.
#pragma once
#include "render/column/screen.h"
#include "render/column/viewport.h"

namespace enfilade::column {

/// Heights of a room above the eye [m].
struct RelativeHeights {
    double floor = 0;
    double ceiling = 0;
};

/// Rows of one column, top to bottom:
///   [top, wall_top) ceiling   [wall_top, opening_top) step down   [opening_top, opening_bottom) what lies behind
///   [opening_bottom, wall_bottom) step up   [wall_bottom, bottom) floor
/// A solid wall has no opening: its rows are [wall_top, wall_bottom).
struct RowSplit {
    int wall_top = 0, opening_top = 0, opening_bottom = 0, wall_bottom = 0;
};

/// The first of the rows [top, bottom) in which a surface at `depth` is lower than `height` above the eye; bottom if
/// none is. Row y is not lower where tied_rises[y] * depth >= height * focal_y: a product; the division only guesses.
/// Depth 0 (the eye in the wall's plane) is an instant more than nothing, so that an eye exactly at `height` has the
/// rows under its horizon below it.
int first_row_below(const Screen& screen, double height, double depth, int top, int bottom);

/// Splits the open rows at a wall `depth` away. behind: null for a solid wall.
RowSplit split_rows(const Screen& screen, OpenRows open, double depth, const RelativeHeights& here,
                    const RelativeHeights* behind);

}  // namespace enfilade::column
