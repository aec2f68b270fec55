// A map's lines as directed edges of sectors: bad numbers, lines without length and lines drawn twice are gone.
#pragma once
#include <cstdint>
#include <vector>

#include "wadconv/map_lumps.h"
#include "wadconv/report.h"

namespace enfilade::wadconv {

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

}  // namespace enfilade::wadconv
