// The parts of a Doom map, each a room: from its lines to edges, from edges to loops, from loops to parts.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "wadconv/report.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// A map's lines as directed edges of sectors: bad numbers, lines without length and lines drawn twice are gone.

/// A corner in map units, y DOWN as everywhere in enfilade. Doom's own y times -1, so 17 bits.
struct Point {
    std::int32_t x = 0;
    std::int32_t y = 0;
    auto operator<=>(const Point&) const = default;
};

/// Twice the area of the triangle o, a, b: positive where b lies clockwise of a on the drawing. Exact.
constexpr std::int64_t cross(Point o, Point a, Point b) {
    return std::int64_t{a.x - o.x} * (b.y - o.y) - std::int64_t{a.y - o.y} * (b.x - o.x);
}

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// One side of a line: a directed edge with its sector on the right.
struct Edge {
    Point a, b;
    std::uint32_t sector = kNone;
    std::uint32_t line = kNone;      ///< the linedef; kNone: the edge was added to close a sector
    std::uint32_t side = kNone;      ///< the sidedef; kNone likewise
    bool is_left = false;            ///< the line's left side, which runs from its end to its start
    bool is_open = false;            ///< one may pass to the opposite edge's sector
    bool was_open = false;           ///< until the room behind it was left out
    std::uint32_t opposite = kNone;  ///< the edge b -> a, if there is one
};

/// The edges of all lines, in the order of the lines, right side before left. No two edges run from the same point
/// to the same point. Counts the sides that became no edge.
std::vector<Edge> collect_edges(const DoomMap& map, Report& report);

// From a sector's edges to simple closed loops.

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

// A map's sectors as parts: each one outline with its holes, and what lies around every point.

/// One connected piece of a Doom sector.
struct Part {
    std::uint32_t sector = kNone;  ///< the Doom sector
    std::uint32_t number = 0;      ///< 0 for the sector's first piece
    std::vector<Loop> loops;       ///< the outline, then its holes
    Point min, max;                ///< bounding box of the outline
};

/// All pieces of a map. An edge with the same sector on both sides that separates nothing is in no part but is lone.
struct Parts {
    std::vector<Edge> edges;
    std::vector<Part> parts;                  ///< by Doom sector, then by the outline's lowest edge
    std::vector<std::uint32_t> count_of;      ///< parts of each Doom sector
    std::vector<std::uint32_t> part_of_edge;  ///< index into parts for each edge, or kNone
    std::vector<std::uint32_t> lone;          ///< edges, rising; opposite edges are both there
    std::vector<std::uint32_t> lost;          ///< Doom sectors of which a room was left out, rising
};

/// The edges' sectors traced, outlines and holes told apart by exact area, every hole given to the smallest outline of
/// its sector around it, and every outline made a part of its own. On the way
///   - a sector that lacks a single edge is closed with it (guessed: a solid wall);
///   - a ring of edges with the same sector on both sides that lies in no outline of it but inside another sector
///     ("deep water") gives its outside to that sector;
///   - a room whose own lines cross or lie on each other is left out: a part, or where no parts can be told the whole
///     sector; the doorways into it are closed (guessed).
/// An Error names the sector that cannot be closed, or that is inside out.
Result<Parts> make_parts(std::vector<Edge> edges, std::size_t sector_count, Report& report);

/// "s12", and for further pieces "s12b", "s12c", …, "s12z", "s12aa", …
std::string part_name(const Part& part);

/// Twice the area of the outline less its holes [map units^2].
std::int64_t double_area(const Part& part);

/// True where the part contains the point, under the tie rule of math/predicates.h. Exact.
bool contains(const Parts& parts, const Part& part, Point fine);

/// The first part that contains the point, or kNone. Cost: all bounding boxes.
std::uint32_t part_at(const Parts& parts, Point fine);

}  // namespace enfilade::wadconv
