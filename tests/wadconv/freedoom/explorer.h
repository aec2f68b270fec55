// Somebody who wants to see every sector of a map and presses nothing but the keys for walking.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/hash.h"
#include "wadconv/freedoom/floor_grid.h"
#include "world/input.h"
#include "world/world.h"

namespace enfilade::test {

/// The sectors that may be reached on foot, by height alone: steps that can be climbed, openings that can be crouched
/// through, any drop. Whether a body also fits between the walls is not looked at.
std::vector<bool> walkable_from(const Map& map, SectorId start);

/// Numbers of the sectors that are marked, as "0-4 7 9-12".
std::string ranges_text(const std::vector<bool>& marked);

/// Goes to the nearest sector it has not seen, around whatever stands in the way; strays about where it is wedged in,
/// and goes anywhere at all once it has seen what it can.
class Explorer {
public:
    Explorer(const Map& map, std::uint64_t seed);

    /// The keys for the next tick.
    TickInput next(const World& world);

    /// Sectors the middle of the body has been in, or has passed over between two ticks.
    const std::vector<bool>& visited() const { return visited_; }
    std::size_t visited_count() const;

    /// Sectors that a body gets into from here, whatever it has been given up on. Cost: the whole map's floor.
    std::vector<bool> in_reach(const Player& player);

private:
    void look_around(const Player& player);
    void plan(const Player& player);
    void follow(const Player& player);
    void give_up();
    Vec2 ahead(std::size_t points) const;
    bool goes_straight(const Player& player) const;
    bool has_to_crouch() const;
    TickInput stray();
    TickInput walk(const Player& player) const;

    const Map& map_;
    Random random_;
    FloorGrid grid_;
    Place last_;  ///< where it was a tick ago
    std::vector<bool> visited_;
    std::vector<std::uint8_t> tries_;  ///< by sector: how often it was set out for
    std::vector<std::uint32_t> way_;   ///< points to walk along
    std::size_t at_ = 0;               ///< the next of them
    int patience_ = 0;                 ///< ticks until the next point is given up
    int straying_ = 0;                 ///< ticks left of going anywhere
    SectorId goal_;                    ///< what it set out for; none: anywhere
    TickInput stray_keys_;
};

}  // namespace enfilade::test
