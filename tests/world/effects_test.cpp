// What triggers do: lifts, floors, lights, teleports, keys, and who is in the way of what moves.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "world/hall_passage_room.h"
#include "world/instant.h"
#include "world/snapshot.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

TEST(Trigger, ThatWorksOnceIsNotSetOffAgain) {
    TriggerRecord open = trigger_on(Activation::use, TriggerAction::floor);
    open.once = true;
    open.by = 0.5;
    MapFile file = hall_passage_room(0, 3);
    sector(file, "passage").triggers = {open};
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, 0.5);
}

TEST(Trigger, ThatWorksOnceIsKeptWhileItsTargetIsOnItsWay) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord rise = trigger_on(Activation::start, TriggerAction::floor, {"passage"});
    rise.z = 0.5;
    sector(file, "hall").triggers = {rise};
    TriggerRecord sink = trigger_on(Activation::use, TriggerAction::floor);
    sink.once = true;
    sink.z = -1;
    sector(file, "passage").triggers = {sink};
    Game game(file);
    game.hold(kUse);
    EXPECT_TRUE(game.world.history.firings().empty());
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, 0.5);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, -1);
}

TEST(Trigger, GoesOffWhereOneOfItsTargetsTakesOrders) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord rise = trigger_on(Activation::start, TriggerAction::floor, {"passage"});
    rise.z = 0.5;
    sector(file, "hall").triggers = {rise};
    TriggerRecord sink = trigger_on(Activation::use, TriggerAction::floor, {"passage", "room"});
    sink.once = true;
    sink.z = -1;
    sector(file, "passage").triggers = {sink};
    Game game(file);
    game.hold(kUse);
    EXPECT_EQ(game.world.history.firings().size(), 1u);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, 0.5);
    EXPECT_EQ(heights_of(now(game.map, game.world), SectorId(2u)).floor_z, -1);
}

TEST(Trigger, OnAPortalGoesOffInBothDirections) {
    for (const bool outward : {false, true}) {
        MapFile file = hall_passage_room(0, 3);
        TriggerRecord dark = trigger_on(Activation::cross, TriggerAction::light, {"room"});
        dark.light = 0.25;
        if (outward)
            wall(file, "passage", {8, 4}, {8, 0}).triggers = {dark};
        else
            wall(file, "hall", {8, 0}, {8, 4}).triggers = {dark};
        Game game(file);
        walk_into_passage(game);
        EXPECT_EQ(plain_light_of(now(game.map, game.world), SectorId(2u)), 0.25) << outward;
    }
}

TEST(Trigger, ThatIsOneWayDoesNotGoOffForWhoComesIn) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord dark = trigger_on(Activation::cross, TriggerAction::light, {"room"});
    dark.light = 0.25;
    dark.one_way = true;
    wall(file, "passage", {8, 4}, {8, 0}).triggers = {dark};
    Game game(file);
    walk_into_passage(game);
    EXPECT_EQ(plain_light_of(now(game.map, game.world), SectorId(2u)), 1);
}

// hard case W13
TEST(Trigger, CallsAllSectorsOfATag) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord dark = trigger_on(Activation::enter, TriggerAction::light, {"lamps"});
    dark.light = 0.5;
    sector(file, "passage").triggers = {dark};
    sector(file, "room").tags = sector(file, "hall").tags = {"lamps"};
    Game game(file);
    game.hold(kForward, 60);
    EXPECT_EQ(plain_light_of(now(game.map, game.world), SectorId(0u)), 0.5);
    EXPECT_EQ(plain_light_of(now(game.map, game.world), SectorId(2u)), 0.5);
}

// hard case C21
TEST(Lift, CarriesWhoStandsOnItDownAndUp) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "room").floor.z = sector(file, "passage").floor.z = 2;
    sector(file, "room").ceiling.z = sector(file, "passage").ceiling.z = 5;
    TriggerRecord lift = trigger_on(Activation::use, TriggerAction::lift);
    lift.wait = 2;
    sector(file, "passage").triggers = {lift};
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, 0);
    walk_into_passage(game);
    for (int i = 0; i < 180; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
        ASSERT_EQ(game.player().feet_z, passage(game).floor_z) << i;
    }
    EXPECT_EQ(game.player().feet_z, 2);
    EXPECT_TRUE(game.player().on_ground);
}

// hard case C21
TEST(Lift, TurnsRoundForWhoWouldBeSqueezed) {
    MapFile file = hall_passage_room(2, 3.5);  // up there is room for 1.5 m only
    TriggerRecord lift = trigger_on(Activation::use, TriggerAction::lift);
    lift.wait = 1;
    sector(file, "passage").triggers = {lift};
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    walk_into_passage(game);
    double highest = 0;
    for (int i = 0; i < 1500; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
        highest = std::max(highest, passage(game).floor_z);
    }
    EXPECT_GT(highest, 3.5 - kStandingHeight - 0.1);
    EXPECT_LT(highest, 3.5 - kStandingHeight + 0.01);
}

TEST(Floor, WaitsForWhoWouldBeSqueezedAndThenGoesOn) {
    MapFile file = hall_passage_room(0, 3);
    TriggerRecord rise = trigger_on(Activation::enter, TriggerAction::floor);
    rise.z = 2.5;
    sector(file, "passage").triggers = {rise};
    Game game(file);
    walk_into_passage(game);
    for (int i = 0; i < 600; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
    }
    EXPECT_NEAR(passage(game).floor_z, 3 - kStandingHeight, 0.05);
    game.hold(kBack, 120);  // down into the hall
    ASSERT_EQ(game.room(), "hall");
    game.hold(kNoKeys, 120);
    EXPECT_EQ(passage(game).floor_z, 2.5);
}

TEST(Crusher, HurtsWhoIsBelowButLeavesRoom) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "passage").triggers = {trigger_on(Activation::enter, TriggerAction::crush)};
    Game game(file);
    walk_into_passage(game);
    for (int i = 0; i < 200; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
    }
    EXPECT_LT(game.world.health, kFullHealth);
}

TEST(Teleport, StandsThePlayerWhereTheThingIs) {
    MapFile file = hall_passage_room(0, 3);
    ThingRecord there;
    there.name = "there";
    there.position = {2, 3};
    there.yaw_degrees = 90;
    file.things = {there};
    wall(file, "hall", {8, 0}, {8, 4}).triggers = {trigger_on(Activation::cross, TriggerAction::teleport, {"there"})};
    Game game(file);
    for (int i = 0; i < 60 && game.point().x > 5; ++i) game.hold(kForward);
    EXPECT_EQ(game.point(), (Vec2{2, 3}));
    EXPECT_EQ(game.player().yaw, Angle::from_degrees(90));
    EXPECT_EQ(game.player().velocity, (Vec2{}));
}

/// A disc on the floor that teleports whoever touches it to another thing.
ThingRecord disc(std::string name, Vec2 position, std::string to) {
    ThingRecord thing;
    thing.name = std::move(name);
    thing.position = position;
    thing.triggers = {trigger_on(Activation::touch, TriggerAction::teleport, {std::move(to)})};
    return thing;
}

TEST(Teleport, BetweenTwoDiscsThrowsOncePerTouch) {
    MapFile file = map_of({box_room("hall", 0, 0, 12, 4)});
    file.things = {disc("west", {4, 2}, "east"), disc("east", {8, 2}, "west")};
    place_player(file, "hall", {2, 2}, kEyeOnFloor);
    Game game(file);
    while (game.point().x < 5) game.hold(kForward);
    EXPECT_EQ(game.point(), (Vec2{8, 2}));
    game.hold(kNoKeys, 120);
    EXPECT_EQ(game.point(), (Vec2{8, 2})) << "what one arrives in counts as touched";
    game.hold(kForward, 60);
    EXPECT_GT(game.point().x, 9) << "one walks out of it";
    while (game.point().x > 5) game.hold(kBack);
    EXPECT_EQ(game.point(), (Vec2{4, 2})) << "and who comes back is thrown again";
}

TEST(Exit, IsNoted) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "room").triggers = {trigger_on(Activation::enter, TriggerAction::leave_map, {"next.toml"})};
    Game game(file);
    EXPECT_FALSE(game.world.left_by.has_value());
    game.hold(kForward, 90);
    ASSERT_TRUE(game.world.left_by.has_value());
    EXPECT_EQ(game.map[*game.world.left_by].leads_to, "next.toml");
}

TEST(Floor, ThatHurtsCostsHealthEachSecond) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "hall").damage = 7;
    Game game(file);
    game.hold(kNoKeys, 180);
    EXPECT_EQ(game.world.health, kFullHealth - 3 * 7);
}

TEST(Floor, ThatCarriesTakesAlongWhoStandsOnIt) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "hall").floor.scroll = {-1, 0.5};
    sector(file, "hall").floor.carries = true;
    Game game(file);
    const Vec2 before = game.point();
    game.hold(kNoKeys, 60);
    EXPECT_NEAR(game.point().x, before.x - 1, 1e-7);
    EXPECT_NEAR(game.point().y, before.y + 0.5, 1e-7);
}

TEST(Secret, IsToldOnce) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "passage").secret = true;
    Game game(file);
    game.hold(kForward, 35);
    EXPECT_EQ(game.world.secrets, (std::vector{SectorId(1u)}));
    ASSERT_TRUE(game.world.message.has_value());
    EXPECT_EQ(game.world.message->kind, PlayerMessageKind::secret);
}

TEST(Stairs, RiseOneStepMoreEach) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "hall").triggers = {trigger_on(Activation::start, TriggerAction::stairs, {"passage", "room"})};
    Game game(file);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).floor_z, 0.25);
    EXPECT_EQ(heights_of(now(game.map, game.world), SectorId(2u)).floor_z, 0.5);
}

// hard case C21
TEST(Shuttle, WaitsWhereItTurnsForWhoHasNoRoomAboveIt) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "passage").ceiling.z = kStandingHeight;
    sector(file, "room").floor.z = 0.5;
    TriggerRecord shuttle = trigger_on(Activation::enter, TriggerAction::shuttle);
    shuttle.wait = 0;
    sector(file, "passage").triggers = {shuttle};
    Game game(file);
    walk_into_passage(game);
    for (int i = 0; i < 300; ++i) {
        game.hold(kNoKeys);
        ASSERT_EQ(passage(game).floor_z, 0) << i;
    }
    game.hold(kBack, 60);
    double highest = 0;
    for (int i = 0; i < 300; ++i) {
        game.hold(kNoKeys);
        highest = std::max(highest, passage(game).floor_z);
    }
    EXPECT_EQ(highest, 0.5);
}

TEST(Shuttle, StopsWhereItIsAndGoesOn) {
    MapFile file = hall_passage_room(1, 5);
    sector(file, "room").floor.z = 2;
    sector(file, "room").ceiling.z = 5;
    sector(file, "hall").triggers = {trigger_on(Activation::start, TriggerAction::shuttle, {"passage"})};
    TriggerRecord stop = trigger_on(Activation::use, TriggerAction::stop);
    sector(file, "passage").triggers = {stop};
    Game game(file);
    game.hold(kNoKeys, 20);
    game.hold(kUse);
    const double stopped = passage(game).floor_z;
    game.hold(kNoKeys, 100);
    EXPECT_EQ(passage(game).floor_z, stopped);
    EXPECT_LT(stopped, 1);
}

/// What has happened by a tick, and what it makes of the map, asked at once and asked at its time.
TEST(History, SaysOfThePastWhatWasTrueThen) {
    MapFile file = with_door(trigger_on(Activation::use, TriggerAction::door));
    sector(file, "room").triggers = {trigger_on(Activation::start, TriggerAction::shuttle)};
    sector(file, "room").floor.z = 0.5;
    Game game(file);
    std::vector<std::pair<Heights, Heights>> seen;
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        seen.push_back({passage(game), heights_of(now(game.map, game.world), SectorId(2u))});
        game.hold(random.below(40) == 0 ? kUse : kNoKeys);
    }
    for (std::size_t tick = 0; tick < seen.size(); ++tick) {
        const Instant then(game.map, game.world.history, static_cast<double>(tick));
        ASSERT_EQ(heights_of(then, SectorId(1u)).ceiling_z, seen[tick].first.ceiling_z) << tick;
        ASSERT_EQ(heights_of(then, SectorId(2u)).floor_z, seen[tick].second.floor_z) << tick;
    }
    EXPECT_GT(game.world.history.changes().size(), 5u);
}

TEST(World, CopiedAtAnyMomentGoesOnTheSame) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kForward, 50);
    World copy = game.world;
    game.hold(kForward, 200);
    for (int i = 0; i < 200; ++i) step(game.map, copy, kForward);
    EXPECT_EQ(hash(copy), hash(game.world)) << difference(copy, game.world);
}

TEST(Switch, ShowsItsOtherFaceForASecond) {
    MapFile file = with_door(trigger_on(Activation::use, TriggerAction::door));
    Game game(file);
    Snapshot snapshot = at_rest(game.map);
    game.hold(kUse);
    show(now(game.map, game.world), snapshot);
    EXPECT_EQ(snapshot.pressed.size(), 1u);
    game.hold(kNoKeys, 61);
    show(now(game.map, game.world), snapshot);
    EXPECT_TRUE(snapshot.pressed.empty());
}

}  // namespace
}  // namespace enfilade
