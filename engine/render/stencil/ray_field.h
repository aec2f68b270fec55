// The rays of a whole picture as numbers that change evenly over it.
#pragma once
#include "render/view.h"

namespace enfilade::stencil {

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

}  // namespace enfilade::stencil
