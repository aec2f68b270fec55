// Which columns of a picture lie between two vertices: exact, shared by the renderers that draw walls as a whole.
#pragma once
#include <vector>

#include "render/pose.h"

namespace enfilade {

/// e_V(slope): positive where the ray passes to the right of a vertex ahead of the eye.
inline double edge(Vec2 vertex_v, double slope) { return slope * vertex_v.y - vertex_v.x; }

/// The vertex in view space: x right, y stands for depth. One at the very eye is moved by the tie rule.
Vec2 to_view(Vec2 vertex, const Pose& pose);

/// The rays of a picture's columns.
struct ColumnRays {
    const std::vector<double>& slopes;  ///< tangent right of the middle, growing
    double per_slope;                   ///< columns per unit of slope
};

/// Columns [begin, end), maybe none (begin >= end).
struct CoveredColumns {
    int begin = 0;
    int end = 0;
};

/// The columns whose rays run to the right of the left end L and to the left of the right end R of a wall that faces
/// the eye: where e_L > 0 > e_R. A function of each vertex alone, so neighbours meet without gap or overlap, and
/// nothing has to be clipped at a near plane. On which side 0 counts is a property of the ray alone (the tie rule,
/// math/predicates.h).
CoveredColumns covered_columns(Vec2 left_v, Vec2 right_v, const Pose& pose, const ColumnRays& rays);

/// The first column whose ray passes, `depth` away, at x_v or to the right of it; the picture's width if none does.
int first_column_from(double x_v, double depth, const ColumnRays& rays);

}  // namespace enfilade
