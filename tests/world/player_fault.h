// What must hold of the player after every tick, whatever the map.
#pragma once
#include <cmath>
#include <string>

#include "world/world.h"

namespace enfilade::test {

inline bool is_finite(const Player& p) {
    return std::isfinite(p.feet_z) && std::isfinite(p.eye_z) && std::isfinite(p.velocity.x) &&
           std::isfinite(p.velocity.y) && std::isfinite(p.place.point.x) && std::isfinite(p.place.point.y);
}

/// Looks at the player after each tick of one walk.
class PlayerWatch {
public:
    /// What is wrong; empty: nothing.
    std::string fault_of(const Map& map, const World& world) {
        const Player& player = world.player;
        const Instant at = now(map, world);
        if (!is_finite(player)) return "a number of the player is not finite";
        if (!contains(map, player.place.sector, player.place.point)) return "the player is outside of the sector";
        const Body body = body_of(at, player);
        const bool is_free = body.radius == kBodyRadius;
        const bool is_sent = was_sent(map, world);
        if (!is_one_way_exit_near(map, at, body) && !around(at, body).walls.empty()) return "the body is in a wall";
        if (was_free_ && !is_free && !is_sent) return "the body got into a wall";
        was_free_ = is_free;
        const Clearance free = clearance(at, body, around(at, body).sectors);
        if (!is_at_most(free.floor_z, player.feet_z)) return "the feet are below the floor";
        if (!is_at_most(player.height, free.ceiling_z - player.feet_z)) return "the head is above the ceiling";
        if (!is_at_most(player.eye_z, body.ceiling_z)) return "the eye is above the ceiling";
        const Eye eye = eye_between_ticks(map, world, 0.5);
        if (!contains(map, eye.place.sector, eye.place.point)) return "the eye between ticks is outside of its sector";
        return "";
    }

private:
    /// Which alone may touch a body.
    static bool is_one_way_exit_near(const Map& map, const Instant& at, const Body& body) {
        bool is_near = false;
        for (const ReachedWall& wall : around(at, body).walls) is_near = is_near || is_one_way_exit(map, wall);
        return is_near;
    }

    /// Whether the last tick ended somewhere else, be it between walls.
    bool was_sent(const Map& map, const World& world) {
        bool is_sent = false;
        const auto& firings = world.history.firings();
        for (; seen_ < firings.size(); ++seen_)
            is_sent = is_sent || map.triggers[firings[seen_].trigger.index].action == TriggerAction::teleport;
        return is_sent;
    }

    std::size_t seen_ = 0;   ///< of the firings
    bool was_free_ = false;  ///< of walls: who is free stays free
};

}  // namespace enfilade::test
