#include "render/reference/tilted_ray.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

/// A slope that a path can have (ray_path.h) and that every ray of a picture that is not tilted has: the tangent of
/// half of kMaxFov.
constexpr double kMostSlope = 115;

/// Straight down is down and this much ahead: a hair on any floor [1].
constexpr double kLean = 0x1p-40;

}  // namespace

RayCourse ray_course(const Ray& ray) {
    const double aheads[] = {ray.ahead, ray.right, -ray.ahead, -ray.right};
    const double rights[] = {ray.right, -ray.ahead, -ray.right, ray.ahead};
    int best = 0;
    if (!(ray.ahead > 0 && std::fabs(ray.right) <= kMostSlope * ray.ahead))
        best = static_cast<int>(std::max_element(aheads, aheads + 4) - aheads);
    const double ahead = std::max(aheads[best], kLean);
    return {best, rights[best] / ahead, ray.up / ahead, 1 / ahead};
}

View turned(const View& view, int quarters) {
    View turned = view;
    for (; quarters > 0; --quarters) turned.forward = right_of(turned.forward) * view.flip;
    return turned;
}

}  // namespace enfilade
