// One tick of the world.
#pragma once
#include <span>
#include <vector>

#include "world/input.h"
#include "world/world.h"

namespace enfilade {

/// Lets a tick pass, 1/60 s as a rule. Phases, in this order: look, use, floors and ceilings move (world/step.cpp),
/// stand up or crouch, wish and grip, ride, walk and what it sets off, step or fall, eye, touch, what the floor does.
/// The same state and input give the same state on every machine. Afterwards the player's sector contains the player.
/// Cost: a walk (world/body.h), a second one where a floor carries, and about a dozen more queries of what the body
/// touches (space/reach.h); and what the triggers that go off change.
void step(const Map& map, World& world, const TickInput& input);

/// Full pace [m/s]. Doom's marine runs 18 m/s where 32 of its units are a metre: at eye level in a room with furniture
/// a bit less than half of that is fast.
inline constexpr double kWalkSpeed = 4, kRunSpeed = 8, kCrouchSpeed = 2;

// A world that is played, and its past: what was pressed in every tick, so that any moment can be had again.

/// Worlds kept on the way: the past costs little memory, and coming back to it a few ticks [ticks].
inline constexpr std::size_t kBetweenKept = 32;

class Timeline {
public:
    Timeline() = default;
    /// Begins with a world, at whatever tick that is.
    explicit Timeline(World start);

    /// Lets a tick pass.
    void play(const Map& map, const TickInput& input);

    const World& world() const { return world_; }
    /// What was pressed in each tick since the beginning.
    std::span<const TickInput> inputs() const { return inputs_; }

    /// The world as it was so many ticks after the beginning, at most inputs().size(). Bit for bit the same.
    /// Cost: kBetweenKept ticks, and what had happened by then.
    World after(const Map& map, std::size_t ticks) const;

    /// Goes back to that moment and forgets what came later.
    void go_back(const Map& map, std::size_t ticks);

private:
    /// A moment on the way, its history left out: it is the beginning of the present one.
    struct Kept {
        World world;
        History::Length length;
    };
    void keep();

    World world_;
    std::vector<TickInput> inputs_;
    std::vector<Kept> kept_;  ///< after 0, kBetweenKept, 2 kBetweenKept, … ticks
};

}  // namespace enfilade
