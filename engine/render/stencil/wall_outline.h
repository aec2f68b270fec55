// Where in the picture the parts of an upright edge are: bounds of their pixels, tilted or not.
#pragma once
#include "render/stencil/outline.h"
#include "render/stencil/wall_on_screen.h"
#include "render/stencil/wall_parts.h"
#include "render/stencil/window.h"

namespace enfilade::stencil {

/// e_V of all rays: positive where they run to the right of the vertex (render/edge_function.h).
inline Even edge(const RayField& rays, Vec2 vertex_v) { return rays.right * vertex_v.y - rays.ahead * vertex_v.x; }

/// e_L - e_R of all rays: positive where they meet the wall's line ahead of the eye; depth_factor / span is how far
/// away, along the line of sight [m].
inline Even span(const RayField& rays, const WallOnScreen& wall) {
    if (wall.missed) return {1, 0, 0};
    return rays.right * (wall.left_v.y - wall.right_v.y) - rays.ahead * (wall.left_v.x - wall.right_v.x);
}

inline double depth_factor(const WallOnScreen& wall) { return wall.missed ? wall.missed->depth : wall.cross; }

/// Positive where a wall is met below a height above the eye.
Even below(const RayField& rays, const WallOnScreen& wall, double height);

/// All above, on and below the wall. Not tilted: its columns exactly. Tilted: up to a pixel more than between its ends.
void set_between_ends(Outline& outline, const RayField& rays, const WallOnScreen& wall);

/// Cuts the outline off at heights above the eye; infinite ones cut nothing.
void keep_between(Outline& outline, const RayField& rays, const WallOnScreen& wall, const Heights& heights);

/// Whole pixels around that part of the wall, within the picture.
Box box_around(const RayField& rays, const WallOnScreen& wall, const Heights& heights);

Box common(const Box& a, const Box& b);

}  // namespace enfilade::stencil
