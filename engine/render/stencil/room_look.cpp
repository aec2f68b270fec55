#include "render/stencil/room_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::stencil {
namespace {

/// Rows are decided by the graphics card, whose edges are on a grid: what comes nearer to a pixel's centre than this
/// may turn out to cover it, or not to [px].
constexpr double kSlack = 4 * kTieShift;

/// Of two portals whose depths differ by less than this part, rounding could say either is nearer: both are followed.
constexpr double kTie = 1e-9;

/// The first row, not before `least`, whose centre is at or after `px`; `most` if there is none.
int first_at(double px, int least, int most) {
    const double first = std::ceil(px - 0.5);
    return first >= most ? most : first > least ? static_cast<int>(first) : least;
}

/// Where in a column a wall's depth is asked for: in its middle, or if it stands for a range, at both of its ends [px].
std::pair<double, double> ends_of_column(const WallOnScreen& wall, const Screen& screen, int x) {
    if (!screen.has_ranges) return {x + 0.5, x + 0.5};
    return {std::clamp(double(x), wall.begin_px, wall.end_px), std::clamp(x + 1.0, wall.begin_px, wall.end_px)};
}

struct InverseDepths {
    double least, most;
};

InverseDepths inverse_depths(const WallOnScreen& wall, const Screen& screen, int x) {
    const auto [left, right] = ends_of_column(wall, screen, x);
    const double a = wall.inverse_depth(screen.slope_at(left)), b = wall.inverse_depth(screen.slope_at(right));
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

void RoomLook::look(const Visit& visit, const Pose& pose) {
    visit_ = &visit;
    walls_.clear();
    nearest_.assign(visit.window.rows.size(), {});
    const Sector& sector = map_[visit.sector];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const WallId id(i);
        const auto wall = on_screen(map_, id, pose, screen_, visit.entry ? &visit.doorway : nullptr);
        if (!wall) continue;
        if (wall->end <= visit.window.begin || wall->begin >= visit.window.end()) continue;
        if (visit.entry && (visit.entry == id || !is_beyond(map_[id], map_[visit.entry]))) continue;
        walls_.push_back(*wall);
        offer(*wall);
    }
}

void RoomLook::offer(const WallOnScreen& wall) {
    const CoveredColumns sure = surely_covered(wall, screen_);
    const int end = std::min(sure.end, visit_->window.end());
    for (int x = std::max(sure.begin, visit_->window.begin); x < end; ++x) {
        Nearest& nearest = nearest_[index_of(x)];
        const double inverse = inverse_depths(wall, screen_, x).least;
        if (is_nearer_at(wall, inverse, nearest)) nearest = {wall.wall, inverse};
    }
}

bool RoomLook::is_nearer_at(const WallOnScreen& wall, double inverse, const Nearest& other) const {
    if (other.wall.is_none() || screen_.has_ranges || are_telling(inverse, other.inverse_depth))
        return other.wall.is_none() || inverse > other.inverse_depth;
    return is_nearer(map_[wall.wall], map_[other.wall]);
}

Window RoomLook::open_behind(const WallOnScreen& portal, const Heights& opening, double& nearest) const {
    Window beyond;
    nearest = 0;
    const int end = std::min(portal.end, visit_->window.end());
    for (int x = std::max(portal.begin, visit_->window.begin); x < end; ++x) {
        const double inverse = inverse_depths(portal, screen_, x).most;
        if (inverse < inverse_depth_at(x) * (1 - kTie)) continue;
        const OpenRows rows = rows_behind(portal, opening, x);
        if (rows.is_closed()) continue;
        beyond.open(x, rows);
        nearest = std::max(nearest, inverse);
    }
    return beyond;
}

OpenRows RoomLook::rows_behind(const WallOnScreen& portal, const Heights& opening, int x) const {
    const OpenRows parent = visit_->window.at(x);
    if (parent.is_closed()) return {};
    const auto [left, right] = ends_of_column(portal, screen_, x);
    const double slack = kSlack + (screen_.has_ranges ? 0.5 : 0);
    const double top =
        std::min(row_of(screen_, portal, opening.ceiling, left), row_of(screen_, portal, opening.ceiling, right));
    const double bottom =
        std::max(row_of(screen_, portal, opening.floor, left), row_of(screen_, portal, opening.floor, right));
    return {first_at(top - slack, parent.top, parent.bottom), first_at(bottom + slack, parent.top, parent.bottom)};
}

}  // namespace enfilade::stencil
