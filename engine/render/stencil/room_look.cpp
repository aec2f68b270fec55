#include "render/stencil/wall_on_screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/segment.h"

namespace enfilade::stencil {

void ClipWindow::open(int x, OpenRows more) {
    if (rows.empty()) begin = x;
    if (x < begin) {
        rows.insert(rows.begin(), static_cast<std::size_t>(begin - x), OpenRows{});
        begin = x;
    }
    if (x >= end()) rows.resize(static_cast<std::size_t>(x - begin) + 1);
    OpenRows& now = at(x);
    now = now.is_closed() ? more : OpenRows{std::min(now.top, more.top), std::max(now.bottom, more.bottom)};
}

void ClipWindow::open(const ClipWindow& other) {
    for (int x = other.begin; x < other.end(); ++x)
        if (!other.at(x).is_closed()) open(x, other.at(x));
}

bool ClipWindow::holds(const ClipWindow& other) const {
    for (int x = other.begin; x < other.end(); ++x) {
        if (other.at(x).is_closed()) continue;
        if (x < begin || x >= end() || at(x).top > other.at(x).top || at(x).bottom < other.at(x).bottom) return false;
    }
    return true;
}

ScreenBox box_around(const ClipWindow& window) {
    ScreenBox box{window.begin, window.end(), 0, 0};
    for (const OpenRows& rows : window.rows) {
        if (rows.is_closed()) continue;
        const bool is_first = box.begin_y >= box.end_y;
        box.begin_y = is_first ? rows.top : std::min(box.begin_y, rows.top);
        box.end_y = is_first ? rows.bottom : std::max(box.end_y, rows.bottom);
    }
    return box;
}

namespace {

/// Rows are decided by the graphics card, whose edges are on a grid: what comes nearer to a pixel's centre than this
/// may turn out to cover it, or not to [px].
constexpr double kSlack = 4 * kTieShift;

/// Of two portals of a range whose depths differ by less than this part, rounding could say either is nearer: both are
/// followed.
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
    pose_ = pose;
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
    first_stand_in_ = walls_.size();
    if (!screen_.has_ranges) find_stand_ins();
}

void RoomLook::find_stand_ins() {
    for (int x = visit_->window.begin; x < visit_->window.end(); ++x)
        if (nearest_at(x).is_none() && !visit_->window.at(x).is_closed()) stand_in(x);
}

void RoomLook::stand_in(int x) {
    const double slope = screen_.slopes[static_cast<std::size_t>(x)];
    const StandIn missed = enfilade::stand_in(map_, visit_->sector, pose_, slope, visit_->entry);
    WallOnScreen wall = *in_view(map_, missed.wall, pose_);
    wall.missed = {missed.depth, missed.along, {0, 1}};
    wall.begin = x;
    wall.end = x + 1;
    WallOnScreen* const before = walls_.size() > first_stand_in_ ? &walls_.back() : nullptr;
    if (before && before->end == x && before->wall == wall.wall && before->missed == wall.missed)
        before->end = wall.end;
    else
        walls_.push_back(wall);
    nearest_[index_of(x)] = {static_cast<int>(walls_.size()) - 1, wall.inverse_depth(slope), wall.doubt(slope)};
}

void RoomLook::offer(const WallOnScreen& wall) {
    const CoveredColumns sure = surely_covered(wall, screen_);
    const int end = std::min(sure.end, visit_->window.end());
    for (int x = std::max(sure.begin, visit_->window.begin); x < end; ++x) {
        Nearest& nearest = nearest_[index_of(x)];
        if (visit_->window.at(x).is_closed()) continue;
        const Nearest offered{static_cast<int>(walls_.size()) - 1, inverse_depths(wall, screen_, x).least,
                              wall.doubt(screen_.slopes[static_cast<std::size_t>(x)])};
        if (is_nearer_at(wall, offered, nearest)) nearest = offered;
    }
}

bool RoomLook::is_nearer_at(const WallOnScreen& wall, const Nearest& offered, const Nearest& other) const {
    if (other.place == kNothing) return true;
    if (screen_.has_ranges || are_telling(offered.inverse_depth, other.inverse_depth, offered.doubt + other.doubt))
        return offered.inverse_depth > other.inverse_depth;
    return is_nearer(map_[wall.wall], map_[walls_[static_cast<std::size_t>(other.place)].wall]);
}

void RoomLook::add_met(std::vector<WallOnScreen>& met) const {
    int begin = visit_->window.begin, before = kNothing;
    for (int x = begin; x <= visit_->window.end(); ++x) {
        const int place = x < visit_->window.end() ? nearest_[index_of(x)].place : kNothing;
        if (place == before) continue;
        if (before != kNothing) add_run(met, before, begin, x);
        begin = x;
        before = place;
    }
}

void RoomLook::add_run(std::vector<WallOnScreen>& met, int place, int begin, int end) const {
    for (const WallOnScreen& part : parts_of_run(walls_[static_cast<std::size_t>(place)], pose_, screen_, begin, end)) {
        met.push_back(part);
        met.back().rank = visit_->depth;
    }
}

/// Of ranges, portals are followed that any of their rays may meet.
bool RoomLook::may_meet(const WallOnScreen& portal, double inverse, int x) const {
    if (screen_.has_ranges) return inverse >= inverse_depth_at(x) * (1 - kTie);
    return nearest_[index_of(x)].place == &portal - walls_.data();
}

ClipWindow RoomLook::open_behind(const WallOnScreen& portal, const RelativeHeights& opening, double& nearest) const {
    ClipWindow beyond;
    nearest = 0;
    const int end = std::min(portal.end, visit_->window.end());
    for (int x = std::max(portal.begin, visit_->window.begin); x < end; ++x) {
        const double inverse = inverse_depths(portal, screen_, x).most;
        if (!may_meet(portal, inverse, x)) continue;
        const OpenRows rows = rows_behind(portal, opening, x);
        if (rows.is_closed()) continue;
        beyond.open(x, rows);
        nearest = std::max(nearest, inverse);
    }
    return beyond;
}

OpenRows RoomLook::rows_behind(const WallOnScreen& portal, const RelativeHeights& opening, int x) const {
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
