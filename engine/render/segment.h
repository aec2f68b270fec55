// Walls and panels as edges in the plane, and which of two lies before the other: exact, shared by the renderers that
// draw walls as a whole.
#pragma once
#include <cmath>

#include "map/map.h"

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

/// Whether two inverse depths in one column differ enough to tell which wall is nearer. Rounding leaves them good to
/// about 2^-50 of their size; closer ties (walls that share a vertex) are rare enough to be settled exactly. Two
/// infinities do not tell.
inline bool are_telling(double inverse_depth, double other) {
    constexpr double kTrusted = 0x1p-40;
    return std::fabs(inverse_depth - other) > kTrusted * other;
}

/// True where `wall`, which faces the eye and shares a column with `entry`, lies beyond `entry`, the wall of the same
/// space the look came in through. What lies in the entry's own plane belongs to the room before. Exact.
bool is_beyond(const Segment& wall, const Segment& entry);

/// True where both lie on one line. Exact.
bool are_on_one_line(const Segment& a, const Segment& b);

/// The same as is_beyond() for a panel: what lies in the entry's own plane belongs to the room the panel is in.
bool is_panel_beyond(const Segment& panel, const Segment& entry);

}  // namespace enfilade
