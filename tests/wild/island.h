// A piece of ground cut into triangles, in whole steps of the vertex grid: needles, fans, points on and beside edges.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "wild/choices.h"

namespace enfilade::test {

/// In steps of the vertex grid; coordinates of the world fit 26 bits.
struct GridPoint {
    std::int64_t x = 0, y = 0;
    bool operator==(const GridPoint&) const = default;
};

inline Vec2 metres(GridPoint p) {
    return {static_cast<double>(p.x) * kVertexGrid, static_cast<double>(p.y) * kVertexGrid};
}

/// Twice the area of a triangle, positive where its corners run clockwise on the drawing. Exact.
constexpr std::int64_t doubled_area(GridPoint a, GridPoint b, GridPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Triangles by the numbers of their corners, clockwise. They cover a rectangle, or half of it, without a gap.
class Island {
public:
    /// From `corner` on; width, height: >= 1 [grid steps].
    Island(GridPoint corner, std::int64_t width, std::int64_t height, bool is_triangle);

    /// Puts a point where it hurts: anywhere, on an edge, a step off an edge or a point, or on a lattice. Points off
    /// the ground, and where one is, are none.
    void strew(Choices& choices);
    /// Cuts an edge by up to `count` points, so that a fan of triangles hangs on each point beside it.
    void fan(Choices& choices, std::uint64_t count);
    /// Turns an edge inside the quadrilateral around it, if that is convex.
    void turn(Choices& choices);

    const std::vector<GridPoint>& points() const { return points_; }
    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

private:
    GridPoint at(int number) const { return points_[static_cast<std::size_t>(number)]; }
    GridPoint hard_point(Choices& choices) const;
    void insert(GridPoint p);
    void cut(std::size_t triangle, int number);

    GridPoint corner_;
    std::int64_t width_, height_;
    std::vector<GridPoint> points_;
    std::vector<std::array<int, 3>> triangles_;
};

}  // namespace enfilade::test
