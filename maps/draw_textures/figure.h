// Things that stand in rooms, as pictures: small solid bodies, looked at from eight sides.
#pragma once

#include <array>
#include <functional>

#include "picture.h"

namespace draw_textures {

struct Vec3 {
    double x, y, z;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(Vec3 a, double k) { return {a.x * k, a.y * k, a.z * k}; }

// A body: how far a point is outside of it, in metres, and what it is made of there. x leads ahead of the thing, y to
// its left, z up.
struct Matter {
    double distance;
    Color color;
    double glow = 0;  // 1: it shines by itself
};
using Body = std::function<Matter(Vec3)>;

// The nearer of two.
inline Matter either(const Matter& a, const Matter& b) { return a.distance < b.distance ? a : b; }

double ball(Vec3 p, Vec3 middle, double radius);
// A stick with round ends.
double stick(Vec3 p, Vec3 a, Vec3 b, double radius);
// Upright, its radius growing evenly from foot to top.
double cone(Vec3 p, double foot, double top, double foot_radius, double top_radius);
double box(Vec3 p, Vec3 middle, Vec3 half);

// The body seen from an eighth of a turn: 0 from the front, 2 from its left. The picture is as wide as it says in
// texels, `size` of them a metre; the body's foot is at the middle of the lowest row but `below`.
Painter figure(const Body& body, int view, int width, int height, double size, double below);

}  // namespace draw_textures
