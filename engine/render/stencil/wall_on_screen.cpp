#include "render/stencil/wall_on_screen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/predicates.h"
#include "render/openings.h"

namespace enfilade::stencil {

Screen::Screen(const Projection& projection)
    : width(projection.width()),
      height(projection.height()),
      slope_per_px(2 * projection.half_fov_tangent() / projection.width()),
      middle_px(projection.middle_column() + 0.5),
      focal_y(projection.focal_y()),
      horizon(projection.horizon()) {
    for (int x = 0; x < width; ++x) slopes.push_back(projection.slope(x));
}

namespace {

/// Stands for 1 / 0 and still leaves room for products with any height and focal length [1/m].
constexpr double kNoDistance = 1e100;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A range of rays is only left out if it is missed by more than rounding, behind a link, too [px].
constexpr double kRangeSlack = 1.0 / 64;

/// Ends of walls this near to the ends of the doorway one looks in through are in line with them [1]: behind a link the
/// eye is rounded onto its grid, and a wall might stop a rounding short of the doorway.
constexpr double kSameLine = 0x1p-16;

double column_of(Vec2 v, const Screen& screen) {
    return screen.px_of(v.x / (v.y + 0.0));  // + 0: turns -0, which would be behind, into 0
}

/// Behind the eye a vertex bounds the columns from the other side: there its edge function falls with the slope.
void set_ends(WallOnScreen& w, const Screen& screen) {
    const double left = column_of(w.left_v, screen), right = column_of(w.right_v, screen);
    const bool left_ahead = w.left_v.y >= 0, right_ahead = w.right_v.y >= 0;
    const double begin = std::max(left_ahead ? left : -kInfinity, right_ahead ? -kInfinity : right);
    const double end = std::min(left_ahead ? kInfinity : left, right_ahead ? right : kInfinity);
    w.begin_px = std::clamp(begin, -kMargin, screen.width + kMargin);
    w.end_px = std::clamp(end, -kMargin, screen.width + kMargin);
    if (w.begin_px - kRangeSlack < w.end_px) w.end_px = std::max(w.begin_px, w.end_px);  // seen from its end
}

}  // namespace

double WallOnScreen::inverse_depth(double slope) const {
    if (missed) return std::min(1 / missed->depth, kNoDistance);
    return cross > 0 ? std::min(span(slope) / cross, kNoDistance) : kNoDistance;
}

double WallOnScreen::nearest() const { return std::max(std::min(left_v.y, right_v.y), 0.0); }
double WallOnScreen::farthest() const { return std::max({left_v.y, right_v.y, 0.0}); }

WallOnScreen in_view(const Segment& facing, const Pose& pose) {
    WallOnScreen w;
    const FacingWall ends = facing_wall(facing, pose);
    w.swapped = ends.swapped;
    w.ends = ends;
    w.left_v = w.shown_left_v = ends.left_v;
    w.right_v = w.shown_right_v = ends.right_v;
    w.cross = std::max(exact_cross(facing.a, facing.b, pose.eye), 0.0);
    return w;
}

std::optional<WallOnScreen> in_view(const Map& map, WallId id, const Pose& pose) {
    const Wall& wall = map[id];
    if (side_of_line(wall.a, wall.b, pose.eye) < 0) return {};
    WallOnScreen w = in_view(wall, pose);
    w.wall = id;
    return w;
}

bool put_on_screen(WallOnScreen& w, const Pose& pose, const Screen& screen) {
    set_ends(w, screen);
    if (screen.has_ranges) {
        w.begin = std::max(static_cast<int>(std::floor(w.begin_px - kRangeSlack)), 0);
        w.end = std::min(static_cast<int>(std::ceil(w.end_px + kRangeSlack)), screen.width);
    } else {
        const CoveredColumns exact = covered_columns(w.ends, pose, {screen.slopes, screen.per_slope()});
        w.begin = exact.begin;
        w.end = exact.end;
    }
    return w.begin < w.end;
}

std::optional<WallOnScreen> on_screen(const Map& map, WallId id, const Pose& pose, const Screen& screen,
                                      const WallOnScreen* doorway) {
    auto wall = in_view(map, id, pose);
    if (!wall) return {};
    put_on_screen(*wall, pose, screen);
    if (doorway && screen.has_ranges) extend_beyond(*wall, *doorway);
    if (wall->begin >= wall->end) return {};
    return wall;
}

namespace {

bool vanishes_in(const WallOnScreen& wall, const Screen& screen, int x) {
    return !wall.missed && std::min(wall.span(screen.slope_at(x)), wall.span(screen.slope_at(x + 1))) <= 0;
}

/// Where the ray, which meets the wall, does so.
Missed met_at(const WallOnScreen& wall, const Pose& pose, double slope) {
    const FacingWall& ends = wall.ends;
    const bool is_mirrored = pose.flip < 0;
    const RayNormal ray = ray_normal(pose, slope);
    const RayDepth depth =
        depth_on_wall(is_mirrored ? ends.right : ends.left, is_mirrored ? ends.left : ends.right, pose, ray);
    const double from_left = std::fabs(static_cast<double>(offset_left(ray, ends.left, pose.eye)));
    const double along = std::clamp(from_left / static_cast<double>(depth.across), 0.0, 1.0);
    return {depth.value, wall.swapped ? 1 - along : along, {0, 1}};
}

}  // namespace

std::vector<WallOnScreen> parts_of_run(const WallOnScreen& wall, const Pose& pose, const Screen& screen, int begin,
                                       int end) {
    std::vector<WallOnScreen> parts;
    const auto add = [&](int from, int to) {
        if (from >= to) return;
        parts.push_back(wall);
        parts.back().begin = from;
        parts.back().end = to;
    };
    const auto add_alone = [&](int x) {
        add(x, x + 1);
        parts.back().missed = met_at(wall, pose, screen.slopes[static_cast<std::size_t>(x)]);
    };
    const bool vanishes_left = vanishes_in(wall, screen, begin);
    const bool vanishes_right = vanishes_in(wall, screen, end - 1) && (end - begin > 1 || !vanishes_left);
    if (vanishes_left) add_alone(begin);
    add(begin + vanishes_left, end - vanishes_right);
    if (vanishes_right) add_alone(end - 1);
    return parts;
}

bool are_in_line(Vec2 p, Vec2 q) {
    return std::fabs(cross(p, q)) <= kSameLine * std::sqrt(dot(p, p) * dot(q, q)) && dot(p, q) > 0;
}

void extend_beyond(WallOnScreen& wall, const WallOnScreen& doorway) {
    if (are_in_line(wall.left_v, doorway.left_v)) {
        if (wall.left_v.y > 0) --wall.begin;  // behind the eye it begins nowhere
        wall.is_open_left = true;
    }
    if (are_in_line(wall.right_v, doorway.right_v)) {
        if (wall.right_v.y > 0) ++wall.end;
        wall.is_open_right = true;
    }
}

CoveredColumns surely_covered(const WallOnScreen& wall, const Screen& screen) {
    if (!screen.has_ranges) return {wall.begin, wall.end};
    return {std::max(static_cast<int>(std::ceil(wall.begin_px + kRangeSlack)), 0),
            std::min(static_cast<int>(std::floor(wall.end_px - kRangeSlack)), screen.width)};
}

double row_of(const Screen& screen, const WallOnScreen& wall, double height, double px) {
    return screen.horizon - height * screen.focal_y * wall.inverse_depth(screen.slope_at(px));
}

RelativeHeights heights_of(const Snapshot& snapshot, SectorId room, double eye_z) {
    const Heights heights = heights_at(snapshot, room);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

WallParts parts_of(const Map& map, const Snapshot& snapshot, WallId id, double eye_z) {
    const Wall& wall = map[id];
    const WallKind kind = kind_now(map, snapshot, id);
    WallParts parts;
    parts.room = parts.behind = heights_of(snapshot, wall.sector, eye_z);
    if (kind == WallKind::solid) return parts;
    parts.opening = parts.room;
    if (kind == WallKind::mirror) return parts;
    parts.behind = heights_of(snapshot, wall.behind, map.passage(wall).apply_height(eye_z));
    parts.upper = has_upper_step(map, wall);
    parts.lower = has_lower_step(map, wall);
    const double top = std::clamp(parts.behind.ceiling, parts.room.floor, parts.room.ceiling);
    if (parts.upper) parts.opening.ceiling = top;
    if (parts.lower) parts.opening.floor = std::clamp(parts.behind.floor, parts.room.floor, top);
    return parts;
}

double peg_height(const WallParts& parts, Peg peg) {
    switch (peg) {
        case Peg::ceiling: return parts.room.ceiling;
        case Peg::floor: return parts.room.floor;
        case Peg::opening_top: return std::min(parts.room.ceiling, parts.behind.ceiling);
        case Peg::opening_bottom: return std::max(parts.room.floor, parts.behind.floor);
    }
    return parts.room.ceiling;
}

RelativeHeights picture_in(const WallParts& parts, const Surface& middle) {
    const bool stands = middle.peg == Peg::floor || middle.peg == Peg::opening_bottom;
    const double anchor = peg_height(parts, middle.peg) + (stands ? middle.tile_m.y : 0);
    const double top = anchor - middle.offset_tiles.y * middle.tile_m.y;
    return {top - middle.tile_m.y, top};
}

}  // namespace enfilade::stencil
