#include "app/play/eye_view.h"

#include <algorithm>

namespace enfilade {
namespace {

/// The angle of pitch_steps, within ±kMaxPitchSteps.
Angle pitch_of(std::int64_t steps) {
    const std::int64_t within = std::clamp<std::int64_t>(steps, -kMaxPitchSteps, kMaxPitchSteps);
    return Angle{static_cast<std::uint32_t>(within)};
}

}  // namespace

View view_of(const Eye& eye, const LookSteps& ahead, double fov_degrees, double stretch, bool true_pitch) {
    View view;
    view.sector = eye.place.sector;
    view.eye = eye.place.point;
    view.eye_z = eye.z;
    view.forward = direction(eye.yaw + Angle{static_cast<std::uint32_t>(ahead.yaw)});
    const Angle pitch = pitch_of(eye.pitch_steps + ahead.pitch);
    if (true_pitch)
        view.tilt = Tilt{direction(pitch), {1, 0}};
    else
        view.pitch_tangent = tangent(pitch);
    view.fov_degrees = fov_degrees;
    view.stretch = stretch;
    return view;
}

}  // namespace enfilade
