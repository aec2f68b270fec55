#include "render/stencil/wall_on_screen.h"

#include <algorithm>
#include <limits>

#include "math/predicates.h"

namespace enfilade::stencil {
namespace {

/// The tie rule for an eye that stands on a vertex: the eye counts as (e, e^2) farther, so the vertex lies in the
/// direction -(1, e). 2^-40 is flatter than any wall of the vertex grid, and 2^-64 [m] is nothing beside any wall.
constexpr Vec2 kVertexAtEye{-0x1p-64, -0x1p-104};

/// Stands for 1 / 0 and still leaves room for products with any height and focal length [1/m].
constexpr double kNoDistance = 1e100;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 to_view(Vec2 vertex, const Eye& eye) {
    Vec2 d = vertex - eye.place;
    if (d == Vec2{}) d = kVertexAtEye;
    return {dot(eye.right, d), dot(eye.forward, d) + 0.0};  // + 0: turns -0, which would be behind, into 0
}

/// Column of a vertex in view space, moved by the tie rule: to the left where the ray through it counts as running to
/// its right. With the eye at eye + (e, e^2) all edge functions change by -(n.x e + n.y e^2), n = slope forward -
/// right.
double column_of(Vec2 v, const Eye& eye, const Screen& screen) {
    const double slope = v.x / v.y;
    const Vec2 normal = eye.forward * slope - eye.right;
    const bool runs_right = normal.x != 0 ? normal.x < 0 : normal.y < 0;
    return screen.px_of(slope) + (runs_right ? -kTieShift : kTieShift);
}

/// Behind the eye a vertex bounds the columns from the other side: there its edge function falls with the slope.
void set_columns(WallOnScreen& w, const Eye& eye, const Screen& screen) {
    const double left = column_of(w.left_v, eye, screen), right = column_of(w.right_v, eye, screen);
    const bool left_ahead = w.left_v.y >= 0, right_ahead = w.right_v.y >= 0;
    const double begin = std::max(left_ahead ? left : -kInfinity, right_ahead ? -kInfinity : right);
    const double end = std::min(left_ahead ? kInfinity : left, right_ahead ? right : kInfinity);
    w.begin_px = std::max(begin, -kMargin);
    w.end_px = std::min(end, screen.width + kMargin);
}

}  // namespace

Screen::Screen(const Projection& projection)
    : width(projection.width()),
      height(projection.height()),
      slope_per_px(2 * projection.half_fov_tangent() / projection.width()),
      focal_y(projection.focal_y()),
      horizon(projection.horizon()) {}

double WallOnScreen::inverse_depth(double slope) const {
    return cross > 0 ? std::min(span(slope) / cross, kNoDistance) : kNoDistance;
}

double WallOnScreen::nearest() const { return std::max(std::min(left_v.y, right_v.y), 0.0); }
double WallOnScreen::farthest() const { return std::max({left_v.y, right_v.y, 0.0}); }

std::optional<WallOnScreen> on_screen(const Map& map, WallId id, const Eye& eye, const Screen& screen) {
    const Wall& wall = map[id];
    if (side_of_line(wall.a, wall.b, eye.place) < 0) return {};
    WallOnScreen w;
    w.wall = id;
    w.swapped = eye.flip < 0;
    w.left_v = to_view(w.swapped ? wall.b : wall.a, eye);
    w.right_v = to_view(w.swapped ? wall.a : wall.b, eye);
    w.cross = std::max(exact_cross(wall.a, wall.b, eye.place), 0.0);
    set_columns(w, eye, screen);
    if (!(w.begin_px < w.end_px)) return {};
    return w;
}

double row_of(const Screen& screen, const WallOnScreen& wall, double height, double px) {
    return screen.horizon + kTieShift - height * screen.focal_y * wall.inverse_depth(screen.slope_at(px));
}

bool cut_at_entry(const Map& map, const Wall& entry, const Eye& eye, const Screen& screen, WallOnScreen& wall) {
    const Wall& w = map[wall.wall];
    const int a = corner(entry.a, entry.b, w.a), b = corner(entry.a, entry.b, w.b);
    if (a <= 0 && b <= 0) return false;
    if (a >= 0 && b >= 0) return true;
    const Vec2 along = entry.b - entry.a;
    const double at_a = dot(right_of(along), w.a - entry.a), at_b = dot(right_of(along), w.b - entry.a);
    const Vec2 cut = to_view(w.a + (w.b - w.a) * (at_a / (at_a - at_b)), eye);
    WallOnScreen rest = wall;
    const bool cuts_left = (a < 0) != wall.swapped;
    (cuts_left ? rest.left_v : rest.right_v) = cut;
    set_columns(rest, eye, screen);
    wall.begin_px = std::max(wall.begin_px, rest.begin_px);
    wall.end_px = std::min(wall.end_px, rest.end_px);
    return wall.begin_px < wall.end_px;
}

bool is_beyond(const Wall& wall, const Wall& entry) {
    const int a = corner(entry.a, entry.b, wall.a), b = corner(entry.a, entry.b, wall.b);
    if (a <= 0 && b <= 0) return false;
    if (a >= 0 && b >= 0) return true;
    return corner(wall.a, wall.b, entry.a) >= 0 && corner(wall.a, wall.b, entry.b) >= 0;
}

}  // namespace enfilade::stencil
