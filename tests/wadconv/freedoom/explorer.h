// Somebody who wants to see every sector of a map and presses nothing but the keys for walking.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "base/random.h"
#include "world/input.h"
#include "world/world.h"

namespace enfilade::test {

/// The sectors that may be reached on foot, by height alone: steps that can be climbed, openings that can be crouched
/// through, any drop. Whether a body also fits between the walls is not looked at.
std::vector<bool> walkable_from(const Map& map, SectorId start);

/// Numbers of the sectors that are marked, as "0-4 7 9-12".
std::string ranges_text(const std::vector<bool>& marked);

/// Goes to the nearest sector it has not seen, portal by portal; strays about where it gets no further, and to any
/// sector at all once it has seen what it can.
class Explorer {
public:
    Explorer(const Map& map, std::uint64_t seed);

    /// The keys for the next tick.
    TickInput next(const World& world);

    const std::vector<bool>& visited() const { return visited_; }
    std::size_t visited_count() const;

private:
    void follow_plan(SectorId here);
    void plan_from(SectorId here);
    void give_up(SectorId here);
    TickInput stray();
    TickInput walk_to_portal(const Player& player) const;

    const Map& map_;
    Random random_;
    std::vector<bool> visited_;
    std::vector<std::uint8_t> failures_;  ///< by wall: how often it was not reached
    std::deque<WallId> plan_;             ///< portals still to be passed
    int patience_ = 0;                    ///< ticks until the next portal is given up, if nothing new is seen
    int straying_ = 0;                    ///< ticks left of going anywhere
    TickInput stray_keys_;
};

}  // namespace enfilade::test
