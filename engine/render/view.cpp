#include "render/view.h"

#include <cmath>

#include "base/result.h"

namespace enfilade {

Projection::Projection(const View& view, int width, int height)
    : width_(width),
      height_(height),
      half_width_(width / 2.0),
      middle_column_((width - 1) / 2.0 - view.ray_offset.x),
      tilt_(view.tilt) {
    ENFILADE_CHECK(width >= 1 && width <= kMaxPictureSide && height >= 1 && height <= kMaxPictureSide);
    ENFILADE_CHECK(!view.tilt || view.pitch_tangent == 0);
    ENFILADE_CHECK(view.fov_degrees >= kMinFov && view.fov_degrees <= kMaxFov);
    ENFILADE_CHECK(std::fabs(view.ray_offset.x) <= width / 2.0 && std::fabs(view.ray_offset.y) <= height / 2.0);
    half_fov_tangent_ = tangent(Angle::from_degrees(view.fov_degrees / 2));
    focal_y_ = width / 2.0 / half_fov_tangent_ * view.stretch;
    horizon_ = height / 2.0 + view.pitch_tangent * focal_y_ - view.ray_offset.y;
}

Ray Projection::tilted(const Ray& in_picture) const {
    if (!tilt_) return in_picture;
    const Vec2 roll = tilt_->roll, pitch = tilt_->pitch;
    const double right = in_picture.right * roll.x + in_picture.up * roll.y;
    const double up = in_picture.up * roll.x - in_picture.right * roll.y;
    return {in_picture.ahead * pitch.x - up * pitch.y, right, in_picture.ahead * pitch.y + up * pitch.x};
}

}  // namespace enfilade
