// Convex polygons in the picture, cut by straight lines.
#pragma once
#include <vector>

#include "render/stencil/panorama.h"
#include "render/stencil/room_look.h"
#include "render/stencil/wall_on_screen.h"

namespace enfilade::stencil {

/// A point of the picture [px].
struct PixelPoint {
    double x, y;
};

/// A convex polygon, its corners in order. Keeps its memory.
class Outline {
public:
    /// A rectangle.
    void set(double left, double right, double top, double bottom);
    void set(const Outline& other) { corners_ = other.corners_; }

    /// Keeps what is where the number is not negative. Outlines that share an edge still share it after a cut by one
    /// line, or by a line and its negative: a cut does not depend on the direction an edge is walked in.
    void keep(const Even& where);

    bool is_empty() const { return corners_.size() < 3; }
    const std::vector<PixelPoint>& corners() const { return corners_; }

private:
    std::vector<PixelPoint> corners_, cut_;
};

// Where in the picture the parts of an upright edge are: bounds of their pixels, tilted or not.

/// e_V of all rays: positive where they run to the right of the vertex (render/segment.h).
inline Even edge(const RayField& rays, Vec2 vertex_v) { return rays.right * vertex_v.y - rays.ahead * vertex_v.x; }

/// e_L - e_R of all rays: positive where they meet the wall's line ahead of the eye; depth_factor / span is how far
/// away, along the line of sight [m].
inline Even span(const RayField& rays, const WallOnScreen& wall) {
    if (wall.missed) return rays.ahead * wall.missed->ahead_v.y + rays.right * wall.missed->ahead_v.x;
    return rays.right * (wall.left_v.y - wall.right_v.y) - rays.ahead * (wall.left_v.x - wall.right_v.x);
}

inline double depth_factor(const WallOnScreen& wall) { return wall.missed ? wall.missed->depth : wall.cross; }

/// Positive where rays lead up, under the rule of kTieShift.
Even climb(const RayField& rays);

/// Positive where a wall is met below a height above the eye.
Even below(const RayField& rays, const WallOnScreen& wall, double height);

/// All above, on and below the wall. Not tilted: its columns exactly. Tilted: up to a pixel more than between its ends.
void set_between_ends(Outline& outline, const RayField& rays, const WallOnScreen& wall);

/// Cuts the outline off at heights above the eye; infinite ones cut nothing.
void keep_between(Outline& outline, const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights);

/// Whole pixels around that part of the wall, within the picture.
ScreenBox box_around(const RayField& rays, const WallOnScreen& wall, const RelativeHeights& heights);

ScreenBox common(const ScreenBox& a, const ScreenBox& b);

}  // namespace enfilade::stencil
