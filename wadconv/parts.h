// A map's sectors as parts: each one outline with its holes, and what lies around every point.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "wadconv/edges.h"
#include "wadconv/loops.h"
#include "wadconv/report.h"

namespace enfilade::wadconv {

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
