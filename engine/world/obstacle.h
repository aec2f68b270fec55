// Solid things near a body: upright cylinders that it may not get into.
#pragma once
#include "base/short_list.h"
#include "world/body.h"

namespace enfilade {

/// A solid thing that a body might touch.
struct Obstacle {
    ThingId thing;
    Rigid passage;  ///< from the space of the body's place into that of the thing
    Vec2 centre;    ///< the middle of the body in the space of the thing, on the point grid
    double limit;   ///< how near to the thing the middle may come: both radii [m], on the point grid
    double bottom;  ///< [m], in the space of the body's place
    double top;     ///< [m], likewise
};

/// As many as anybody stands between; more are as good, but take memory.
using Obstacles = ShortList<Obstacle, 8>;

/// The solid things whose discs come nearer to the body's than `way`; with 0, those that overlap it. At whatever height
/// they are, and also behind portals that the body cannot pass. Exact.
/// Cost: the solid things and the walls of the sectors around the body; none in a map without solid things.
Obstacles obstacles_near(const Instant& now, const Body& body, double way);

/// Whether the obstacle is neither below the body's feet nor above its head.
bool is_beside(const Obstacle& obstacle, const Body& body);

/// Whether the body's disc is nearer to the thing than the limit. Exact.
bool overlaps(const Map& map, const Obstacle& obstacle);

}  // namespace enfilade
