// A world that is played, and its past: what was pressed in every tick, so that any moment can be had again.
#pragma once
#include <span>
#include <vector>

#include "world/input.h"
#include "world/world.h"

namespace enfilade {

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
