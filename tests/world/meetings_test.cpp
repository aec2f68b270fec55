// What moves meets: floors and ceilings one another, crushers somebody, ceilings solid things, and lights other lights.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "world/hall_passage_room.h"
#include "world/instant.h"
#include "world/snapshot.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

TEST(Floor, ThatMeetsACeilingOnItsWayCarriesIt) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord rise = trigger_on(Activation::start, TriggerAction::floor, {"passage"});
    TriggerRecord sink = trigger_on(Activation::start, TriggerAction::ceiling, {"passage"});
    rise.z = 2.5;
    sink.z = 0.25;
    sector(file, "hall").triggers = {rise, sink};
    Game game(file);
    double lowest = 3;
    for (int i = 0; i < 200; ++i) {
        game.hold(kNoKeys);
        ASSERT_GE(passage(game).ceiling_z, passage(game).floor_z) << i;
        lowest = std::min(lowest, passage(game).ceiling_z);
    }
    EXPECT_NEAR(lowest, 1.5, 0.05);
    EXPECT_EQ(passage(game).floor_z, 2.5);
    EXPECT_EQ(passage(game).ceiling_z, 2.5);
}

TEST(Crusher, StopsWhereTheFloorHoldsItUp) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord crush = trigger_on(Activation::start, TriggerAction::crush, {"passage"});
    TriggerRecord rise = trigger_on(Activation::start, TriggerAction::floor, {"passage"});
    TriggerRecord stop = trigger_on(Activation::use, TriggerAction::stop);
    rise.z = 1;
    sector(file, "hall").triggers = {crush, rise};
    sector(file, "passage").triggers = {stop};
    Game game(file);
    game.hold(kNoKeys, 80);  // 2.75 m at 2 m/s: almost down
    ASSERT_EQ(passage(game).ceiling_z, 1);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 1);
}

TEST(Crusher, SlowsDownOnABodyUntilItHasBeenDown) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord crush = trigger_on(Activation::enter, TriggerAction::crush);
    crush.crush_speed = 0.25;
    sector(file, "passage").triggers = {crush};
    Game game(file);
    walk_into_passage(game);
    while (passage(game).ceiling_z > 1.5) game.hold(kNoKeys);
    const double before = passage(game).ceiling_z;
    game.hold(kNoKeys, 60);
    EXPECT_NEAR(passage(game).ceiling_z, before - 0.25, 1e-9);
    game.hold(kNoKeys, static_cast<int>((passage(game).ceiling_z - kCrushedHeight) * 240) + 4);
    const double up = passage(game).ceiling_z;
    EXPECT_GT(up, kCrushedHeight);
    game.hold(kNoKeys, 6);
    EXPECT_NEAR(passage(game).ceiling_z, up + 0.2, 1e-9);
}

/// Where the ceiling of the passage comes down to over a solid thing of 1.25 m.
double lowest_over_a_thing(HoldsUp holds_up, TriggerAction action) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "hall").triggers = {trigger_on(Activation::start, action, {"passage"})};
    ThingRecord thing;
    thing.position = {8.5, 2};
    thing.height = 1.25;
    thing.solid = true;
    thing.holds_up = holds_up;
    file.things = {thing};
    Game game(file);
    double lowest = 3;
    for (int i = 0; i < 200; ++i) {
        game.hold(kNoKeys);
        lowest = std::min(lowest, passage(game).ceiling_z);
    }
    return lowest;
}

TEST(Ceiling, StopsShortOfSolidThingsThatHoldItUp) {
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::all, TriggerAction::crush), 1.25);
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::all, TriggerAction::close), 1.25);
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::all_but_crushers, TriggerAction::crush), kCrushedHeight);
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::all_but_crushers, TriggerAction::close), 1.25);
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::nothing, TriggerAction::crush), kCrushedHeight);
    EXPECT_EQ(lowest_over_a_thing(HoldsUp::nothing, TriggerAction::close), 0);
}

/// The light of a room that strobes between 0.75 and 0.25 and that a trigger then sets to 0.5, over ten seconds.
std::set<double> lights_of_a_strobe(bool lasts, bool is_triggers) {
    MapFile file = hall_passage_room(0, 3);
    LightEffectRecord strobe;
    strobe.kind = LightKind::strobe;
    strobe.dark = 0.25;
    strobe.lasts = lasts;
    TriggerRecord flash = trigger_on(Activation::start, TriggerAction::light, {"room"});
    flash.light = 0.75;
    if (is_triggers) flash.effect = strobe;
    TriggerRecord set = trigger_on(Activation::start, TriggerAction::light, {"room"});
    set.light = 0.5;
    sector(file, "hall").triggers = {flash, set};
    sector(file, "room").light = 0.75;
    if (!is_triggers) sector(file, "room").light_effect = strobe;
    const Game game(file);
    Snapshot snapshot = at_rest(game.map);
    show(now(game.map, game.world), snapshot);
    std::set<double> lights;
    for (int tick = 0; tick < 600; ++tick) {
        snapshot.time_s = (tick + 0.5) * kTickSeconds;
        lights.insert(light_at(snapshot, SectorId(2u)));
    }
    return lights;
}

TEST(Light, ThatLastsGoesOnWhateverATriggerSets) {
    for (const bool is_triggers : {false, true}) {
        EXPECT_EQ(lights_of_a_strobe(false, is_triggers), std::set{0.5}) << is_triggers;
        EXPECT_EQ(lights_of_a_strobe(true, is_triggers), (std::set{0.25, 0.75})) << is_triggers;
    }
}

TEST(Floor, GoesToTheLowestCeilingAroundOrToItsOwnIfThatIsLower) {
    for (const double ceiling : {1.5, 6.0}) {  // around: 3
        const MapFile file = hall_passage_room(0, ceiling);
        const Map map = built(file);
        const double around_or_own = height_of(map, SectorId(1u), HeightLevel::lowest_ceiling_or_own, 0);
        EXPECT_EQ(around_or_own, std::min(ceiling, 3.0));
    }
}

}  // namespace
}  // namespace enfilade
