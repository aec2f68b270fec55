// One tick of the world.
#pragma once
#include "world/input.h"
#include "world/world.h"

namespace enfilade {

/// Lets 1/60 s pass. Phases, in this order: look, use, floors and ceilings move (world/move_flats.h), stand up or
/// crouch, wish and grip, ride, walk and what it sets off, step or fall, eye, touch, what the floor does.
/// The same state and input give the same state on every machine. Afterwards the player's sector contains the player.
/// Cost: a walk (world/walk.h), a second one where a floor carries, and about a dozen more queries of what the body
/// touches (space/reach.h); and what the triggers that go off change.
void step(const Map& map, World& world, const TickInput& input);

/// Full pace [m/s]. Doom's marine runs 18 m/s where 32 of its units are a metre: at eye level in a room with furniture
/// a bit less than half of that is fast.
inline constexpr double kWalkSpeed = 4, kRunSpeed = 8, kCrouchSpeed = 2;

}  // namespace enfilade
