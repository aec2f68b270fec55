// One tick of walking: a body moves, slides along what it touches, and never gets into a wall.
//
// Sweep, then certify: where the body touches is found in double; where it is put is tested exactly. A place is taken
// only if the middle of the body gets there on a straight way (space/trace.h) and the disc touches nothing
// there (space/reach.h). If it does not fit, it is moved off by a few grid steps, and failing that it goes only part of
// the way. So a body that fits goes on fitting, for ever, and no tolerance decides anything.
#pragma once
#include "world/body.h"

namespace enfilade {

/// Where a walk led.
struct Walk {
    Place end;
    Rigid passage;        ///< from the space of the start into that of the end
    Vec2 velocity;        ///< what the walls left of it, in the space of the end [m/s]
    Crossings crossings;  ///< the portals, and the panels with triggers, that its middle passed, in order

    // What it cost.
    int queries = 0;                  ///< of what the body touches, at most kMostQueries
    std::size_t walls_looked_at = 0;  ///< by them
};

/// A body touches at most five walls on one walk; on the way to each, the whole way and six parts of it are tried, each
/// with up to four steps off what is in the way.
inline constexpr int kMostQueries = 5 * (1 + (1 + 6) * 4);

/// Moves a body that fits for some time. Its feet stay at their height: steps are taken afterwards.
/// Pushing straight at a wall moves it by nothing, however often it is repeated.
///
/// body     : fits (world/body.h: squeezed), but for the exits of one-way portals that it is still in
/// velocity : [m/s]; |velocity| * seconds may be longer than the body is wide
/// Cost: Walk::queries of what the body touches (space/reach.h), where nothing is in the way two; some of them of all
/// it might touch on its whole way. As many traces (space/trace.h) of that way: they look at the walls of each sector
/// passed.
Walk walk(const Instant& now, const Body& body, Vec2 velocity, double seconds);

}  // namespace enfilade
