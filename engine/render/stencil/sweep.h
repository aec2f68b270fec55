// In which order the rays of one eye meet upright edges, all around it: decided exactly, on the plane.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "render/segment.h"

namespace enfilade::stencil {

/// Where a look all around begins and ends: edges that cross this direction from the eye are cut in two there, so that
/// no edges hide each other in a ring.
inline constexpr Vec2 kCut{1, 0};

/// An edge, or what is left of it to one side of kCut.
struct SweptPart {
    std::size_t edge;
    bool begins_at_cut = false, ends_at_cut = false;  ///< seen from the eye, b being to the right of a
};

/// Whether the one edge is met before the other by the rays that meet both; asked of edges only that share a ray.
using IsMetBefore = std::function<bool(std::size_t edge, std::size_t other)>;

/// Whether an edge's ends are rounded, so that it may be met a hair to the wrong side of others. They are all in order
/// whatever is said of it.
using IsRounded = std::function<bool(std::size_t edge)>;

/// All edges so that along every ray the nearer comes before the farther. Given: their right sides face the eye under
/// the tie rule, and they do not cross each other. Ends and eye on either grid.
/// Cost: for n edges n log n side tests, and for each a look along those that share a ray with its ends.
std::vector<SweptPart> in_order_of_rays(
    const std::vector<Segment>& edges, Vec2 eye, const IsMetBefore& is_met_before,
    const IsRounded& is_rounded = [](std::size_t) { return false; });

}  // namespace enfilade::stencil
