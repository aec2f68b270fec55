#include "render/outside/outside_camera.h"

#include <cmath>

namespace enfilade {
namespace {

constexpr double kDownFromAbove = 60, kDownFromBehind = 30;  ///< how far down the cameras look [degrees]

/// How far before the eye, in parts of the reach, the picture from above has its middle: one sees more of what is
/// ahead.
constexpr double kAhead = 0.25;

/// The camera behind stands so far away, in parts of the reach, and sees so far to either side.
constexpr double kBehind = 0.2, kFovBehind = 75;  // [1], [degrees]

}  // namespace

OutsideCamera::OutsideCamera(OutsideFrom from, const View& view, double reach_m, int width, int height)
    : forward_(view.forward),
      right_(right_of(view.forward)),
      middle_px_{width / 2.0, height / 2.0},
      is_parallel_(from == OutsideFrom::above) {
    pitch_ = direction(Angle::from_degrees(is_parallel_ ? kDownFromAbove : kDownFromBehind));
    if (is_parallel_) {
        focal_px_ = height / (reach_m * pitch_.y);
        place_ = view.eye + forward_ * (kAhead * reach_m);
        z_ = view.eye_z;
    } else {
        focal_px_ = middle_px_.x / tangent(Angle::from_degrees(kFovBehind / 2));
        place_ = view.eye - forward_ * (kBehind * reach_m * pitch_.x);
        z_ = view.eye_z + kBehind * reach_m * pitch_.y;
    }
}

OutsideCamera::OutsideCamera(const View& view, int width, int height)
    : place_(view.eye),
      z_(view.eye_z),
      forward_(view.forward),
      right_(right_of(view.forward)),
      middle_px_{width / 2.0, height / 2.0},
      focal_px_(middle_px_.x / tangent(Angle::from_degrees(view.fov_degrees / 2))) {
    const double length = std::sqrt(1 + view.pitch_tangent * view.pitch_tangent);
    pitch_ = {1 / length, -view.pitch_tangent / length};
}

double OutsideCamera::depth(Vec2 p, double z) const {
    return dot(p - place_, forward_) * pitch_.x - (z - z_) * pitch_.y;
}

PicturePoint OutsideCamera::project(Vec2 p, double z) const {
    const Vec2 way = p - place_;
    const double ahead = dot(way, forward_), right = dot(way, right_);
    const double up = ahead * pitch_.y + (z - z_) * pitch_.x;
    const double w = is_parallel_ ? 1 : ahead * pitch_.x - (z - z_) * pitch_.y;
    return {middle_px_.x * w + focal_px_ * right, middle_px_.y * w - focal_px_ * up, w};
}

PicturePoint OutsideCamera::upright() const {
    const double w = is_parallel_ ? 0 : -pitch_.y;
    return {middle_px_.x * w, middle_px_.y * w - focal_px_ * pitch_.x, w};
}

}  // namespace enfilade
