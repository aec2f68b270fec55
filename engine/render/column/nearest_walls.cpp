#include "render/column/nearest_walls.h"

#include <algorithm>

namespace enfilade::column {
namespace {

bool is_nearer_at(const Map& map, const ProjectedWall& a, double a_inverse, const ProjectedWall& b, double b_inverse) {
    return are_telling(a_inverse, b_inverse) ? a_inverse > b_inverse : is_nearer(map[a.wall], map[b.wall]);
}

}  // namespace

void NearestWalls::choose(const Map& map, const Screen& screen, const Viewport& viewport, const Pose& pose,
                          std::span<const ProjectedWall> walls) {
    begin_ = viewport.begin;
    walls_ = walls;
    lost_.clear();
    nearest_.assign(static_cast<std::size_t>(viewport.end - viewport.begin), {});
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (viewport.entry) {
            // Compared with the entry as a whole and exactly, so that the boundary holds in all its columns at once.
            if (walls[i].wall == viewport.entry || !is_beyond(map[walls[i].wall], map[viewport.entry])) continue;
        }
        offer(map, screen, viewport, static_cast<int>(i));
    }
    find_lost(map, screen, viewport, pose);
}

void NearestWalls::offer(const Map& map, const Screen& screen, const Viewport& viewport, int candidate) {
    const ProjectedWall& offered = wall(candidate);
    for (int x = std::max(offered.begin, viewport.begin); x < std::min(offered.end, viewport.end); ++x) {
        if (viewport.rows_at(x).is_closed()) continue;
        Nearest& best = nearest_[static_cast<std::size_t>(x - begin_)];
        const double inverse = inverse_depth(offered, screen.slopes[x]);
        if (best.wall == kNoWall || is_nearer_at(map, offered, inverse, wall(best.wall), best.inverse_depth))
            best = {candidate, inverse};
    }
}

void NearestWalls::find_lost(const Map& map, const Screen& screen, const Viewport& viewport, const Pose& pose) {
    for (int x = viewport.begin; x < viewport.end; ++x) {
        Nearest& best = nearest_[static_cast<std::size_t>(x - begin_)];
        if (best.wall != kNoWall || viewport.rows_at(x).is_closed()) continue;
        best.wall = static_cast<int>(count());
        lost_.push_back(least_missed(map, viewport.sector, pose, screen, x, viewport.entry));
        best.inverse_depth = 1 / hit(lost_.back(), screen.slopes[x]).depth;
    }
}

}  // namespace enfilade::column
