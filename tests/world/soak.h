// A long random walk that uses whatever it meets, checked after every tick.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "support/trials.h"
#include "world/random_walks.h"
#include "world/world.h"

namespace enfilade::test {

inline bool is_finite(const Player& p) {
    return std::isfinite(p.feet_z) && std::isfinite(p.eye_z) && std::isfinite(p.velocity.x) &&
           std::isfinite(p.velocity.y) && std::isfinite(p.place.point.x) && std::isfinite(p.place.point.y);
}

/// Walks for some ticks, uses what is there, and checks after each. The world in the end.
inline World soak(const Map& map, World world, std::uint64_t seed, int ticks) {
    RandomKeys keys(seed);
    Random hand(seed);
    bool was_free = false;
    count_trials(static_cast<std::uint64_t>(ticks), "ticks");
    for (int i = 0; i < ticks && !::testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(::testing::Message() << map.name << ", seed " << seed << ", tick " << i);
        TickInput input = keys.next();
        if (hand.below(8) == 0) input.buttons |= kButtonUse;
        step(map, world, input);
        world.health = kFullHealth;  // who is dead walks no more
        const Player& player = world.player;
        [&] {
            ASSERT_TRUE(is_finite(player));
            ASSERT_TRUE(contains(map, player.place.sector, player.place.point));
            const Body body = body_of(now(map, world), player);
            const Instant at = now(map, world);
            const Clearance free = clearance(at, body, around(at, body).sectors);
            ASSERT_TRUE(is_at_most(free.floor_z, player.feet_z)) << free.floor_z << " " << player.feet_z;
            ASSERT_TRUE(is_at_most(player.height, free.ceiling_z - player.feet_z)) << free.ceiling_z;
            // Who is free of walls stays free of them.
            ASSERT_TRUE(!was_free || body.radius == kBodyRadius);
            was_free = body.radius == kBodyRadius;
            ASSERT_LE(player.eye_z, body.ceiling_z);
            const Eye eye = eye_between_ticks(map, world, 0.5);
            ASSERT_TRUE(contains(map, eye.place.sector, eye.place.point));
        }();
    }
    return world;
}

}  // namespace enfilade::test
