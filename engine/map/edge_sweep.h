// One pass over the edges of a sector: which of them meet where they must not, and which have the sector on the wrong
// side. Exact, whatever the edges are.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "map/map.h"
#include "math/vec.h"

namespace enfilade {

// The order in which a line that sweeps over the edges of a sector meets them: from left to right, points of the same x
// in the order of y. Exact.

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

/// How two edges meet. Sharing an end is no meeting: loops may touch at vertices.
enum class Meeting : std::uint8_t {
    none,
    crossing,     ///< in a point inside both
    touching,     ///< an end of one lies inside the other
    overlapping,  ///< along more than a point
    back_to_back  ///< the same edge in both directions: a wall without thickness between two parts of a sector
};

/// Exact. Both edges have a length.
Meeting meeting_of(const Wall& e, const Wall& f);

/// Two edges that cross, touch or overlap; for touching, `second` is the one that is touched inside.
struct Clash {
    Meeting kind;
    std::uint32_t first, second;  ///< indices into the edges
};

struct SweepFindings {
    /// Every edge is in at most one clash as `second`: after a clash it is left out, so that a tangle of n edges
    /// makes n findings and not n^2.
    std::vector<Clash> clashes;
    /// Edges that do not have the inside (by the even-odd rule) on their right. Empty where there are clashes.
    std::vector<std::uint32_t> wrong_sided;
    /// For each edge, whether another one is back to back with it.
    std::vector<std::uint8_t> is_paired;
    std::size_t pairs_looked_at = 0;  ///< the work done: at most 3 for each edge, and 1 for each clash
};

/// Edges without a length are left out. Cost: O(n log n), by a sweep (Shamos, Hoey: "Geometric intersection problems",
/// 1976) along x, points of the same x in the order of y.
SweepFindings sweep_edges(std::span<const Wall> edges);

// Where two edges cross, exactly, as text for a finding.

/// The point where the lines a -> b and c -> d, which are not parallel, cross: "(2, 1.5)" where decimals can say it,
/// else fractions: "(4/3, 2), about (1.333, 2)". All four points on the vertex grid.
std::string crossing_text(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace enfilade
