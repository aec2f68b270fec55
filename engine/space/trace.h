// A straight path through the sectors: which portals it crosses, in exact order, and what stops it. Every movement,
// look and sound goes through here; nothing else in the engine knows how to cross a portal.
#pragma once
#include <functional>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// A place in the map: a point is only a place together with the sector it is in, because sectors may overlap.
struct Place {
    SectorId sector;
    Vec2 point;  ///< on the point grid, inside the sector

    bool operator==(const Place&) const = default;
};

/// Says whether a path may pass from a sector through one of its portals: heights, blocking, anything.
using MayPass = std::function<bool(WallId portal)>;

/// One portal passed by a path.
struct Crossing {
    WallId portal;
    bool operator==(const Crossing&) const = default;
};

/// What a straight path did.
struct Trace {
    std::vector<Crossing> crossings;  ///< in order along the path
    Place end;                        ///< the path's end; where it was stopped: the last place before the wall
    WallId stopped;                   ///< the wall that ended it (solid, or not to be passed), or none
    Rigid passage;                    ///< from the space of the start into the space of the end
};

/// Follows the path from `from` along `to - from.point` through every portal it crosses, however many, linked or not.
/// Exact: the tie rule makes the order of crossings total, so a path through a vertex, along a wall or of no length
/// has one answer, the reverse path the reversed list, and a split path the joined lists.
/// Through a link the rest of the path is carried over and put onto the point grid.
///
/// to       : on the point grid, in the space of `from`
/// may_pass : asked once for each portal met, in order; empty: every portal may be passed
/// Where the path is stopped, end is the last grid point found on the way that is inside: the position of the
/// start if the wall is at once. Crossings made on the way stay made.
/// Cost: the walls of the sectors passed.
Trace trace(const Map& map, const Place& from, Vec2 to, const MayPass& may_pass = {});

}  // namespace enfilade
