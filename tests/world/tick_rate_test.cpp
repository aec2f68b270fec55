// A second is a second, however many ticks it has.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "world/game.h"
#include "world/hall_passage_room.h"
#include "world/replay.h"
#include "world/snapshot.h"
#include "world/step.h"
#include "world/trigger_actions.h"
#include "world/voices.h"

namespace enfilade {
namespace {

using namespace test;

constexpr double kGravity = 16;  // world/step.cpp [m/s^2]

class AtRate : public ::testing::TestWithParam<TickRate> {
protected:
    double second() const { return ticks_per_second(GetParam()); }  ///< [ticks]
    /// Holds keys for as many ticks as end within the seconds.
    void hold(Game& game, const TickInput& keys, double seconds) const {
        game.hold(keys, static_cast<int>(seconds * second()));
    }
};

MapFile long_hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 64, 4, 0, 3)});
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    return file;
}

MapFile ledge_and_yard() {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 3, 8), box_room("yard", 4, 0, 12, 4, 0, 8)});
    join_all(file);
    place_player(file, "ledge", {2, 2}, 3 + kEyeOnFloor, 0);
    return file;
}

TEST_P(AtRate, TheWorldKnowsIt) {
    const Game game(long_hall(), GetParam());
    EXPECT_EQ(game.world.history.rate(), GetParam());
    EXPECT_EQ(rate_of_ticks(ticks_per_second(GetParam())), GetParam());
}

TEST_P(AtRate, SpeedDiesAwayBySecondsAndNotByTicks) {
    Game game(long_hall(), GetParam());
    for (int tick = 1; tick <= 200; ++tick) {
        game.hold(kForward);
        ASSERT_NEAR(game.player().velocity.x, kWalkSpeed * (1 - std::pow(0.8, 60 * tick / second())), 1e-12);
    }
}

TEST_P(AtRate, OneWalksAsFar) {
    Game game(long_hall(), GetParam());
    hold(game, kForward, 4);
    EXPECT_NEAR(game.point().x - 2, kWalkSpeed * (4 - 0.0833), kWalkSpeed / 35);  // less what getting going takes
}

TEST_P(AtRate, OneFallsAsLong) {
    Game game(ledge_and_yard(), GetParam());
    int in_air = 0;
    for (int tick = 0; tick < 3 * second(); ++tick) {
        game.hold(kForward);
        in_air += !game.player().on_ground;
    }
    EXPECT_EQ(game.player().feet_z, 0);
    EXPECT_NEAR(in_air / second(), std::sqrt(2 * 3 / kGravity), 2 / second());
}

TEST_P(AtRate, OneCrouchesAsFast) {
    Game game(long_hall(), GetParam());
    hold(game, kCrouch, 0.1);
    const double down = std::floor(0.1 * second()) / second() * 5;
    EXPECT_NEAR(game.player().height, kStandingHeight - down, 1e-12);
}

TEST_P(AtRate, TheEyeFollowsAStepAsFast) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 4), box_room("step", 4, 0, 64, 4, 0.5, 4)});
    join_all(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    Game game(file, GetParam());
    while (game.player().eye_lag == 0) game.hold(kForward);
    const double lag = game.player().eye_lag;
    game.hold(kForward, 3);
    EXPECT_NEAR(game.player().eye_lag, lag * std::pow(0.82, 3 * 60 / second()), 1e-12);
}

TEST_P(AtRate, DoorsTakeAsLongAndWaitAsLong) {
    Game game(with_door(trigger_on(Activation::use, TriggerAction::door)), GetParam());
    game.hold(kUse);
    const double opens = 2.875 / 2, wait = 4;  // [s]: 2.875 m at 2 m/s
    hold(game, kNoKeys, opens / 2);
    EXPECT_NEAR(passage(game).ceiling_z, 2.875 / 2, 3 * 2 / second());
    hold(game, kNoKeys, opens / 2 + wait - 0.2);
    EXPECT_EQ(passage(game).ceiling_z, 3 - kDoorHead);
    hold(game, kNoKeys, opens + 0.3);
    EXPECT_EQ(passage(game).ceiling_z, 0);
}

TEST_P(AtRate, AFloorHurtsOnceASecond) {
    MapFile file = long_hall();
    sector(file, "hall").damage = 7;
    Game game(file, GetParam());
    hold(game, kNoKeys, 5);
    EXPECT_EQ(game.world.health, kFullHealth - 5 * 7);
}

TEST_P(AtRate, ACrusherHurtsAsOften) {
    MapFile file = long_hall();
    sector(file, "hall").triggers = {trigger_on(Activation::start, TriggerAction::crush)};
    Game game(file, GetParam());
    std::vector<int> hurt_at;  // [ticks]
    for (int tick = 0, health = kFullHealth; tick < 5 * second() && game.world.health > 0; ++tick) {
        game.hold(kNoKeys);
        if (game.world.health < health) hurt_at.push_back(tick);
        health = game.world.health;
    }
    ASSERT_GE(hurt_at.size(), 3u);
    EXPECT_NEAR((hurt_at[2] - hurt_at[0]) / second(), 2 * 4 / 35.0, 1 / second());  // Doom's, to half a tick each
}

TEST_P(AtRate, ASnapshotIsOfAsManySeconds) {
    Game game(long_hall(), GetParam());
    hold(game, kNoKeys, 2);
    Snapshot snapshot = at_rest(game.map);
    show(now(game.map, game.world), snapshot);
    EXPECT_DOUBLE_EQ(snapshot.time_s, 2);
}

TEST_P(AtRate, ASwitchShowsItsOtherFaceForASecond) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4)});
    wall(file, "hall", {8, 0}, {8, 4}).triggers = {trigger_on(Activation::use, TriggerAction::door, {"hall"})};
    place_player(file, "hall", {7, 2}, kEyeOnFloor);
    Game game(file, GetParam());
    Snapshot snapshot = at_rest(game.map);
    int pressed = 0;
    for (int tick = 0; tick < 3 * second(); ++tick) {
        game.hold(tick == 0 ? kUse : kNoKeys);
        show(now(game.map, game.world), snapshot);
        pressed += !snapshot.pressed.empty();
    }
    EXPECT_NEAR(pressed, kSwitchSeconds * second(), 1);
}

TEST_P(AtRate, AFloorThatBobsTakesAsLong) {
    MapFile file = long_hall();
    sector(file, "hall").floor.bob = BobRecord{0.5, 4, 0, BobShape::triangle};
    Game game(file, GetParam());
    hold(game, kNoKeys, 1);
    EXPECT_NEAR(heights_of(now(game.map, game.world), SectorId(0u)).floor_z, 0.5, 0.5 / second());
    hold(game, kNoKeys, 2);
    EXPECT_NEAR(heights_of(now(game.map, game.world), SectorId(0u)).floor_z, -0.5, 0.5 / second());
}

TEST_P(AtRate, ASoundEndsWithItsLength) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4)});
    file.sounds = {{"click", "click.wav", 1, 20, false, {}}};
    TriggerRecord click = trigger_on(Activation::use, TriggerAction::sound);
    click.sound = "click";
    wall(file, "hall", {8, 0}, {8, 4}).triggers = {click};
    place_player(file, "hall", {7, 2}, kEyeOnFloor);
    Game game(file, GetParam());
    Hearing hearing(game.map);
    const std::array lengths_s{0.5};
    int heard = 0;
    for (int tick = 0; tick < 2 * second(); ++tick) {
        game.hold(tick == 0 ? kUse : kNoKeys);
        const Listener listener{game.player().place, game.player().yaw};
        heard += !voices_at(now(game.map, game.world), hearing, listener, lengths_s).empty();
    }
    EXPECT_NEAR(heard, lengths_s[0] * second(), 1);
}

TEST_P(AtRate, WhatWasIsHadAgainFromATape) {
    const Map map = built(ledge_and_yard());
    const std::vector<TickInput> inputs(100, kForward);
    const std::uint64_t end = play(map, inputs, GetParam())->hashes.back();
    EXPECT_TRUE(replay(map, {"", 0, ticks_per_second(GetParam()), false, inputs, end}).ok());
    Timeline timeline(*start_of(map, GetParam()));
    for (const TickInput& input : inputs) timeline.play(map, input);
    EXPECT_EQ(hash(timeline.after(map, 100)), end);
}

INSTANTIATE_TEST_SUITE_P(Rates, AtRate, ::testing::Values(TickRate::hz60, TickRate::hz35, TickRate::hz140),
                         [](const auto& rate) { return std::to_string(ticks_per_second(rate.param)); });

TEST(TickRates, WorldsOfDifferentRatesAreDifferent) {
    const Map map = built(long_hall());
    EXPECT_NE(hash(*start_of(map)), hash(*start_of(map, TickRate::hz35)));
    EXPECT_NE(hash(*start_of(map, TickRate::hz35)), hash(*start_of(map, TickRate::hz140)));
}

TEST(TickRates, NoWorldHasAnother) { EXPECT_FALSE(rate_of_ticks(61).has_value()); }

}  // namespace
}  // namespace enfilade
