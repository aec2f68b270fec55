// Points and directions, and the conventions every other file relies on.
//
// Map plane    x right, y DOWN as on a drawing, z up. Unit: metre.
// Yaw          0 looks along +x, positive turns right: forward = (cos, sin), screen right = (-sin, cos).
// Walls        directed a -> b; the sector they belong to lies on their RIGHT, where cross(b - a, p - a) > 0.
// Screen       pixel (x, y) covers [x, x+1) x [y, y+1), y down, and is sampled at its centre.
// View space   x to the right of the eye, z ahead of it: `_v`. World space: `_w`. Pixels: `_px`. Texels: `_tx`.
// Ranges       half-open: begin, end.
#pragma once

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

}  // namespace enfilade
