// Where the walls of one sector stand on the screen, seen from one pose.
#pragma once
#include <cmath>
#include <vector>

#include "map/map.h"
#include "render/column/pose.h"
#include "render/column/screen.h"

namespace enfilade::column {

/// A directed edge, as which walls and panels are compared.
struct Segment {
    Vec2 a, b;  ///< on the vertex grid

    Segment(Vec2 start, Vec2 end) : a(start), b(end) {}
    Segment(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// A wall that faces the eye, as columns see it. With e_V(s) = s V.z - V.x, a function of the vertex V alone, the
/// wall from left end L to right end R covers column slope s where e_L(s) > 0 > e_R(s): neighbours share a vertex, so
/// they meet without gap or overlap, and nothing has to be clipped at a near plane. On which side 0 counts is a
/// property of the ray alone (the tie rule, math/predicates.h).
struct ProjectedWall {
    WallId wall;             ///< none: a panel
    int begin = 0, end = 0;  ///< columns covered, within the screen
    Vec2 left_v, right_v;    ///< L and R in view space: x right, y stands for depth
    double cross = 0;        ///< cross(L, R) = 2 x area of eye, L, R [m^2]; 0 where the eye is on the wall's line
    double inverse_cross = 0;
    double nearest = 0, farthest = 0;  ///< bounds of the depth anywhere on the wall [m]
    bool swapped = false;              ///< L is the wall's b: it is seen in a mirror
};

/// What a column sees of a wall.
struct WallHit {
    double depth = 0;  ///< [m], >= 0, finite
    double along = 0;  ///< position on the wall from a to b, 0..1
};

/// e_V(slope): positive where the ray passes to the right of a vertex ahead of the eye.
inline double edge(Vec2 vertex_v, double slope) { return slope * vertex_v.y - vertex_v.x; }

/// e_L - e_R: positive wherever the wall covers the column, because e_L and e_R are not both 0 there.
inline double edge_span(const ProjectedWall& w, double slope) { return edge(w.left_v, slope) - edge(w.right_v, slope); }

/// 1 / depth at slope s: linear in s, infinite where the eye is on the wall's line.
inline double inverse_depth(const ProjectedWall& w, double slope) { return edge_span(w, slope) * w.inverse_cross; }

/// Exact up to rounding, and never outside the wall however grazing the look.
WallHit hit(const ProjectedWall& wall, double slope);

/// The walls of `sector` that face the eye and cover at least one column, in the order of the map.
/// `out` is emptied first and keeps its memory.
void project(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, std::vector<ProjectedWall>& out);

/// For a column that no wall of the sector covers: the wall that comes nearest to it, as if it covered that column
/// alone, preferably one beyond `entry`. The eye is rounded onto its grid behind a link, which can put a ray that came
/// in at the very edge of the doorway just outside it; without this its pixels would never be drawn.
ProjectedWall least_missed(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, int column,
                           WallId entry);

/// A single edge, which faces the eye: without its number. Covers no column (begin >= end) where it is not seen.
ProjectedWall project(const Segment& facing, const Pose& pose, const Screen& screen);

/// For two walls or panels of one sector that both face the eye and cover a common column: true where a is the nearer
/// one, or both lie on one line. Exact: they never cross, so one of them lies wholly on one side of the other's line.
bool is_nearer(const Segment& a, const Segment& b);

/// Whether two inverse depths in one column differ enough to tell which wall is nearer. Rounding leaves them good to
/// about 2^-50 of their size; closer ties (walls that share a vertex) are rare enough to be settled exactly. Two
/// infinities do not tell.
inline bool are_telling(double inverse_depth, double other) {
    constexpr double kTrusted = 0x1p-40;
    return std::fabs(inverse_depth - other) > kTrusted * other;
}

/// True where `wall`, which faces the eye and shares a column with `entry`, lies beyond `entry`, the wall of the same
/// sector the look came in through. What lies in the entry's own plane belongs to the room before. Exact.
bool is_beyond(const Segment& wall, const Segment& entry);

}  // namespace enfilade::column
