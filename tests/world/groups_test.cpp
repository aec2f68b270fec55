// Sectors that move as one: one track, the neighbours of all, a body in any of them stops all.
#include <gtest/gtest.h>

#include "world/game.h"
#include "world/snapshot.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

/// A hall, two rooms that move as one, "near" and "far", and a cellar 2 m deep behind them, all 4 m wide, along +x. The
/// player stands in the hall and looks at "near", which begins at x = 8. `ceiling`: of the two.
MapFile hall_group_cellar(double ceiling) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4, 0, 3), box_room("near", 8, 0, 9, 4, 0, ceiling),
                           box_room("far", 9, 0, 10, 4, 0, ceiling), box_room("cellar", 10, 0, 18, 4, -2, 2.5)});
    join_all(file);
    sector(file, "near").group = sector(file, "far").group = "parts";
    place_player(file, "hall", {6.5, 2}, kEyeOnFloor);
    return file;
}

Heights at(const Game& game, std::uint32_t sector) { return heights_of(now(game.map, game.world), SectorId(sector)); }

TEST(Group, FindsItsHeightAroundAllItsSectors) {
    MapFile file = hall_group_cellar(3);
    sector(file, "near").triggers = {trigger_on(Activation::use, TriggerAction::lift)};
    sector(file, "far").triggers = sector(file, "near").triggers;
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 100);
    EXPECT_EQ(at(game, 1).floor_z, -2);
    EXPECT_EQ(at(game, 2).floor_z, -2);
    EXPECT_EQ(game.world.history.changes().size(), 1u);
}

TEST(Group, LooksAroundItselfAndNotAtItsOwnSectors) {
    MapFile file = hall_group_cellar(0);
    for (const char* name : {"near", "far"})
        sector(file, name).triggers = {trigger_on(Activation::use, TriggerAction::open)};
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 120);
    EXPECT_EQ(at(game, 1).ceiling_z, 2.5 - kDoorHead);
    EXPECT_EQ(at(game, 2).ceiling_z, 2.5 - kDoorHead);
}

TEST(Group, IsCalledByTheNameOfAnyOfItsSectorsAndOnce) {
    for (const std::vector<std::string>& targets : {std::vector<std::string>{"far"}, {"far", "near"}}) {
        MapFile file = hall_group_cellar(3);
        TriggerRecord stairs = trigger_on(Activation::enter, TriggerAction::stairs, targets);
        stairs.targets.push_back("cellar");
        sector(file, "hall").triggers = {stairs};
        const Map map = built(file);
        EXPECT_EQ(map.targets, (std::vector{SectorId(1u), SectorId(3u)}));
    }
}

// hard case W6
TEST(Group, WaitsForABodyInAnyOfItsSectors) {
    MapFile file = hall_group_cellar(3);
    TriggerRecord close = trigger_on(Activation::start, TriggerAction::close, {"near"});
    sector(file, "hall").triggers = {close};
    place_player(file, "far", {9.5, 2}, kEyeOnFloor);
    Game game(file);
    game.hold(kNoKeys, 600);
    EXPECT_EQ(game.room(), "far");
    EXPECT_GE(at(game, 1).ceiling_z, kStandingHeight);
    EXPECT_EQ(at(game, 1).ceiling_z, at(game, 2).ceiling_z);
}

TEST(Group, StopsAtTheHeadsOfSolidThingsInAnyOfItsSectors) {
    MapFile file = hall_group_cellar(3);
    sector(file, "hall").triggers = {trigger_on(Activation::start, TriggerAction::close, {"near"})};
    ThingRecord barrel;
    barrel.position = {9.5, 2};
    barrel.solid = true;
    barrel.height = 1.25;
    file.things = {barrel};
    Game game(file);
    game.hold(kNoKeys, 300);
    EXPECT_EQ(at(game, 1).ceiling_z, 1.25);
}

TEST(Group, GetsItsLightTogether) {
    MapFile file = hall_group_cellar(3);
    TriggerRecord light = trigger_on(Activation::start, TriggerAction::light, {"far"});
    light.light = 0.25;
    sector(file, "hall").triggers = {light};
    const Game game(file);
    Snapshot snapshot = at_rest(game.map);
    show(now(game.map, game.world), snapshot);
    EXPECT_EQ(light_at(snapshot, SectorId(1u)), 0.25);
    EXPECT_EQ(light_at(snapshot, SectorId(2u)), 0.25);
}

TEST(Group, FlickersInStep) {
    MapFile file = hall_group_cellar(3);
    LightEffectRecord fire;
    fire.kind = LightKind::fire;
    for (const char* name : {"near", "far"}) sector(file, name).light_effect = fire;
    const Map map = built(file);
    Snapshot snapshot = at_rest(map);
    for (int tick = 0; tick < 600; ++tick) {
        snapshot.time_s = tick / 60.0;
        EXPECT_EQ(light_at(snapshot, SectorId(1u)), light_at(snapshot, SectorId(2u))) << tick;
    }
}

TEST(Group, IsOneSecret) {
    MapFile file = hall_group_cellar(3);
    for (const char* name : {"near", "far"}) sector(file, name).secret = true;
    Game game(file);
    game.hold(kForward, 120);
    EXPECT_EQ(game.world.secrets, std::vector{SectorId(1u)});
    EXPECT_GT(game.point().x, 9);
}

TEST(Group, ThatIsNotNamedLeavesASectorAlone) {
    const Map map = built(map_of({box_room("a", 0, 0, 4, 4), box_room("b", 8, 0, 12, 4)}));
    for (std::uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(map.sectors[i].leader, SectorId(i));
        EXPECT_EQ(map.sectors[i].next_of_group, SectorId(i));
    }
}

}  // namespace
}  // namespace enfilade
