// The state of the world: everything that changes with time, as one plain value. A copy is a snapshot to come back to.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "map/map.h"
#include "world/player.h"

namespace enfilade {

struct World {
    std::uint64_t tick = 0;  ///< ticks since the start
    Player player;

    /// What drawing between two ticks needs, and nothing else: the player one tick ago, in the space where it then
    /// was, and the way from there into the space where it is now. The future does not depend on it.
    Player before;
    Rigid passage;
};

/// The world as a map begins; none where the map has no start.
std::optional<World> start_of(const Map& map);

/// Equal for equal states on every machine; value by value. Leaves out what is only for drawing.
std::uint64_t hash(const World& world);

/// One line "name: a / b" for each value in which two states differ, empty where they are the same.
std::string difference(const World& a, const World& b);

}  // namespace enfilade
