// Doors: who opens them, when they close, and what they do where somebody is in their way.
#include <gtest/gtest.h>

#include "world/hall_passage_room.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

TEST(Door, StaysClosedForWhoOnlyWalksAtIt) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kForward, 200);
    EXPECT_EQ(game.room(), "hall");
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

TEST(Door, OpensAHandBelowTheLowestCeilingAround) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kNoKeys, 120);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
}

TEST(Door, ClosesAgainAfterItsWait) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    const int up = 87, wait = 240;  // 2.875 m at 2 m/s, then 4 s
    game.hold(kNoKeys, up + wait - 1);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
    game.hold(kNoKeys, up + 1);
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

TEST(Door, IsUsedOnceForEachPressOfTheKey) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse, 30);
    EXPECT_GT(passage(game).ceiling_z, 0.9);
}

TEST(Door, UsedAgainWhileItOpensCloses) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kNoKeys, 30);
    game.hold(kUse);
    game.hold(kNoKeys, 40);
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

TEST(Door, UsedAgainWhileItClosesOpens) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kNoKeys, 87 + 240 + 30);
    const double before = passage(game).ceiling_z;
    game.hold(kUse);
    game.hold(kNoKeys, 10);
    EXPECT_GT(passage(game).ceiling_z, before);
}

/// A door that the start sets off by another action, and that one may use.
Game door_moved_by(TriggerAction action, double height) {
    MapFile file = hall_passage_room(0, height);
    sector(file, "passage").triggers = {trigger_on(Activation::use, TriggerAction::door),
                                        trigger_on(Activation::start, action)};
    return Game(file);
}

/// Uses the door, and says whether it is higher or lower after some ticks: 1 or -1.
int direction_after_use(Game& game) {
    const double before = passage(game).ceiling_z;
    game.hold(kUse);
    game.hold(kNoKeys, 10);
    const double after = passage(game).ceiling_z;
    return after > before ? 1 : after < before ? -1 : 0;
}

TEST(Door, UsedWhileSomethingElseMovesItTurnsRound) {
    Game opening = door_moved_by(TriggerAction::open, 0), closing = door_moved_by(TriggerAction::close, 2.5),
         closing_for_now = door_moved_by(TriggerAction::close_then_open, 2.5);
    for (Game* game : {&opening, &closing, &closing_for_now}) game->hold(kNoKeys, 30);
    EXPECT_EQ(direction_after_use(opening), -1);
    EXPECT_EQ(direction_after_use(closing), 1);
    EXPECT_EQ(direction_after_use(closing_for_now), 1);
    for (Game* game : {&opening, &closing, &closing_for_now}) game->hold(kNoKeys, 1000);
    EXPECT_EQ(passage(opening).ceiling_z, 0);
    EXPECT_EQ(passage(closing).ceiling_z, 3 - kDoorHead) << "it stays open: nothing was to close it again";
    EXPECT_EQ(passage(closing_for_now).ceiling_z, 2.5);
}

TEST(Door, UsedAgainAndAgainTurnsRoundEachTime) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kNoKeys, 40);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(direction_after_use(game), i % 2 == 0 ? -1 : 1) << i;
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
    game.hold(kNoKeys, 240 + 90);
    EXPECT_EQ(passage(game).ceiling_z, 0) << "and it closes after its wait, as ever";
}

TEST(Door, ThatDoesNotReverseIgnoresWhoUsesItAgain) {
    TriggerRecord door = trigger_on(Activation::use, TriggerAction::door);
    door.reverses = false;
    Game game(with_door(door));
    game.hold(kUse);
    game.hold(kNoKeys, 30);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
}

TEST(Door, OutOfReachIsNotUsed) {
    MapFile file = with_door(trigger_on(Activation::use, TriggerAction::door));
    place_player(file, "hall", {8 - kArm - 0.25, 2}, kEyeOnFloor);
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

TEST(Door, BehindTheBackIsNotUsed) {
    MapFile file = with_door(trigger_on(Activation::use, TriggerAction::door));
    file.player->yaw_degrees = 180;
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

// hard case C21
TEST(Door, OpensForWhoStandsInItWhenItCloses) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)));
    game.hold(kUse);
    game.hold(kNoKeys, 87);
    walk_into_passage(game);
    double lowest = 3;
    for (int i = 0; i < 2000; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
        lowest = std::min(lowest, passage(game).ceiling_z);
    }
    EXPECT_GE(lowest, kStandingHeight - 0x1p-10);
    EXPECT_LT(lowest, kStandingHeight + 0.1);
}

// hard case C21
TEST(Door, ThatOpensDownwardsWaitsForWhoStandsInIt) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "room").ceiling.z = 1;  // a hand below this it is open
    sector(file, "passage").triggers = {trigger_on(Activation::enter, TriggerAction::door)};
    Game game(file);
    walk_into_passage(game);
    double lowest = 3;
    for (int i = 0; i < 600; ++i) {
        game.hold(kNoKeys);
        ASSERT_TRUE(is_in_the_open(game)) << i;
        lowest = std::min(lowest, passage(game).ceiling_z);
    }
    EXPECT_GE(lowest, kStandingHeight - 0x1p-10);
    EXPECT_LT(lowest, kStandingHeight + 0.1);
}

// hard case C21
TEST(Door, ThatOpensDownwardsGoesOnWhereItWaitedForSomebody) {
    MapFile file = hall_passage_room(0, 3);
    sector(file, "room").ceiling.z = 1;
    sector(file, "passage").triggers = {trigger_on(Activation::enter, TriggerAction::door)};
    Game game(file);
    walk_into_passage(game);
    game.hold(kNoKeys, 200);
    game.hold(kBack, 120);
    EXPECT_EQ(passage(game).ceiling_z, 1 - kDoorHead) << "open";
    game.hold(kNoKeys, 400);
    EXPECT_EQ(passage(game).ceiling_z, 0) << "and closed again";
}

TEST(Door, WithAKeyOpensOnlyForWhoHasIt) {
    TriggerRecord door = trigger_on(Activation::use, TriggerAction::door);
    door.key = "red";
    MapFile file = with_door(door);
    ThingRecord key;
    key.position = {3, 2};
    key.gives_key = "red";
    file.things = {key};
    Game game(file);
    game.hold(kUse);
    game.hold(kNoKeys, 30);
    EXPECT_EQ(passage(game).ceiling_z, 0);
    ASSERT_TRUE(game.world.message.has_value());
    EXPECT_EQ(game.world.message->kind, PlayerMessageKind::needs_key);
    game.hold(kBack, 60);
    EXPECT_EQ(game.world.keys, 1u);
    game.hold(kForward, 60);
    game.hold(kUse);
    game.hold(kNoKeys, 30);
    EXPECT_GT(passage(game).ceiling_z, 0);
}

}  // namespace
}  // namespace enfilade
