#include "render/stencil/outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::stencil {

void Outline::set(double left, double right, double top, double bottom) {
    corners_ = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

void Outline::keep(const Even& where) {
    cut_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const PixelPoint p = corners_[i], q = corners_[(i + 1) % corners_.size()];
        const double at_p = where.at(p.x, p.y), at_q = where.at(q.x, q.y);
        if (at_p >= 0) cut_.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const bool in_order = p.x < q.x || (p.x == q.x && p.y < q.y);
        const PixelPoint a = in_order ? p : q, b = in_order ? q : p;
        const double at_a = in_order ? at_p : at_q, at_b = in_order ? at_q : at_p, part = at_a / (at_a - at_b);
        cut_.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
    }
    std::swap(corners_, cut_);
}

namespace {

/// A wall that passes through the eye is met an instant after the start, so that an eye at the very height of a ceiling
/// still sees only its upper half covered [m^2].
constexpr double kAnInstant = 0x1p-500;

/// The same half plane, its edge moved outwards by so many pixels.
Even widened(const Even& edge, double px) {
    return {edge.at_0 + px * std::hypot(edge.per_x, edge.per_y), edge.per_x, edge.per_y};
}

}  // namespace

Even below(const RayField& rays, const WallOnScreen& wall, double height) {
    Even met = span(rays, wall);
    // Between its ends all rays meet a wall that passes through the eye, up to the very line where it vanishes.
    if (rays.is_tilted && wall.cross == 0) met = widened(met, 2 * kMargin);
    return met * height - climb(rays) * std::max(depth_factor(wall), kAnInstant);
}

Even climb(const RayField& rays) { return widened(rays.up, kTieShift); }

void set_between_ends(Outline& outline, const RayField& rays, const WallOnScreen& wall) {
    const double top = -kMargin, bottom = rays.height + kMargin;
    if (!rays.is_tilted) return outline.set(wall.begin, wall.end, top, bottom);
    outline.set(-kMargin, rays.width + kMargin, top, bottom);
    outline.keep(widened(edge(rays, wall.shown_left_v), kMargin));
    outline.keep(widened(edge(rays, wall.shown_right_v) * -1, kMargin));
}

void keep_between(Outline& outline, const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights) {
    if (!std::isinf(heights.ceiling)) outline.keep(below(rays, wall, heights.ceiling));
    if (!std::isinf(heights.floor)) outline.keep(below(rays, wall, heights.floor) * -1);
}

ScreenBox box_around(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights) {
    Outline outline;
    set_between_ends(outline, rays, wall);
    keep_between(outline, rays, wall, heights);
    if (outline.is_empty()) return {};
    const auto by_x = [](const PixelPoint& a, const PixelPoint& b) { return a.x < b.x; };
    const auto by_y = [](const PixelPoint& a, const PixelPoint& b) { return a.y < b.y; };
    const auto [left, right] = std::minmax_element(outline.corners().begin(), outline.corners().end(), by_x);
    const auto [top, bottom] = std::minmax_element(outline.corners().begin(), outline.corners().end(), by_y);
    const auto whole = [](double px, int most) { return static_cast<int>(std::clamp(px, 0.0, double(most))); };
    return {whole(std::floor(left->x), rays.width), whole(std::ceil(right->x), rays.width),
            whole(std::floor(top->y), rays.height), whole(std::ceil(bottom->y), rays.height)};
}

ScreenBox common(const ScreenBox& a, const ScreenBox& b) {
    return {std::max(a.begin_x, b.begin_x), std::min(a.end_x, b.end_x), std::max(a.begin_y, b.begin_y),
            std::min(a.end_y, b.end_y)};
}

}  // namespace enfilade::stencil
