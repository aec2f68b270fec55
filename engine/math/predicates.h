// Exact answers about points, lines and paths. No tolerance anywhere: with the grids of vec.h every determinant is a
// whole number that fits its type.
//
// The tie rule (Edelsbrunner, Muecke: "Simulation of Simplicity", 1990): a moving point p counts as p + (e, e^2) with
// e -> 0+. A side test therefore never answers "on the line", every point is in exactly one sector, and a path
// crosses walls in exactly one order.
#pragma once
#include "math/vec.h"

namespace enfilade {

__extension__ using Int128 = __int128;

/// Which way the corner a -> b -> c of three map vertices turns: 1 right (clockwise on the drawing), -1 left,
/// 0 straight. Exact in plain double.
constexpr int corner(Vec2 a, Vec2 b, Vec2 c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    return (left > right) - (left < right);
}

/// On which side of the line a -> b the moving point p is, under the tie rule: 1 right (where the wall's sector
/// is), -1 left. Never 0. a and b on either grid, a != b.
int side_of_line(Vec2 a, Vec2 b, Vec2 p);

/// On which side of the path p -> q the fixed point v is, the path being moved as a whole by the tie rule:
/// 1 right, -1 left. Never 0. p != q.
int side_of_path(Vec2 p, Vec2 q, Vec2 v);

/// cross(b - a, p - a), exact [2^-64 m^2]. No tie rule: 0 on the line.
Int128 whole_cross(Vec2 a, Vec2 b, Vec2 p);

/// The same, rounded once [m^2].
double exact_cross(Vec2 a, Vec2 b, Vec2 p);

/// Where along a path p -> q it crosses a line a -> b: a fraction, kept as whole numbers and tie-rule terms, so that
/// two of them can be ordered exactly.
struct PathFraction {
    Int128 numerator;
    Int128 denominator;  ///< > 0
    Int128 tie_1;        ///< coefficient of e in the numerator
    Int128 tie_2;        ///< coefficient of e^2

    /// [1], rounded; for positions on the screen and the like, never for decisions.
    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
};

/// Defined where p and q are on different sides of a -> b.
PathFraction fraction_along_path(Vec2 p, Vec2 q, Vec2 a, Vec2 b);

/// -1, 0, 1 as s comes before, with or after t. 0 only where both lines pass through one point of the path's line
/// and have the same direction, up to sign.
int compare(const PathFraction& s, const PathFraction& t);

/// True where the path p -> q, moved by the tie rule, crosses the wall a -> b from its right to its left: it leaves
/// the wall's sector. p != q is not required: a path of no length crosses nothing.
bool path_leaves_through(Vec2 p, Vec2 q, Vec2 a, Vec2 b);

/// True where some point of the segment a - b is nearer to p than `radius`: touching does not count. Exact. All on
/// either grid, radius too [m]; a may equal b. radius <= 0: false.
bool segment_is_nearer(Vec2 a, Vec2 b, Vec2 p, double radius);

/// The sign of a * b - c * d. |values| < 2^126.
int compare_products(Int128 a, Int128 b, Int128 c, Int128 d);

}  // namespace enfilade
