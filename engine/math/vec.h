// Points and directions, and the conventions every other file relies on.
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

}  // namespace enfilade
