// Long random walks: the player never leaves the world, never gets into a wall, and every machine agrees where it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/files.h"
#include "base/hash.h"
#include "map/load.h"
#include "world/camera.h"
#include "world/random_walks.h"

namespace enfilade {
namespace {

using namespace test;

bool is_finite(const Player& p) {
    return std::isfinite(p.feet_z) && std::isfinite(p.eye_z) && std::isfinite(p.velocity.x) &&
           std::isfinite(p.velocity.y) && std::isfinite(p.place.point.x) && std::isfinite(p.place.point.y);
}

/// Walks for some ticks and checks after each.
void soak(const Map& map, World world, std::uint64_t seed, int ticks) {
    RandomKeys keys(seed);
    bool was_free = false;
    for (int i = 0; i < ticks && !testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << map.name << ", seed " << seed << ", tick " << i);
        step(map, world, keys.next());
        const Player& player = world.player;
        [&] {
            ASSERT_TRUE(is_finite(player));
            ASSERT_TRUE(contains(map, player.place.sector, player.place.point));
            const Body body = body_of(map, player);
            // Who is free of walls stays free of them.
            ASSERT_TRUE(!was_free || body.radius == kBodyRadius);
            was_free = body.radius == kBodyRadius;
            ASSERT_LE(player.eye_z, body.ceiling_z);
            const Eye eye = eye_between_ticks(map, world, 0.5);
            ASSERT_TRUE(contains(map, eye.place.sector, eye.place.point));
        }();
    }
}

TEST(Soak, StaysInTheWorldOverMosaicsOfSteps) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Map map = mosaic_of_steps(seed);
        Random random(seed);
        soak(map, start_somewhere(map, random), seed, 2000);
    }
}

TEST(Soak, StaysInTheWorldWhereEveryDoorwayIsALink) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Map map = octagons_of_links(seed);
        Random random(seed);
        soak(map, start_somewhere(map, random), seed, 2000);
    }
}

TEST(Soak, StaysInTheWorldInTheMapsThatComeWithTheEngine) {
    for (const auto& entry : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/maps")) {
        if (entry.path().extension() != ".toml") continue;
        const LoadedMap loaded = load_map(entry.path().string(), {}, read_file);
        ASSERT_TRUE(loaded.map.has_value()) << entry.path();
        const std::optional<World> start = start_of(*loaded.map);
        ASSERT_TRUE(start.has_value()) << entry.path();
        soak(*loaded.map, *start, 1, 3000);
    }
}

// Every compiler, optimisation and machine must end here. The number changes with the rules of motion, the generators
// above and nothing else: where it changed although none of those did, something depends on the machine.
TEST(Soak, EndsInTheSameStateOnEveryMachine) {
    Hash all;
    for (std::uint64_t seed = 0; seed < 6; ++seed)
        for (const Map& map : {mosaic_of_steps(seed), octagons_of_links(seed)}) {
            Random random(seed);
            World world = start_somewhere(map, random);
            RandomKeys keys(seed);
            for (int i = 0; i < 1000; ++i) step(map, world, keys.next());
            all.add(hash(world));
        }
    EXPECT_EQ(all.value(), 14324029055056606743u);
}

}  // namespace
}  // namespace enfilade
