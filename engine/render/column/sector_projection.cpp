#include "render/column/sector_projection.h"

#include <algorithm>

#include "math/predicates.h"
#include "render/built_in.h"
#include "render/least_missed.h"

namespace enfilade::column {
namespace {

void set_columns(ProjectedWall& w, const Pose& pose, const Screen& screen) {
    const CoveredColumns covered = covered_columns(w.left_v, w.right_v, pose, {screen.slopes, screen.column_scale});
    w.begin = covered.begin;
    w.end = covered.end;
}

ProjectedWall ends_of(const Segment& wall, const Pose& pose) {
    ProjectedWall w;
    w.swapped = built_in::kMirrors && pose.flip < 0;
    w.left_v = to_view(w.swapped ? wall.b : wall.a, pose);
    w.right_v = to_view(w.swapped ? wall.a : wall.b, pose);
    return w;
}

void set_depths(ProjectedWall& w, const Segment& wall, const Pose& pose) {
    w.cross = std::max(exact_cross(wall.a, wall.b, pose.eye), 0.0);
    w.inverse_cross = 1 / w.cross;
    w.nearest = std::max(std::min(w.left_v.y, w.right_v.y), 0.0);
    w.farthest = std::max({w.left_v.y, w.right_v.y, 0.0});
}

}  // namespace

WallHit hit(const ProjectedWall& w, double slope) {
    const double span = edge_span(w, slope);
    if (!(span > 0)) return {w.farthest, w.swapped ? 1.0 : 0.0};  // only where the wall does not cover the column
    const double along = std::clamp(edge(w.left_v, slope) / span, 0.0, 1.0);
    const bool is_swapped = (built_in::kMirrors || built_in::kPanels) && w.swapped;
    return {std::clamp(w.cross / span, w.nearest, w.farthest), is_swapped ? 1 - along : along};
}

void project(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, std::vector<ProjectedWall>& out) {
    out.clear();
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        if (side_of_line(map.walls[i].a, map.walls[i].b, pose.eye) < 0) continue;
        ProjectedWall w = project(map.walls[i], pose, screen);
        if (w.begin >= w.end) continue;
        w.wall = WallId(i);
        out.push_back(w);
    }
}

ProjectedWall project(const Segment& facing, const Pose& pose, const Screen& screen) {
    ProjectedWall w = ends_of(facing, pose);
    set_columns(w, pose, screen);
    if (w.begin < w.end) set_depths(w, facing, pose);
    return w;
}

ProjectedWall least_missed(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, int column,
                           WallId entry) {
    const WallId wall = enfilade::least_missed(map, sector, pose, screen.slopes[column], entry);
    ProjectedWall best = ends_of(map[wall], pose);
    best.wall = wall;
    best.stands_in = true;
    set_depths(best, map[best.wall], pose);
    best.begin = column;
    best.end = column + 1;
    return best;
}

}  // namespace enfilade::column
