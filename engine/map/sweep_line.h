// The order in which a line that sweeps over the edges of a sector meets them: from left to right, points of the same x
// in the order of y. Exact.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// Does the sweep meet a before b?
bool is_left_of(Vec2 a, Vec2 b);

/// An edge as the sweep sees it.
struct SweptEdge {
    Vec2 left, right;  ///< its ends in the order of the sweep
    bool forward;      ///< the wall runs from left to right: its sector lies after it, else before it
};

SweptEdge swept(const Wall& wall);
std::vector<SweptEdge> swept(std::span<const Wall> walls);

/// The order of edges along the sweep line, towards +y: of such as the line meets together and that do not cross left
/// of it. Of two on one line, the one whose sector lies before it is first, so that edges back to back have nothing
/// between them.
struct SweepOrder {
    const std::vector<SweptEdge>* edges;
    bool operator()(std::uint32_t i, std::uint32_t j) const;
};

struct SweepEvent {
    Vec2 point;
    bool starts;  ///< the edge starts here; ends come first, so that edges in a row never see each other
    std::uint32_t edge;
};

/// Both ends of every edge that has a length, in the order of the sweep.
std::vector<SweepEvent> sweep_events(const std::vector<SweptEdge>& edges);

}  // namespace enfilade
