// Walls and panels as edges in the plane, and which of two lies before the other: exact, shared by the renderers that
// draw walls as a whole.
#pragma once
#include <cmath>
#include <vector>

#include "map/map.h"
#include "render/exact_ray.h"
#include "render/view.h"

namespace enfilade {

/// A directed edge, as which walls and panels are compared.
struct Segment {
    Vec2 a, b;  ///< on the vertex grid

    Segment(Vec2 start, Vec2 end) : a(start), b(end) {}
    Segment(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// The panel from the side on which the eye is, under the tie rule for the eye.
Segment facing(const Panel& panel, Vec2 eye);

/// For two walls or panels of one sector that both face the eye and cover a common column: true where a is the nearer
/// one, or both lie on one line. Exact: they never cross, so one of them lies wholly on one side of the other's line.
bool is_nearer(const Segment& a, const Segment& b);

/// How far rounding may take edge() from the exact offset_left() of a vertex [m]: turned into view space, multiplied
/// and subtracted, the ray's normal rounded to its grid.
inline double edge_doubt(Vec2 vertex_v, double slope) {
    constexpr double kRounding = 0x1p-50;
    return kRounding * (1 + std::fabs(slope)) * (std::fabs(vertex_v.x) + std::fabs(vertex_v.y));
}

/// How far rounding may take the inverse depth of a wall in a column from the true one [1/m]. Of a wall that is seen
/// almost on edge it is a small difference of large numbers, and good for nothing near its end.
/// cross: of the wall's ends [m^2], which are in view space; 0 yields infinity.
inline double inverse_depth_doubt(Vec2 left_v, Vec2 right_v, double cross, double slope) {
    return (edge_doubt(left_v, slope) + edge_doubt(right_v, slope)) / cross;
}

/// Whether two inverse depths in one column differ enough to tell which wall is nearer: by more than both are in doubt,
/// and than a part of their size. Closer ties (walls that share a vertex) are rare enough to be settled exactly. Two
/// infinities do not tell.
inline bool are_telling(double inverse_depth, double other, double doubt) {
    constexpr double kTrusted = 0x1p-40;
    return std::fabs(inverse_depth - other) > kTrusted * other + doubt;
}

/// True where `wall`, which faces the eye and shares a column with `entry`, lies beyond `entry`, the wall of the same
/// space the look came in through. What lies in the entry's own plane belongs to the room before. Exact.
bool is_beyond(const Segment& wall, const Segment& entry);

/// True where both lie on one line. Exact.
bool are_on_one_line(const Segment& a, const Segment& b);

/// The same as is_beyond() for a panel: what lies in the entry's own plane belongs to the room the panel is in.
bool is_panel_beyond(const Segment& panel, const Segment& entry);

// Which columns of a picture lie between two vertices: exact, shared by the renderers that draw walls as a whole.

/// e_V(slope): positive where the ray passes to the right of a vertex ahead of the eye.
inline double edge(Vec2 vertex_v, double slope) { return slope * vertex_v.y - vertex_v.x; }

/// The vertex in view space: x right, y stands for depth. One at the very eye is moved a little the way the tie rule
/// says, so that it has a direction to draw; nothing is decided by it.
Vec2 to_view(Vec2 vertex, const Pose& pose);

/// A wall that faces the eye, by its ends from left to right: in the plane, on the vertex grid, and in view space.
struct FacingWall {
    Vec2 left, right;
    Vec2 left_v, right_v;
    Vec2 across_v;         ///< from the right end to the left one
    bool swapped = false;  ///< `left` is the wall's b: it is seen in a mirror
};
FacingWall facing_wall(const Segment& wall, const Pose& pose);

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

/// The columns whose rays run to the right of the left end L and to the left of the right end R: where e_L > 0 > e_R,
/// exactly (render/exact_ray.h). A function of each vertex alone, so neighbours meet without gap or overlap, and
/// nothing has to be clipped at a near plane.
CoveredColumns covered_columns(const FacingWall& wall, const Pose& pose, const ColumnRays& rays);

/// The first column whose ray passes, `depth` away, at x_v or to the right of it; the picture's width if none does.
int first_column_from(double x_v, double depth, const ColumnRays& rays);

// The wall that stands in for one that rounding lost: shared by the renderers that draw walls as a whole.

/// Where a ray that misses all walls counts as meeting one: at the end that is nearer to it.
struct StandIn {
    WallId wall;
    double depth = 0;  ///< of that end, not behind the eye [m]
    double along = 0;  ///< from the wall's a to its b, 0..1
};

/// For a ray that no wall of the sector covers: the wall that comes nearest to it, preferably one beyond `entry`, which
/// may be none. The eye is rounded onto its grid behind a link, and the tie rule moves it there in that space's own
/// way, which can put a ray that came in at the very edge of the doorway just outside it; without this its pixels would
/// never be drawn. Cost: the walls of the sector.
StandIn stand_in(const Map& map, SectorId sector, const Pose& pose, double slope, WallId entry);

}  // namespace enfilade
