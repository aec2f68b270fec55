#include "render/exact_ray.h"

#include <algorithm>
#include <cmath>

#include "math/exact_product.h"

namespace enfilade {
namespace {

constexpr double kNormalSteps = 0x1p55;  ///< of a ray's normal per unit
constexpr double kOffsetUnit = 0x1p-87;  ///< what offset_left() counts in [m]
constexpr int kDepthPower = 23;          ///< cross / across is in units of 2^23 m: 2^-64 m^2 / 2^-87 m

/// More than all roundings of products of doubles here, as a part of them.
constexpr double kProductDoubt = 0x1p-48;

}  // namespace

RayNormal ray_normal(const Pose& pose, double slope) {
    const Vec2 normal = pose.forward * slope - pose.right;
    return {std::llround(normal.x * kNormalSteps), std::llround(normal.y * kNormalSteps)};
}

Int128 offset_left(const RayNormal& ray, Vec2 vertex, Vec2 eye) {
    return Int128{ray.x} * (to_grid_units(vertex.x) - to_grid_units(eye.x)) +
           Int128{ray.y} * (to_grid_units(vertex.y) - to_grid_units(eye.y));
}

bool runs_right_of(const RayNormal& ray, Vec2 vertex, Vec2 eye) {
    const Int128 offset = offset_left(ray, vertex, eye);
    if (offset != 0) return offset > 0;
    // With the eye at eye + (e, e^2) every offset changes by -(x e + y e^2).
    return ray.x != 0 ? ray.x < 0 : ray.y < 0;
}

bool is_own_vertex_ahead(Vec2 forward) { return forward.x != 0 ? forward.x < 0 : forward.y < 0; }

RayDepth depth_on_wall(Vec2 a, Vec2 b, const Pose& pose, const RayNormal& ray) {
    const Int128 span = offset_left(ray, a, pose.eye) - offset_left(ray, b, pose.eye);
    const Int128 across = pose.flip < 0 ? -span : span, cross = whole_cross(a, b, pose.eye);
    return {static_cast<double>(cross) * 0x1p-64 / (static_cast<double>(across) * kOffsetUnit), cross, across};
}

bool reaches(const RowClimb& climb, const RayDepth& depth, double height) {
    const double risen = climb.rise * std::max(depth.value, kAnInstant), asked = height * climb.run;
    if (depth.across == 0 || depth.cross == 0) return risen >= asked;
    if (std::fabs(risen - asked) > kProductDoubt * (std::fabs(risen) + std::fabs(asked))) return risen > asked;
    return compare(ExactProduct(depth.cross).times(climb.rise).scaled(kDepthPower),
                   ExactProduct(depth.across).times(height).times(climb.run)) >= 0;
}

namespace {

constexpr double kMostDepth = 0x1p40;  ///< farther than anything, and its steps fit [m]

double real_steps(double depth) { return std::clamp(depth, 0.0, kMostDepth) / kDepthStep + 0.5; }

/// Steps by the whole number that these, not yet cut to one, are surely beyond; none if they are too near to one.
std::optional<std::int64_t> sure_steps(double steps, double doubt) {
    const double nearest = std::floor(steps + 0.5);
    if (std::fabs(steps - nearest) <= doubt * steps) return {};
    return static_cast<std::int64_t>(steps);
}

}  // namespace

std::int64_t depth_steps(double depth) { return static_cast<std::int64_t>(real_steps(depth)); }

std::int64_t depth_steps(const RayDepth& depth) {
    const double steps = real_steps(depth.value);
    if (depth.across == 0) return static_cast<std::int64_t>(steps);
    if (const auto sure = sure_steps(steps, kProductDoubt)) return *sure;
    const auto nearest = static_cast<std::int64_t>(std::floor(steps + 0.5));
    return is_farther(depth, nearest - 1) ? nearest : nearest - 1;
}

bool is_farther(const RayDepth& depth, std::int64_t steps) {
    const double border = border_after(steps);
    if (depth.across == 0) return depth.value >= border;
    return compare(ExactProduct(depth.cross).scaled(kDepthPower), ExactProduct(depth.across).times(border)) >= 0;
}

std::optional<std::int64_t> sure_depth_steps(double about) { return sure_steps(real_steps(about), 2 * kDepthDoubt); }

}  // namespace enfilade
