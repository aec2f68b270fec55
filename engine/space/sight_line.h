// A straight look through the sectors: which portals it passes, how far along each is, and what it meets. Where a
// moving body would stop, and how near to a wall it comes, is asked of trace.h.
#pragma once
#include <vector>

#include "space/trace.h"

namespace enfilade {

/// A portal on the way of a look.
struct PassedPortal {
    WallId portal;
    Vec2 from;        ///< where the look came from, in the space of the portal's sector
    double at = 0;    ///< how much of the way from its beginning to its end lies before the portal, 0..1
    double rise = 0;  ///< from a height in the space where the look began to one in that of the portal's sector [m]
};

/// What became of a look.
struct SightLine {
    std::vector<PassedPortal> passed;  ///< in order
    SectorId sector;                   ///< where it ended
    WallId met;                        ///< the wall of that sector that ended it (solid or a mirror), or none
    Vec2 from;                         ///< where it came from, in the space of that sector
    double rise = 0;                   ///< from heights where it began to those of that sector [m]
};

/// Looks from a place to a point in its space, through every portal whatever the heights there. Exact as trace() is.
/// to: on the point grid, |coordinates| <= 2 * kWorldLimit. line: its memory is used again.
/// A look that passes kMaxLinksOnPath links is ended by the next. Cost: the walls of the sectors passed.
void look_along(const Map& map, const Place& from, Vec2 to, SightLine& line);

}  // namespace enfilade
