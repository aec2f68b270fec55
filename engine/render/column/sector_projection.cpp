#include "render/column/sector_projection.h"

#include <algorithm>
#include <utility>

#include "math/predicates.h"
#include "render/built_in.h"
#include "render/segment.h"

namespace enfilade::column {

void RayTables::set(const Projection& projection) {
    width = projection.width();
    height = projection.height();
    focal_y = projection.focal_y();
    horizon = projection.horizon();
    slopes.resize(static_cast<std::size_t>(width));
    row_rises.resize(static_cast<std::size_t>(height));
    tied_rises.resize(static_cast<std::size_t>(height));
    row_depths.resize(static_cast<std::size_t>(height));
    for (int x = 0; x < width; ++x) slopes[x] = projection.slope(x);
    for (int y = 0; y < height; ++y) {
        row_rises[y] = projection.row_from_horizon(y);
        tied_rises[y] = projection.row_climb(y).rise;
        row_depths[y] = focal_y / row_rises[y];
    }
    column_scale = width / (2 * projection.half_fov_tangent());
    row_at_eye = horizon + 0.5 + kTieClimb * focal_y;
    row_doubt = 2 * kDepthDoubt * (std::fabs(horizon) + height + 1);  // twice: for all other roundings together
}

namespace {

void set_depths(ProjectedWall& w, const Segment& wall, const Pose& pose, const RayTables& screen) {
    w.cross = std::max(exact_cross(wall.a, wall.b, pose.eye), 0.0);
    w.inverse_cross = 1 / w.cross;
    const double steepest = std::max(std::fabs(screen.slopes[static_cast<std::size_t>(w.begin)]),
                                     std::fabs(screen.slopes[static_cast<std::size_t>(w.end - 1)]));
    w.sure_span = edge_doubt(w.across_v, steepest) / kDepthDoubt;
    const double rounding = edge_doubt(w.left_v, 0) + edge_doubt(w.right_v, 0);
    w.nearest = std::max(std::min(w.left_v.y, w.right_v.y) - rounding, 0.0);
    w.farthest = std::max({w.left_v.y, w.right_v.y, 0.0}) + rounding;
}

}  // namespace

WallHit hit(const ProjectedWall& w, double slope) {
    if (w.stands_in) return {w.nearest, w.missed_along};
    const double span = edge_span(w, slope);
    if (!(span > 0)) return {w.farthest, w.swapped ? 1.0 : 0.0};  // only where the wall does not cover the column
    const double along = std::clamp(edge(w.left_v, slope) / span, 0.0, 1.0);
    const bool is_swapped = (built_in::kMirrors || built_in::kPanels) && w.swapped;
    return {std::clamp(w.cross / span, w.nearest, w.farthest), is_swapped ? 1 - along : along};
}

void project(const Map& map, SectorId sector, const Pose& pose, const RayTables& screen,
             std::vector<ProjectedWall>& out) {
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

RayDepth exact_depth(const Segment& segment, const Pose& pose, const RayTables& screen, int x) {
    return depth_on_wall(segment.a, segment.b, pose, ray_normal(pose, screen.slopes[static_cast<std::size_t>(x)]));
}

ProjectedWall project(const Segment& facing, const Pose& pose, const RayTables& screen) {
    const FacingWall ends = facing_wall(facing, pose);
    const CoveredColumns covered = covered_columns(ends, pose, {screen.slopes, screen.column_scale});
    ProjectedWall w;
    w.left_v = ends.left_v;
    w.right_v = ends.right_v;
    w.across_v = ends.across_v;
    w.swapped = ends.swapped;
    w.begin = covered.begin;
    w.end = covered.end;
    if (w.begin < w.end) set_depths(w, facing, pose, screen);
    return w;
}

ProjectedWall least_missed(const Map& map, SectorId sector, const Pose& pose, const RayTables& screen, int column,
                           WallId entry) {
    const StandIn missed = stand_in(map, sector, pose, screen.slopes[static_cast<std::size_t>(column)], entry);
    ProjectedWall wall = project(map[missed.wall], pose, screen);
    wall.wall = missed.wall;
    wall.begin = column;
    wall.end = column + 1;
    wall.stands_in = true;
    wall.nearest = wall.farthest = missed.depth;
    wall.missed_along = missed.along;
    return wall;
}

namespace {

/// What is kept of one frame: 120 MB of walls, and as many sectors as the largest views look into a hundred times.
constexpr std::size_t kMostWalls = std::size_t{1} << 20, kMostProjections = std::size_t{1} << 16;

}  // namespace

void ProjectionCache::start_frame() {
    used_ = 0;
    walls_ = 0;
    if (++frame_ == 0) {  // after 2^32 frames old marks would look new
        slots_.assign(slots_.size(), {});
        frame_ = 1;
    }
}

const std::vector<ProjectedWall>& ProjectionCache::get(const Map& map, SectorId sector, int pose_index,
                                                       const Pose& pose, const RayTables& screen) {
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(pose_index)} << 32 | sector.index;
    TableSlot* slot = &find(key);
    if (slot->frame == frame_) return projections_[slot->projection];
    if (walls_ > kMostWalls || used_ > kMostProjections) {
        start_frame();
        slot = &find(key);
    }
    if (2 * (used_ + 1) > slots_.size()) {
        grow();
        slot = &find(key);
    }
    if (used_ == projections_.size()) projections_.emplace_back();
    *slot = {key, frame_, used_};
    project(map, sector, pose, screen, projections_[used_]);
    walls_ += projections_[used_].size();
    return projections_[used_++];
}

ProjectionCache::TableSlot& ProjectionCache::find(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (key * 0x9E3779B97F4A7C15u) >> 32;  // Fibonacci hashing: the golden ratio spreads close keys
    while (slots_[i & mask].frame == frame_ && slots_[i & mask].key != key) ++i;
    return slots_[i & mask];
}

void ProjectionCache::grow() {
    const std::vector<TableSlot> old = std::exchange(slots_, std::vector<TableSlot>(slots_.size() * 2));
    for (const TableSlot& slot : old)
        if (slot.frame == frame_) find(slot.key) = slot;
}

}  // namespace enfilade::column
