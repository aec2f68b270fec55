// One pass over the edges of a sector: which of them meet where they must not, and which have the sector on the wrong
// side. Exact, whatever the edges are.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "map/map.h"

namespace enfilade {

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

}  // namespace enfilade
