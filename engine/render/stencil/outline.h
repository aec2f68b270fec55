// Convex polygons in the picture, cut by straight lines.
#pragma once
#include <vector>

#include "render/stencil/ray_field.h"

namespace enfilade::stencil {

/// A point of the picture [px].
struct Corner {
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
    const std::vector<Corner>& corners() const { return corners_; }

private:
    std::vector<Corner> corners_, cut_;
};

}  // namespace enfilade::stencil
