// A long random walk that uses whatever it meets, checked after every tick.
#pragma once
#include <gtest/gtest.h>

#include "support/trials.h"
#include "world/player_fault.h"
#include "world/random_walks.h"
#include "world/world.h"

namespace enfilade::test {

/// Walks for some ticks, uses what is there, and checks after each. The world in the end.
inline World soak(const Map& map, World world, std::uint64_t seed, int ticks) {
    RandomKeys keys(seed);
    Random hand(seed);
    PlayerWatch watch;
    count_trials(static_cast<std::uint64_t>(ticks), "ticks");
    for (int i = 0; i < ticks && !::testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(::testing::Message() << map.name << ", seed " << seed << ", tick " << i);
        TickInput input = keys.next();
        if (hand.below(8) == 0) input.buttons |= kButtonUse;
        step(map, world, input);
        world.health = kFullHealth;  // who is dead walks no more
        [&] { ASSERT_EQ(watch.fault_of(map, world), ""); }();
    }
    return world;
}

}  // namespace enfilade::test
