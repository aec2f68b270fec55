#include "render/column/viewport.h"

#include <algorithm>
#include <cmath>

#include "render/built_in.h"

namespace enfilade::column {
namespace {

/// The first stretch that ends beyond column x.
std::vector<WallColumns>::const_iterator first_ending_after(const std::vector<WallColumns>& stretches, int x) {
    return std::lower_bound(stretches.begin(), stretches.end(), x,
                            [](const WallColumns& stretch, int column) { return stretch.end <= column; });
}

double between(double value, double low, double high) {
    const double not_below = value > low ? value : low;
    return not_below < high ? not_below : high;
}

}  // namespace

bool Viewport::trim() {
    int first = begin, last = end;
    while (first < last && rows_at(first).is_closed()) ++first;
    while (first < last && rows_at(last - 1).is_closed()) --last;
    rows.erase(rows.begin() + (last - begin), rows.end());
    rows.erase(rows.begin(), rows.begin() + (first - begin));
    boundary.erase(boundary.begin() + (last - begin), boundary.end());
    boundary.erase(boundary.begin(), boundary.begin() + (first - begin));
    begin = first;
    end = last;
    return begin < end;
}

Viewport& ViewportPool::take(int begin, int end) {
    if (used_ == viewports_.size()) viewports_.emplace_back();
    Viewport& viewport = viewports_[used_++];
    viewport.begin = begin;
    viewport.end = end;
    viewport.straying = {};
    viewport.doorway = {};
    const auto count = static_cast<std::size_t>(end - begin);
    viewport.rows.assign(count, {});
    viewport.boundary.assign(count, 0);
    return viewport;
}

void NearestWalls::choose(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose,
                          std::span<const ProjectedWall> walls) {
    walls_ = walls;
    lost_.clear();
    stretches_.clear();
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const int begin = std::max(walls[i].begin, viewport.begin), end = std::min(walls[i].end, viewport.end);
        if (begin >= end) continue;
        if (viewport.entry) {
            // Compared with the entry as a whole and exactly, so that the boundary holds in all its columns at once.
            if (walls[i].wall == viewport.entry || !is_beyond(map[walls[i].wall], map[viewport.entry])) continue;
        }
        offer(map, screen, {begin, end, static_cast<int>(i)});
    }
    find_lost(map, screen, viewport, pose);
}

void NearestWalls::offer(const Map& map, const RayTables& screen, WallColumns offered) {
    if (stretches_.empty() || stretches_.back().end <= offered.begin) return stretches_.push_back(offered);
    const auto first = first_ending_after(stretches_, offered.begin);
    if (offered.end <= first->begin)
        stretches_.insert(first, offered);
    else
        merge(map, screen, static_cast<std::size_t>(first - stretches_.begin()), offered);
}

/// first: of the stretches that share a column with the offered one.
void NearestWalls::merge(const Map& map, const RayTables& screen, std::size_t first, WallColumns offered) {
    merged_.clear();
    std::size_t last = first;
    int x = offered.begin;
    for (; last < stretches_.size() && stretches_[last].begin < offered.end; ++last) {
        const WallColumns& old = stretches_[last];
        const WallColumns shared{std::max(old.begin, offered.begin), std::min(old.end, offered.end), old.wall};
        add(old.begin, offered.begin, old.wall);
        add(x, old.begin, offered.wall);
        add(shared.begin, shared.end, is_nearer_in(map, screen, offered.wall, shared) ? offered.wall : old.wall);
        add(offered.end, old.end, old.wall);
        x = shared.end;
    }
    add(x, offered.end, offered.wall);
    const auto begin = stretches_.begin();
    const auto place =
        stretches_.erase(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
    stretches_.insert(place, merged_.begin(), merged_.end());
}

void NearestWalls::add(int begin, int end, int wall) {
    if (begin >= end) return;
    if (!merged_.empty() && merged_.back().wall == wall && merged_.back().end == begin)
        merged_.back().end = end;
    else
        merged_.push_back({begin, end, wall});
}

/// In the middle of their columns inverse depths mostly tell; where they do not, the walls' ends do.
bool NearestWalls::is_nearer_in(const Map& map, const RayTables& screen, int candidate,
                                const WallColumns& shared) const {
    const double slope = screen.slopes[static_cast<std::size_t>((shared.begin + shared.end) / 2)];
    const ProjectedWall &a = wall(candidate), &b = wall(shared.wall);
    const double inverse = inverse_depth(a, slope), other = inverse_depth(b, slope);
    const double doubt = inverse_depth_doubt(a, slope) + inverse_depth_doubt(b, slope);
    return are_telling(inverse, other, doubt) ? inverse > other : is_nearer(map[a.wall], map[b.wall]);
}

void NearestWalls::find_lost(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose) {
    merged_.assign(stretches_.begin(), stretches_.end());
    stretches_.clear();
    int x = viewport.begin;
    for (const WallColumns& found : merged_) {
        lose(map, screen, viewport, pose, x, found.begin);
        stretches_.push_back(found);
        x = found.end;
    }
    lose(map, screen, viewport, pose, x, viewport.end);
}

/// Finds what stands in for a wall in each open column that none covers.
void NearestWalls::lose(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose, int begin,
                        int end) {
    for (int x = begin; x < end; ++x) {
        if (viewport.rows_at(x).is_closed()) continue;
        stretches_.push_back({x, x + 1, static_cast<int>(count())});
        lost_.push_back(least_missed(map, viewport.sector, pose, screen, x, viewport.entry));
    }
}

int NearestWalls::at(int x) const {
    const auto found = first_ending_after(stretches_, x);
    return found != stretches_.end() && found->begin <= x ? found->wall : kNoWall;
}

RayDepth WallLooks::exact_depth(int i) const {
    if (wall->stands_in) return {depth[i]};
    return column::exact_depth(Segment(a, b), *pose, *screen, begin + i);
}

namespace {

/// Columns in which a wall is so narrow, or seen so much on edge, that rounded numbers are in doubt.
void look_exactly(const ProjectedWall& wall, WallLooks& looks) {
    for (int i = 0; i < looks.count; ++i) {
        const double slope = looks.screen->slopes[static_cast<std::size_t>(looks.begin + i)];
        if (edge_span(wall, slope) >= wall.sure_span) continue;
        const RayNormal ray = ray_normal(*looks.pose, slope);
        const RayDepth exact = depth_on_wall(looks.a, looks.b, *looks.pose, ray);
        const double from_a = static_cast<double>(offset_left(ray, looks.a, looks.pose->eye));
        const double along = between(std::fabs(from_a) / static_cast<double>(exact.across), 0, 1);
        const bool is_turned_panel = wall.swapped != (looks.pose->flip < 0);
        looks.depth[i] = between(exact.value, wall.nearest, wall.farthest);
        looks.along[i] = is_turned_panel ? 1 - along : along;
        looks.inverse_depth[i] = 1 / exact.value;
    }
}

}  // namespace

void look_at(const ProjectedWall& wall, const Segment& segment, const Pose& pose, const RayTables& screen, int begin,
             int count, WallLooks& looks) {
    looks.wall = &wall;
    looks.pose = &pose;
    looks.screen = &screen;
    looks.a = segment.a;
    looks.b = segment.b;
    looks.begin = begin;
    looks.count = count;
    looks.farthest = wall.farthest;
    const double* const slopes = &screen.slopes[static_cast<std::size_t>(begin)];
    if (wall.stands_in) {
        looks.depth[0] = wall.nearest;
        looks.along[0] = wall.missed_along;
        looks.inverse_depth[0] = 1 / wall.nearest;
        return;
    }
    const ProjectedWall w = wall;
    const bool is_swapped = (built_in::kMirrors || built_in::kPanels) && w.swapped;
    for (int i = 0; i < count; ++i) {
        const double left = edge(w.left_v, slopes[i]);
        const double span = edge(w.across_v, slopes[i]);
        const double along = between(left / span, 0, 1);
        looks.depth[i] = between(w.cross / span, w.nearest, w.farthest);
        looks.along[i] = is_swapped ? 1 - along : along;
        looks.inverse_depth[i] = span * w.inverse_cross;
    }
    // The span is linear in the slope, so it is smallest at an end.
    const double least = std::min(edge_span(w, slopes[0]), edge_span(w, slopes[count - 1]));
    if (least < 2 * w.sure_span) look_exactly(wall, looks);
}

/// By the definition, from a row that is at most a few off.
int RowsAt::settle(double height, int y, int top, int bottom) const {
    const RayDepth depth = looks_ ? looks_->exact_depth(i_) : RayDepth{depth_};
    const auto is_below = [&](int row) {
        return !reaches({screen_.tied_rises[static_cast<std::size_t>(row)], focal_y_}, depth, height);
    };
    y = std::min(y, bottom);
    while (y > top && is_below(y - 1)) --y;
    while (y < bottom && !is_below(y)) ++y;
    return y;
}

void split_rows(const RayTables& screen, const WallLooks& looks, const OpenRows* open, const RelativeHeights& here,
                const RelativeHeights* behind, RowSplits& rows) {
    rows.has_ceiling = rows.has_upper = rows.has_lower = rows.has_floor = false;
    for (int i = 0; i < looks.count; ++i) {
        const RowSplit split = split_rows(RowsAt(screen, looks, i), open[i], here, behind);
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
