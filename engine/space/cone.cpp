#include "space/reach.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// u before v, clockwise as seen from p (both less than half a turn apart).
bool is_left_of(Vec2 u, Vec2 v, Vec2 p) { return u != v && side_of_line(u, v, p) > 0; }

bool is_in(const Cone& cone, Vec2 v, Vec2 p) {
    return (v == cone.left || is_left_of(cone.left, v, p)) && is_left_of(v, cone.right, p);
}

/// Where p itself is the corner looked at, the tie rule moves p by (e, e^2), and the corner lies this way.
constexpr Vec2 kTowardsOwnPoint{-1, 0};

Vec2 direction_to(Vec2 v, Vec2 p) { return v == p ? kTowardsOwnPoint : v - p; }

Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

/// How many times `ahead` leads from p to the line of the wall, which it approaches from the wall's own side.
double lengths_to_wall(const Face& wall, Vec2 p, Vec2 ahead) {
    return exact_cross(wall.a, wall.b, p) / -cross(wall.b - wall.a, ahead);
}

/// Where the look from p past the corner v meets the wall; `end` where the two are all but parallel.
Vec2 seen_past(const Face& wall, Vec2 p, Vec2 v, Vec2 end) {
    const Vec2 ahead = direction_to(v, p);
    const double lengths = lengths_to_wall(wall, p, ahead);
    return lengths >= 0 && lengths * std::sqrt(dot(ahead, ahead)) < kWorldLimit ? p + ahead * lengths : end;
}

}  // namespace

std::optional<Cone> cone_of(const Face& wall, Vec2 p, const std::optional<Cone>& window) {
    if (side_of_line(wall.a, wall.b, p) < 0) return {};
    const Cone whole{wall.a, wall.b};
    if (!window) return whole;
    Cone seen = whole;
    if (!is_in(*window, wall.a, p)) {
        if (!is_in(whole, window->left, p)) return {};
        seen.left = window->left;
    }
    if (is_in(whole, window->right, p)) seen.right = window->right;
    return seen;
}

bool is_within(const Cone& cone, const Cone& wide, Vec2 p) {
    return (cone.left == wide.left || is_left_of(wide.left, cone.left, p)) &&
           (cone.right == wide.right || is_left_of(cone.right, wide.right, p));
}

ShortList<Cone, 2> without(const Cone& cone, const Cone& other, Vec2 p) {
    ShortList<Cone, 2> left;
    const bool starts_before = !is_in(other, cone.left, p);
    if (starts_before) left.push_back({cone.left, is_in(cone, other.left, p) ? other.left : cone.right});
    const bool ends_after = other.right != cone.left && is_in(cone, other.right, p);
    if (ends_after) left.push_back({other.right, cone.right});
    return left;
}

Stretch stretch_in(const Face& wall, Vec2 p, const Cone& cone) {
    return {cone.left == wall.a ? wall.a : seen_past(wall, p, cone.left, wall.a),
            cone.right == wall.b ? wall.b : seen_past(wall, p, cone.right, wall.b)};
}

Vec2 nearest_point(const Stretch& stretch, Vec2 p) {
    const Vec2 along = stretch.b - stretch.a;
    const double length_squared = dot(along, along);
    if (length_squared == 0) return stretch.a;
    return stretch.a + along * std::clamp(dot(p - stretch.a, along) / length_squared, 0.0, 1.0);
}

bool is_beyond(const Face& wall, const Face& window_wall, Vec2 p, const Cone& cone) {
    const int a = corner(window_wall.a, window_wall.b, wall.a), b = corner(window_wall.a, window_wall.b, wall.b);
    if (a <= 0 && b <= 0) return false;
    if (a >= 0 && b >= 0) return true;
    // The wall crosses the window's line beside the window: one look down the middle of the cone tells.
    const Vec2 ahead = unit(direction_to(cone.left, p)) + unit(direction_to(cone.right, p));
    const Vec2 window_along = window_wall.b - window_wall.a;
    const double to_window = exact_cross(window_wall.a, window_wall.b, p) / -cross(window_along, ahead);
    return lengths_to_wall(wall, p, ahead) > to_window;
}

bool is_panel_beyond(const Face& panel, const Face& window_wall, Vec2 p, const Cone& cone) {
    const bool is_in_it =
        corner(window_wall.a, window_wall.b, panel.a) == 0 && corner(window_wall.a, window_wall.b, panel.b) == 0;
    return is_in_it || is_beyond(panel, window_wall, p, cone);
}

}  // namespace enfilade
