// When a moving disc first touches a wall or a solid thing.
#pragma once
#include <optional>

#include "base/short_list.h"
#include "space/reach.h"
#include "world/body.h"

namespace enfilade {

// Solid things near a body: upright cylinders that it may not get into.

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

/// A touch on the way.
struct Contact {
    double fraction;  ///< of the way, 0..1; 0: touching already, and moving into the wall
    Vec2 normal;      ///< unit vector from the wall to the disc, in the space of the place
};

/// Where a disc that moves straight from the place of `around` to `target` first touches one of its walls, face or end;
/// of equals the first. None where it gets there free. A touch that would go less than a grid step deep is none: who
/// places the disc there sees to the last step (world/walk.cpp).
///
/// An exit of a one-way portal that holds the disc less or not at all (world/one_way.h) is met accordingly.
///
/// around : reach() of the place with at least the radius plus the length of the way
/// target : on the point grid, in the space of the place
/// radius : of the disc [m]
std::optional<Contact> first_contact(const Map& map, const Reach& around, Vec2 target, double radius);

/// The same for solid things; each may be approached up to its limit, and one that is nearer already may not be
/// approached at all.
std::optional<Contact> first_contact(const Map& map, const Obstacles& obstacles, Vec2 target);

}  // namespace enfilade
