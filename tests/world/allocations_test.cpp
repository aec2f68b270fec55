// A tick takes no memory: not while nothing happens, nor while somebody runs about, nor while things move.
#include <gtest/gtest.h>

#include "support/count_allocations.h"
#include "support/generate_map.h"
#include "world/random_walks.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWarmUp = 200, kTicks = 600;

/// What is taken from the heap while somebody presses keys and looks, once everything has grown as large as it gets.
std::size_t allocations_of_ticks(const Map& map, World world, RandomKeys* keys) {
    Snapshot snapshot = at_rest(map);
    std::size_t before = 0;
    for (int tick = 0; tick < kWarmUp + kTicks; ++tick) {
        if (tick == kWarmUp) before = allocations();
        step(map, world, keys ? keys->next() : kNoKeys);
        show(now(map, world), snapshot);
    }
    return allocations() - before;
}

/// Rooms with an effect each, things among them.
MapFile furnished_rooms() {
    MapFile file = grid_of_rooms(200);
    for (SectorRecord& sector : file.sectors) {
        sector.triggers = {trigger_on(Activation::use, TriggerAction::door)};
        sector.light_effect = LightEffectRecord{};
    }
    for (int i = 0; i < 40; ++i) {
        ThingRecord thing;
        thing.position = {4.0 + 8 * (i % 8), 2.0 + 8 * (i / 8)};
        thing.solid = true;
        thing.radius = 0.25;
        thing.height = 1;
        thing.gives_health = 10;
        file.things.push_back(thing);
    }
    return file;
}

TEST(Tick, TakesNoMemoryWhileNothingHappens) {
    const Game game(furnished_rooms());
    EXPECT_EQ(allocations_of_ticks(game.map, game.world, nullptr), 0u);
}

TEST(Tick, TakesNoMemoryWhileSomebodyRunsAbout) {
    const Game game(furnished_rooms());
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        RandomKeys keys(seed);
        EXPECT_EQ(allocations_of_ticks(game.map, game.world, &keys), 0u) << "seed " << seed;
    }
}

TEST(Tick, TakesNoMemoryOnStairsAndInCornersOfAnyShape) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Map map = mosaic_of_steps(seed);
        Random random(seed);
        RandomKeys keys(seed);
        EXPECT_EQ(allocations_of_ticks(map, start_somewhere(map, random), &keys), 0u) << "seed " << seed;
    }
}

// A thing that is wide does not make anybody look through all rooms that are as near as it is wide.
TEST(Tick, TakesNoMemoryBesideAWideThingAmongNarrowRooms) {
    MapFile file = fan_of_sectors(1000);
    ThingRecord tower;
    tower.position = {200, 0.25};
    tower.solid = true;
    tower.radius = 30;
    tower.height = 2;
    file.things = {tower};
    for (const Vec2 start : {Vec2{168, 4}, Vec2{200, 38}, Vec2{232, -4}}) {
        const Map map = built(file);
        place_player(file, map[locate(map, start)].name, start, kEyeOnFloor);
        const Game game(file);
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            RandomKeys keys(seed);
            EXPECT_EQ(allocations_of_ticks(game.map, game.world, &keys), 0u) << "seed " << seed;
        }
    }
}

TEST(Tick, TakesNoMemoryAmongPanels) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 10)});
    for (int i = 0; i < 8; ++i) {
        PanelRecord panel;
        panel.a = {1.25 * i, 1.0 * i};
        panel.b = {1.25 * i, 1.0 * i + 3};
        panel.texture = spec("-");
        panel.blocks = i % 2 == 0;
        panel.triggers = {trigger_on(Activation::use, TriggerAction::door)};
        panel.triggers[0].key = "of nobody";
        file.sectors[0].panels.push_back(panel);
    }
    place_player(file, "hall", {2, 5}, kEyeOnFloor);
    const Game game(file);
    RandomKeys keys(1);
    EXPECT_EQ(allocations_of_ticks(game.map, game.world, &keys), 0u);
}

TEST(Tick, TakesNoMemoryWhileFloorsMove) {
    MapFile file = furnished_rooms();
    for (std::size_t i = 0; i < 10; ++i)
        file.sectors[i].triggers.push_back(trigger_on(Activation::start, TriggerAction::shuttle));
    const Game game(file);
    RandomKeys keys(1);
    EXPECT_EQ(allocations_of_ticks(game.map, game.world, &keys), 0u);
}

}  // namespace
}  // namespace enfilade
