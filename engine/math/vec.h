// Points, directions and rigid maps, and the conventions every other file relies on.
//
// Map plane    x right, y DOWN as on a drawing, z up. Unit: metre.
// Yaw          0 looks along +x, positive turns right: forward = (cos, sin), screen right = (-sin, cos).
// Walls        directed a -> b; the sector they belong to lies on their RIGHT, where cross(b - a, p - a) > 0.
// Screen       pixel (x, y) covers [x, x+1) x [y, y+1), y down, and is sampled at its centre.
// View space   x to the right of the eye, z ahead of it: `_v`. World space: `_w`. Pixels: `_px`. Texels: `_tx`.
// Ranges       half-open: begin, end.
#pragma once
#include <cstdint>

namespace enfilade {

struct Vec2 {
    double x = 0;
    double y = 0;
    constexpr bool operator==(const Vec2&) const = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies clockwise of a on the drawing (to its right).
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// a turned a quarter to the right.
constexpr Vec2 right_of(Vec2 a) { return {-a.y, a.x}; }

// The two grids everything lives on, which is what makes the predicates exact (DESIGN §2, NUMERICS §2.1).

/// Map vertices are multiples of this [m]. With kWorldLimit it makes differences of vertices fit 26 bits and
/// products 52, so that orientation tests of vertices are exact in double. Doom's unit (1/32 m) is on the grid.
inline constexpr double kVertexGrid = 0x1p-10;

/// Moving points (eye, player, things, ends of a move) are multiples of this [m]: still exact in a double (47 bits)
/// and in the 64-bit integers of the side tests.
inline constexpr double kPointGrid = 0x1p-32;

/// Largest absolute coordinate, horizontally [m].
inline constexpr double kWorldLimit = 32768;

namespace detail {
/// Adding and taking away 1.5 * 2^52 grid steps leaves x rounded to the grid, half to even: no libm, any compiler.
constexpr double snap(double x, double grid) {
    const double shift = grid * 0x1.8p52;
    return (x + shift) - shift;
}
}  // namespace detail

/// Rounded to the vertex grid, half to even. |x| <= 2^41.
constexpr double snap_to_vertex_grid(double x) { return detail::snap(x, kVertexGrid); }
constexpr Vec2 snap_to_vertex_grid(Vec2 v) { return {snap_to_vertex_grid(v.x), snap_to_vertex_grid(v.y)}; }

/// Rounded to the grid of moving points, half to even. |x| <= 2^18.
constexpr double snap_to_point_grid(double x) { return detail::snap(x, kPointGrid); }
constexpr Vec2 snap_to_point_grid(Vec2 v) { return {snap_to_point_grid(v.x), snap_to_point_grid(v.y)}; }

/// A coordinate on either grid as a whole number of point-grid steps. |x| <= 2^30: exact.
constexpr std::int64_t to_grid_units(double x) { return static_cast<std::int64_t>(x * 0x1p32); }

// Rigid maps of the world: what a linked portal or a mirror does to whatever passes or looks through it.

/// Turn (and, with flip = -1, reflection), then shift, then rise: p -> M p + shift, z -> z + rise, with
/// M = [[c, -flip s], [s, flip c]]. Quarter turns and grid shifts are exact, because products with 0 and 1 are.
struct Rigid {
    double c = 1;     ///< cosine of the angle by which it turns right
    double s = 0;     ///< its sine
    double flip = 1;  ///< 1 keeps left and right, -1 swaps them
    Vec2 shift;       ///< [m]
    double rise = 0;  ///< [m]

    constexpr bool operator==(const Rigid&) const = default;
    constexpr bool is_identity() const { return *this == Rigid{}; }

    /// Of a direction, which no shift changes.
    constexpr Vec2 turn(Vec2 d) const { return {c * d.x - flip * s * d.y, s * d.x + flip * c * d.y}; }
    /// Of a point and of a height [m], rounded to doubles, to no grid.
    constexpr Vec2 apply(Vec2 p) const { return turn(p) + shift; }
    constexpr double apply_height(double z) const { return z + rise; }
};

/// first, then second.
constexpr Rigid then(const Rigid& first, const Rigid& second) {
    return {second.c * first.c - second.flip * second.s * first.s,
            second.s * first.c + second.flip * second.c * first.s, first.flip * second.flip, second.apply(first.shift),
            first.rise + second.rise};
}

/// The way back, up to rounding. A reflection's matrix is its own inverse; a turn's is the turn by -s.
constexpr Rigid inverse(const Rigid& m) {
    Rigid back{m.c, m.flip > 0 ? -m.s : m.s, m.flip, {}, -m.rise};
    back.shift = -back.turn(m.shift);
    return back;
}

// What a linked portal does to a point on the point grid: carries the grid onto itself, one to one, so that whoever
// goes back comes to the very point he left, whatever the link's angle.

/// A turn and a shift of the point grid. Quarter turns are exact. What is left of the angle, at most 45 degrees, are
/// three shears, each rounded to the grid: x -= t y, y += s x, x -= t y with t = tan(angle / 2), s = sin(angle).
/// A rounded shear is taken back exactly by the opposite one, and the three of the opposite angle are those, backward.
/// Source: A. W. Paeth, "A Fast Algorithm for General Raster Rotation", 1986; rounded shears as in lossless coding:
/// F. A. M. L. Bruekers, A. W. M. van den Enden, "New Networks for Perfect Inversion and Perfect Reconstruction", 1992.
class GridMap {
public:
    /// Leaves every point where it is.
    GridMap() = default;

    /// The turn of `m` (flip = 1), about `from`, which comes to lie on `onto`; both on the point grid. The inverse
    /// rigid map with `from` and `onto` exchanged gives the inverse: apply() of both, in any order, is the identity.
    constexpr GridMap(const Rigid& m, Vec2 from, Vec2 onto) : from_(from), onto_(onto) {
        const bool is_near_x = (m.s < 0 ? -m.s : m.s) <= (m.c < 0 ? -m.c : m.c);
        quarters_ = is_near_x ? (m.c > 0 ? 0 : 2) : (m.s > 0 ? 1 : 3);
        const Vec2 rest = turned({m.c, m.s}, 4 - quarters_);
        sine_ = rest.y;
        half_tangent_ = rest.y / (1 + rest.x);
    }

    /// Where a point on the grid comes to lie, on the grid: within 1.5 grid steps of the turned point, and exactly
    /// there for quarter turns. |coordinates of p - from| <= 2^17 m.
    constexpr Vec2 apply(Vec2 p) const {
        // Rounded shears and a quarter turn do not commute: the way back does them in the opposite order.
        Vec2 d = p - from_;
        if (quarters_ == 3) d = turned(d, 3);
        d.x -= snap_to_point_grid(half_tangent_ * d.y);
        d.y += snap_to_point_grid(sine_ * d.x);
        d.x -= snap_to_point_grid(half_tangent_ * d.y);
        if (quarters_ != 3) d = turned(d, quarters_);
        return onto_ + d;
    }

private:
    static constexpr Vec2 turned(Vec2 d, int quarters) {
        switch (quarters) {
            case 1: return {-d.y, d.x};
            case 2: return {-d.x, -d.y};
            case 3: return {d.y, -d.x};
            default: return d;
        }
    }

    Vec2 from_, onto_;
    int quarters_ = 0;
    double sine_ = 0, half_tangent_ = 0;
};

}  // namespace enfilade
