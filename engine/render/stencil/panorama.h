// What a tilted picture is planned in: the surroundings of the eye as four pictures that are not tilted, each a quarter
// of a turn wide, whose columns and rows stand for all rays in them.
#pragma once
#include "render/stencil/room_look.h"
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

}  // namespace enfilade::stencil
