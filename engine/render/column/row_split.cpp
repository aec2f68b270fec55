#include "render/column/row_split.h"

#include <algorithm>
#include <cmath>

namespace enfilade::column {

namespace {

/// A wall that passes through the eye is met an instant after the start: nearer than any height matters, but not so
/// near that an eye at the very height of a ceiling would find all rows above it.
constexpr double kAnInstant = 0x1p-1000;

}  // namespace

int first_row_below(const Screen& screen, double height, double depth, int top, int bottom) {
    const double height_px = height * screen.focal_y;
    const double met = std::max(depth, kAnInstant);
    const auto is_below = [&](int y) { return screen.tied_rises[y] * met < height_px; };
    const double guess = std::ceil(screen.horizon - 0.5 - height_px / met);
    int y = !(guess > top) ? top : guess >= bottom ? bottom : static_cast<int>(guess);
    while (y > top && is_below(y - 1)) --y;
    while (y < bottom && !is_below(y)) ++y;
    return y;
}

RowSplit split_rows(const Screen& screen, OpenRows open, double depth, const RelativeHeights& here,
                    const RelativeHeights* behind) {
    RowSplit rows;
    rows.wall_top = first_row_below(screen, here.ceiling, depth, open.top, open.bottom);
    rows.wall_bottom = first_row_below(screen, here.floor, depth, rows.wall_top, open.bottom);
    rows.opening_top = rows.opening_bottom = rows.wall_bottom;
    if (behind == nullptr) return rows;
    rows.opening_top = first_row_below(screen, behind->ceiling, depth, rows.wall_top, rows.wall_bottom);
    rows.opening_bottom = first_row_below(screen, behind->floor, depth, rows.opening_top, rows.wall_bottom);
    return rows;
}

}  // namespace enfilade::column
