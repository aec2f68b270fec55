// From a sector's edges to simple closed loops.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "wadconv/edges.h"

namespace enfilade::wadconv {

/// Edges that follow one another and close; no point is visited twice.
struct Loop {
    std::vector<std::uint32_t> edges;
    std::int64_t double_area = 0;  ///< [map units^2]; outlines > 0 (clockwise on the drawing), holes < 0

    bool is_outline() const { return double_area > 0; }
};

/// Where the edges of a sector do not close: more of them start at a point than end there, or fewer.
struct OpenEnd {
    Point point;
    int surplus = 0;  ///< starting minus ending edges, never 0
};

struct Tracing {
    std::vector<Loop> loops;          ///< in the order of their lowest edge, which comes first in the loop
    std::vector<std::uint32_t> lone;  ///< edges that have the same side of the same sector on both sides
    std::vector<OpenEnd> open_ends;   ///< not empty: the sector is not closed and there are no loops
    bool is_tangled = false;          ///< lines cross so badly that no simple loops were found
};

/// Traces the edges of one sector (`own`, indices into `edges`) into simple loops.
///
/// Where several edges leave a point, an arriving edge goes on with the first that is met when one turns from the way
/// back, counter-clockwise on the drawing, so that nothing of the sector lies between the two: the tightest turn. That
/// walks once around every connected piece of the boundary. An edge walked both ways in one such walk separates
/// nothing; it is taken out as lone. A walk that passes a point twice is cut there.
///
///      a---b---c      the hole touches the outline in b: the walk passes b twice
///      |  / \  |      and is cut into the outline a b c ... and the hole
///      | d---e |
///      f-------g
///
/// Exact. Cost: O(n log n). `edges` must be as collect_edges leaves them: at most one from any point to any other.
Tracing trace_loops(std::span<const Edge> edges, std::span<const std::uint32_t> own);

/// Places within loops are given in this many steps a map unit: twice as fine as the vertex grid, so that the middle
/// between two of its points is one too.
inline constexpr std::int32_t kFineSteps = 64;

constexpr Point to_fine(Point p) { return {p.x * kFineSteps, p.y * kFineSteps}; }

/// True where the loop goes around the point, under the tie rule of math/predicates.h. Exact.
bool loop_contains(std::span<const Edge> edges, const Loop& loop, Point fine);

/// The lines of those of the edges that cross, touch inside, or lie on each other, rising, each once: the edges of one
/// room may only share ends. Exact. Cost: O(n log n).
std::vector<std::uint32_t> clashing_lines(std::span<const Edge> edges, std::span<const std::uint32_t> own);

}  // namespace enfilade::wadconv
