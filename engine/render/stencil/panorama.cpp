#include "render/stencil/panorama.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::stencil {

RayField::RayField(const View& view, const Projection& projection)
    : width(projection.width()), height(projection.height()), is_tilted(view.tilt.has_value()) {
    const double tangent = projection.half_fov_tangent(), focal_y = projection.focal_y();
    const Ray corner = projection.tilted({1, projection.slope(-0.5), projection.horizon() / focal_y});
    const Ray per_x = projection.tilted({0, 2 * tangent / width, 0});
    const Ray per_y = projection.tilted({0, 0, -1 / focal_y});
    ahead = {corner.ahead, per_x.ahead, per_y.ahead};
    right = {corner.right, per_x.right, per_y.right};
    up = {corner.up, per_x.up, per_y.up};
}

namespace {

constexpr int kColumns = 128;  ///< of a face: what is narrower than 0.7 degrees cannot hide anything

/// Rows reach to where a ray climbs 32768 metres per metre: from there on a floor is met within the width of a hair.
constexpr double kFocal = 64;  // [px]
constexpr int kRows = 1 << 22;

/// A direction in the plane as the view sees it: x ahead, y to its right. slope: as seen from the face.
Vec2 direction_in_view(std::size_t quarters, double slope) {
    switch (quarters) {
        case 0: return {1, slope};
        case 1: return {-slope, 1};
        case 2: return {-1, -slope};
        default: return {slope, -1};
    }
}

/// The part of all rays that goes along a direction.
Even along(const RayField& rays, Vec2 direction) { return rays.ahead * direction.x + rays.right * direction.y; }

/// The row, as a whole number within the screen, in which a ray is.
double row_at(const Screen& face, double ahead, double up) {
    const double climb = ahead > 0 ? up / ahead : up < 0 ? -kRows : kRows;
    return std::clamp(face.horizon - climb * face.focal_y, 0.0, double(face.height));
}

OpenRows rows_of(const Screen& face, const RayField& rays, std::size_t quarters, int x) {
    const Vec2 left = direction_in_view(quarters, face.slope_at(x)),
               right = direction_in_view(quarters, face.slope_at(x + 1));
    Outline outline;
    outline.set(0, rays.width, 0, rays.height);
    outline.keep(along(rays, right_of(left)));  // to the right of the column's left end
    outline.keep(along(rays, -right_of(right)));
    if (outline.is_empty()) return {};
    const Even ahead = along(rays, direction_in_view(quarters, 0));
    OpenRows rows{face.height, 0};
    for (const PixelPoint& corner : outline.corners()) {
        const double row = row_at(face, ahead.at(corner.x, corner.y), rays.up.at(corner.x, corner.y));
        rows.top = std::min(rows.top, static_cast<int>(row) - 1);
        rows.bottom = std::max(rows.bottom, static_cast<int>(row) + 2);
    }
    return {std::max(rows.top, 0), std::min(rows.bottom, face.height)};
}

}  // namespace

Screen panorama_screen() {
    Screen face;
    face.width = kColumns;
    face.height = kRows;
    face.slope_per_px = 2.0 / kColumns;
    face.middle_px = kColumns / 2.0;
    face.focal_y = kFocal;
    face.horizon = kRows / 2.0;
    face.has_ranges = true;
    for (int x = 0; x < kColumns; ++x) face.slopes.push_back(face.slope_at(x + 0.5));
    return face;
}

Pose face_of(const Pose& pose, std::size_t quarters) {
    Pose face = pose;
    for (; quarters > 0; --quarters) {
        const Vec2 right = face.right;
        face.right = -face.forward;
        face.forward = right;
    }
    return face;
}

ClipWindow panorama_window(const Screen& face, const RayField& rays, std::size_t quarters) {
    ClipWindow window;
    for (int x = 0; x < face.width; ++x) {
        const OpenRows rows = rows_of(face, rays, quarters, x);
        if (!rows.is_closed()) window.open(x, rows);
    }
    return window;
}

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
