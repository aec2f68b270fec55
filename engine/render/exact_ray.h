// What a ray of a picture meets, decided in whole numbers: on which side of a vertex it runs, how far away a wall is,
// and whether it passes above a height there. Part of the maps' rules, so all renderers ask here, each in its own
// order: a renderer that works faster with rounded numbers asks where these are in doubt.
//
// The ray's normal is rounded once to a grid of 2^-55; from then on nothing is rounded. The eye stands at
// eye + (e, e^2) with e -> 0+ in the space behind every link (math/predicates.h), so a ray is never on a vertex: no
// crack, no double cover, no tolerance.
// Source: H. Edelsbrunner, E. P. Muecke, "Simulation of Simplicity", 1990.
#pragma once
#include <cstdint>
#include <optional>

#include "math/predicates.h"
#include "math/vec.h"
#include "render/view.h"

namespace enfilade {

/// slope * forward - right of a ray [2^-55]: with slopes up to kMostSlope it fits 63 bits.
struct RayNormal {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// slope: |slope| <= kMostSlope.
RayNormal ray_normal(const Pose& pose, double slope);

/// How far the vertex is to the left of the ray, times the normal's length: slope * y - x of view space [2^-87 m].
/// vertex, eye: on either grid.
Int128 offset_left(const RayNormal& ray, Vec2 vertex, Vec2 eye);

/// Whether the ray, on either side of the eye, runs to the right of the vertex. By the tie rule it never runs through
/// it.
bool runs_right_of(const RayNormal& ray, Vec2 vertex, Vec2 eye);

/// Whether an eye that stands on a vertex has it ahead by the tie rule: in the direction -(1, e).
bool is_own_vertex_ahead(Vec2 forward);

/// How far along `forward` a ray meets something.
struct RayDepth {
    double value = 0;   ///< rounded [m]
    Int128 cross = 0;   ///< a wall is met at exactly cross / across [2^23 m]
    Int128 across = 0;  ///< 0: no wall is met, and `value` is the exact depth
};

/// Where the ray meets the wall a - b, which faces the eye, and of which one end is on either side of the ray.
RayDepth depth_on_wall(Vec2 a, Vec2 b, const Pose& pose, const RayNormal& ray);

/// A wall that passes through the eye is met an instant after the start: nearer than any height matters, but not so
/// near that an eye at the very height of a ceiling would find all rows above it [m].
inline constexpr double kAnInstant = 0x1p-1000;

/// Whether the ray at this depth is `height` above the eye or higher. Exact.
bool reaches(const RowClimb& climb, const RayDepth& depth, double height);

// Depths in steps, by which things are put in order.

/// Whether a thing's picture is met before or behind a wall, or another picture, is decided in whole steps of depth. A
/// thing that stands in the very plane of a doorway is as deep as the doorway, however the look got there: what
/// rounding leaves behind a link, some 1e-12 m, is far below half a step [m].
inline constexpr double kDepthStep = 0x1p-20;

/// The nearest whole number of steps; infinity allowed; what is not ahead counts as 0.
std::int64_t depth_steps(double depth);

/// The same of an exact depth.
std::int64_t depth_steps(const RayDepth& depth);

/// Whether an exact depth is more steps than that.
bool is_farther(const RayDepth& depth, std::int64_t steps);

/// The depth from which on it is.
inline double border_after(std::int64_t steps) { return (static_cast<double>(steps) + 0.5) * kDepthStep; }

/// How far rounding may have taken a depth from the exact one where a renderer relies on it, as a part of it.
inline constexpr double kDepthDoubt = 0x1p-42;

/// The steps of the exact depth, of which `about` differs by kDepthDoubt at most; none where that leaves a choice.
std::optional<std::int64_t> sure_depth_steps(double about);

}  // namespace enfilade
