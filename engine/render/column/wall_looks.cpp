#include "render/column/wall_looks.h"

#include "render/built_in.h"

namespace enfilade::column {
namespace {

double between(double value, double low, double high) {
    const double not_below = value > low ? value : low;
    return not_below < high ? not_below : high;
}

}  // namespace

void look_at(const ProjectedWall& wall, const RayTables& screen, int begin, int count, WallLooks& looks) {
    looks.begin = begin;
    looks.count = count;
    looks.farthest = wall.farthest;
    const double* const slopes = &screen.slopes[static_cast<std::size_t>(begin)];
    if (wall.stands_in) {
        const WallHit missed = hit(wall, slopes[0]);
        looks.depth[0] = missed.depth;
        looks.along[0] = missed.along;
        looks.inverse_depth[0] = 1 / missed.depth;
        return;
    }
    const ProjectedWall w = wall;
    const bool is_swapped = (built_in::kMirrors || built_in::kPanels) && w.swapped;
    for (int i = 0; i < count; ++i) {
        const double left = edge(w.left_v, slopes[i]);
        const double span = left - edge(w.right_v, slopes[i]);
        const double along = between(left / span, 0, 1);
        looks.depth[i] = between(w.cross / span, w.nearest, w.farthest);
        looks.along[i] = is_swapped ? 1 - along : along;
        looks.inverse_depth[i] = span * w.inverse_cross;
    }
}

void split_rows(const RayTables& screen, const WallLooks& looks, const OpenRows* open, const RelativeHeights& here,
                const RelativeHeights* behind, RowSplits& rows) {
    rows.has_ceiling = rows.has_upper = rows.has_lower = rows.has_floor = false;
    for (int i = 0; i < looks.count; ++i) {
        const RowSplit split = split_rows(screen, open[i], looks.depth[i], here, behind);
        rows.top[i] = open[i].top;
        rows.wall_top[i] = split.wall_top;
        rows.opening_top[i] = split.opening_top;
        rows.opening_bottom[i] = split.opening_bottom;
        rows.wall_bottom[i] = split.wall_bottom;
        rows.bottom[i] = open[i].bottom;
        rows.has_ceiling |= open[i].top < split.wall_top;
        rows.has_upper |= split.wall_top < split.opening_top;
        rows.has_lower |= split.opening_bottom < split.wall_bottom;
        rows.has_floor |= split.wall_bottom < open[i].bottom;
    }
}

}  // namespace enfilade::column
