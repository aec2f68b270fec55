// What sets triggers off: the player's hand, steps and touch.
#pragma once
#include <span>

#include "space/trace.h"
#include "world/world.h"

namespace enfilade {

/// How far one reaches [m]: 64 of Doom's units.
inline constexpr double kArm = 2;

/// Sets a trigger off, if it still works, the player has its key and any of its targets takes orders now: tracks
/// begin, the player is teleported, the map is left. `wall`: whose switch turns, or none.
void fire(const Map& map, World& world, TriggerId trigger, WallId wall);

/// Uses the first wall or panel ahead that has something to use, unless a wall is in front of it.
void use_what_is_ahead(const Map& map, World& world);

/// Sets off what a walk passed, in order: the portals' own triggers, those of their other sides, and those of the
/// sectors behind them; the triggers of panels. Stops where one of them teleports.
void pass(const Map& map, World& world, std::span<const Crossing> crossings);

/// Picks up, and sets off, what the player has come to touch.
void touch_what_is_near(const Map& map, World& world);

}  // namespace enfilade
