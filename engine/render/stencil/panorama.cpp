#include "render/stencil/panorama.h"

#include <algorithm>
#include <cmath>

#include "render/stencil/outline.h"

namespace enfilade::stencil {

RayField::RayField(const View& view, const Projection& projection)
    : width(projection.width()), height(projection.height()), is_tilted(view.tilt.has_value()) {
    const double tangent = projection.half_fov_tangent(), focal_y = projection.focal_y();
    const Ray corner = projection.tilted({1, -tangent, projection.horizon() / focal_y});
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

}  // namespace enfilade::stencil
