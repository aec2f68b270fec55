#include "render/view.h"

#include "base/check.h"

namespace enfilade {

Projection::Projection(const View& view, int width, int height) : width_(width), height_(height), double_width_(width) {
    ENFILADE_CHECK(width >= 1 && width <= kMaxPictureSide && height >= 1 && height <= kMaxPictureSide);
    ENFILADE_CHECK(view.fov_degrees >= kMinFov && view.fov_degrees <= kMaxFov);
    half_fov_tangent_ = tangent(Angle::from_degrees(view.fov_degrees / 2));
    focal_y_ = width / 2.0 / half_fov_tangent_ * view.stretch;
    horizon_ = height / 2.0 + view.pitch_tangent * focal_y_;
}

}  // namespace enfilade
