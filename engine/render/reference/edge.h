// Walls and panels as edges in the plane, and which of two a ray meets first.
#pragma once
#include "map/map.h"

namespace enfilade {

/// A directed edge.
struct Edge {
    Vec2 a, b;  ///< on the vertex grid

    Edge(Vec2 start, Vec2 end) : a(start), b(end) {}
    Edge(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// Where e lies as seen from the line of another: 1 on its right, -1 on its left (touching allowed), 0 on both sides or
/// all on the line. Edges of a sector and its panels never cross: where this is 0 one way round, it is not the other,
/// unless both are on one line.
int side_of_edge(const Edge& line, const Edge& e);

bool are_on_one_line(const Edge& e, const Edge& f);

/// Both face the eye and cover the ray: is e met before f? Not if both are on one line.
bool is_in_front(const Edge& e, const Edge& f);

}  // namespace enfilade
