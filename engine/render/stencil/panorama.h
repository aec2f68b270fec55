// What a tilted picture is planned in: the surroundings of the eye as four pictures that are not tilted, each a quarter
// of a turn wide, whose columns and rows stand for all rays in them.
#pragma once
#include <vector>

#include "render/stencil/wall_on_screen.h"
#include "render/view.h"

namespace enfilade::stencil {

// The rays of a whole picture as numbers that change evenly over it.

/// A number that changes evenly over the picture; point (x, y) of pixel (i, j)'s centre is (i + 1/2, j + 1/2) [px].
struct Even {
    double at_0 = 0;  ///< at the picture's upper left corner
    double per_x = 0, per_y = 0;

    double at(double x, double y) const { return at_0 + per_x * x + per_y * y; }
};

inline Even operator+(const Even& a, const Even& b) { return {a.at_0 + b.at_0, a.per_x + b.per_x, a.per_y + b.per_y}; }
inline Even operator-(const Even& a, const Even& b) { return {a.at_0 - b.at_0, a.per_x - b.per_x, a.per_y - b.per_y}; }
inline Even operator*(const Even& a, double k) { return {a.at_0 * k, a.per_x * k, a.per_y * k}; }

/// The rays of a picture (render/view.h), as real numbers.
struct RayField {
    int width = 0, height = 0;  ///< [px]
    bool is_tilted = false;     ///< if not, `ahead` is 1 and `right` the same in all rows, `up` in all columns
    Even ahead{1, 0, 0}, right, up;

    RayField(const View& view, const Projection& projection);
};

inline constexpr std::size_t kFaces = 4;

/// One of the four; they are alike.
Screen panorama_screen();

/// The eye turned to the right by so many quarters.
Pose face_of(const Pose& pose, std::size_t quarters);

/// What of that face the picture shows.
ClipWindow panorama_window(const Screen& face, const RayField& rays, std::size_t quarters);

// Convex polygons in the picture, cut by straight lines.

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
