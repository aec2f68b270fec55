// When a moving disc first touches a wall or a solid thing.
#pragma once
#include <optional>

#include "space/reach.h"
#include "world/obstacle.h"

namespace enfilade {

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
