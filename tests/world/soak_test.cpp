// Long random walks: the player never leaves the world, never gets into a wall, and every machine agrees where it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/files.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "map/load.h"
#include "world/soak.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

// hard case I11
TEST(Soak, StaysInTheWorldOverMosaicsOfSteps) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Map map = mosaic_of_steps(seed);
        Random random(seed);
        soak(map, start_somewhere(map, random), seed, 2000);
    }
}

/// Any action on any activation, to any sectors.
Trigger random_trigger(Map& map, Activation activation, Random& random) {
    static constexpr TriggerAction kActions[] = {
        TriggerAction::door,  TriggerAction::open,   TriggerAction::close,   TriggerAction::close_then_open,
        TriggerAction::lift,  TriggerAction::floor,  TriggerAction::shuttle, TriggerAction::ceiling,
        TriggerAction::crush, TriggerAction::stairs, TriggerAction::stop,    TriggerAction::teleport};
    Trigger trigger;
    trigger.on = activation;
    trigger.action = kActions[random.below(std::size(kActions))];
    trigger.targets = {static_cast<std::uint32_t>(map.targets.size()), static_cast<std::uint32_t>(1 + random.below(3))};
    for (std::uint32_t i = 0; i < trigger.targets.count; ++i)
        map.targets.emplace_back(random.below(map.sectors.size()));
    if (trigger.action == TriggerAction::teleport) trigger.destination = ThingId(random.below(map.things.size()));
    trigger.to = static_cast<HeightLevel>(random.below(9));
    trigger.by = random.uniform(-1, 1);
    trigger.speed = random.uniform(0.5, 12);
    trigger.wait_s = random.uniform(0, 2);
    trigger.step = random.uniform(-0.5, 1);
    trigger.crushes = random.below(3) == 0;
    return trigger;
}

/// Gives every sector two triggers, and things to teleport to and to bump into.
Map restless(Map map, std::uint64_t seed) {
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
        const World somewhere = start_somewhere(map, random);
        Thing thing;
        thing.sector = somewhere.player.place.sector;
        thing.position = somewhere.player.place.point;
        thing.radius = 0.25;
        thing.height = 1;
        map.things.push_back(thing);
    }
    for (Sector& sector : map.sectors) {
        sector.triggers = {static_cast<std::uint32_t>(map.triggers.size()), 2};
        for (const Activation on : {Activation::enter, Activation::use})
            map.triggers.push_back(random_trigger(map, on, random));
        Surface moving = map[sector.floor.surface];
        moving.scroll = {random.uniform(-3, 3), random.uniform(-3, 3)};
        sector.floor.surface = SurfaceId(map.surfaces.size());
        map.surfaces.push_back(moving);
        sector.floor.carries = random.below(4) == 0;
    }
    return map;
}

// With ENFILADE_LONG more than a million ticks.
// hard cases C21, I11
TEST(Soak, StaysInTheWorldWhereEverythingMoves) {
    const int ticks = std::getenv("ENFILADE_LONG") ? 100'000 : 3000;
    std::size_t changes = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Map map = restless(seed % 2 == 0 ? mosaic_of_steps(seed) : octagons_of_links(seed), seed);
        Random random(seed);
        changes += soak(map, start_somewhere(map, random), seed, ticks).history.changes().size();
    }
    EXPECT_GT(changes, 1000u);  // much has moved
}

// hard case I11
TEST(Soak, StaysInTheWorldWhereEveryDoorwayIsALink) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Map map = octagons_of_links(seed);
        Random random(seed);
        soak(map, start_somewhere(map, random), seed, 2000);
    }
}

// hard case I11
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
// hard case I13
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
    EXPECT_EQ(all.value(), 14072136405091814930u);
}

/// The worlds of many players in one map, each after a walk of its own, played on so many threads.
std::vector<std::uint64_t> played_on(const Map& map, std::size_t threads) {
    constexpr std::size_t kPlayers = 24;
    constexpr int kTicks = 600;
    std::vector<std::uint64_t> hashes(kPlayers);
    parallel_for(kPlayers, threads, [&](std::size_t player, std::size_t) {
        Random random(player);
        World world = start_somewhere(map, random);
        RandomKeys keys(player);
        for (int i = 0; i < kTicks; ++i) step(map, world, keys.next());
        hashes[player] = hash(world);
    });
    return hashes;
}

// A world has one body; what many of them share is the map.
// hard cases I13, C27
TEST(Soak, EndsInTheSameStatesWhicheverThreadsPlayThem) {
    for (const Map& map : {restless(mosaic_of_steps(1), 1), restless(octagons_of_links(2), 2)}) {
        const std::vector<std::uint64_t> alone = played_on(map, 1);
        for (const std::size_t threads : {2u, 3u, 8u}) EXPECT_EQ(played_on(map, threads), alone) << threads;
    }
    count_trials(2 * 4 * 24 * 600, "ticks");
}

}  // namespace
}  // namespace enfilade
