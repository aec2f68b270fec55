// What triggers do to floors, ceilings and lights: one new track for each target.
#pragma once
#include <span>

#include "space/trace.h"
#include "world/history.h"
#include "world/instant.h"
#include "world/world.h"

namespace enfilade {

/// How far an open door stays below the lowest ceiling around [m]: 4 of Doom's units, so that one sees it.
inline constexpr double kDoorHead = 0.125;

/// What crushers leave of a room [m]: 8 of Doom's units.
inline constexpr double kCrushedHeight = 0.25;

/// Adds to the history what the trigger does to its targets at a tick: the changes begin then, or `after` later.
/// Heights are found as they are now. Teleports and exits change nothing here. False where it has targets and none of
/// them takes the order: all are on their way, or have nothing to stop.
/// Cost: the walls of the targets and their groups.
bool carry_out(const Map& map, History& history, TriggerId trigger, std::uint64_t tick);

/// What the start of the map sets off, and nothing more.
History begun(const Map& map, const MotionDials& motion = {});

/// What follows if somebody is in the way of a change.
struct Answer {
    Change at_once;
    std::optional<Change> later;  ///< to be added to the history after the first, which it ends when it begins
};

/// From `tick` on it turns round, or it waits for patience_at() ticks and then goes on with what is left of it.
/// `in_the_way`: the change, which is on its way.
Answer answer_to(const Instant& now, const Change& in_the_way, std::uint64_t tick);

/// What follows if somebody is in the way of a bob, from `tick` on: it stands still for patience_at() ticks and then
/// goes on from there. `sector`: leads its group; nothing but its bob moves the floor or ceiling at the tick.
void hold_up_bob(const Map& map, History& history, SectorId sector, Channel channel, std::uint64_t tick);

/// What follows if a change that crushes comes down on somebody, from `tick` on: the rest of its present way goes at
/// its trigger's crush_speed; none where that is not given, or where it does so already.
std::optional<Change> slowed(const Instant& now, const Change& crusher, std::uint64_t tick);

/// Whether the change hurts who is in its way, down to kCrushedHeight, instead of answering.
bool crushes(const Map& map, const Change& change);

// What sets triggers off: the player's hand, steps and touch.

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
