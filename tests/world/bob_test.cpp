// Floors and ceilings that go up and down by themselves: where they are, whom they carry, and who holds them up.
#include "world/instant.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "world/game.h"
#include "world/player_fault.h"
#include "world/snapshot.h"
#include "world/step.h"

namespace enfilade {
namespace {

using namespace test;

BobRecord bob(double amplitude, double period, double phase = 0, BobShape shape = BobShape::sine) {
    return {amplitude, period, phase, shape};
}

/// A room whose floor bobs under a ceiling at 2.5 m, and a hall beside it that stays as it is. The player stands in the
/// middle of the room.
MapFile bobbing_room(const BobRecord& floor) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4, 0, 2.5), box_room("hall", 4, 0, 12, 4, 0, 2.5)});
    join_all(file);
    sector(file, "room").floor.bob = floor;
    place_player(file, "room", {2, 2}, kEyeOnFloor);
    return file;
}

Heights heights_in(const Game& game, std::uint32_t sector) {
    return heights_of(now(game.map, game.world), SectorId(sector));
}

TEST(Bob, SetsOffUpwardsAndComesBack) {
    for (const BobShape shape : {BobShape::sine, BobShape::triangle}) {
        const BobRecord swell = bob(0.5, 8, 0, shape);
        const double quarters[] = {0, 0.5, 0, -0.5, 0, 0.5};
        for (int i = 0; i < 6; ++i) EXPECT_EQ(offset_at(swell, 2 * i), quarters[i]) << i;
        EXPECT_GT(offset_at(swell, 0.01), 0);
    }
}

TEST(Bob, IsSlowerTowardsItsEndsOrEven) {
    EXPECT_EQ(offset_at(bob(1, 12, 0, BobShape::triangle), 1.5), 0.5);
    EXPECT_NEAR(offset_at(bob(1, 12), 1.5), std::sqrt(0.5), 1e-15);
}

TEST(Bob, IsAheadByItsPhaseAndKnowsThePast) {
    const BobRecord swell = bob(2, 5, 0.3), plain = bob(2, 5);
    for (double time_s = -20; time_s < 20; time_s += 0.37)
        EXPECT_NEAR(offset_at(swell, time_s), offset_at(plain, time_s + 1.5), 1e-8) << time_s;
}

TEST(BobbingFloor, CarriesWhoStandsOnIt) {
    Game game(bobbing_room(bob(0.5, 2)));
    double highest = 0, lowest = 0;
    for (int tick = 0; tick < 300; ++tick) {
        game.hold(kNoKeys);
        ASSERT_EQ(game.player().feet_z, heights_in(game, 0).floor_z) << tick;
        highest = std::max(highest, game.player().feet_z);
        lowest = std::min(lowest, game.player().feet_z);
    }
    EXPECT_EQ(highest, 0.5);
    EXPECT_EQ(lowest, -0.5);
    EXPECT_TRUE(game.world.history.changes().empty());
}

TEST(BobbingFloor, ThatIsLateIsAnotherStateThanOneThatIsNot) {
    const Map map = built(map_of({box_room("room", 0, 0, 8, 8, 0, 4)}));
    std::vector<std::uint64_t> digests;
    for (const std::uint64_t lag : {15, 30}) {
        History history;
        history.add(map, {SectorId(0u), Channel::floor, {60, 0.5, {}, 0, false}, TriggerId(), lag});
        for (const std::uint64_t other : digests) EXPECT_NE(history.digest(), other);
        digests.push_back(history.digest());
    }
}

/// How far the floor and the ceiling of the sector went in the last of many ticks, at most, while the keys were held
/// and nobody was pressed into anything.
double most_moved_in_a_tick(Game& game, std::uint32_t sector, const TickInput& keys, int ticks) {
    double most = 0;
    for (int tick = 0; tick < ticks; ++tick) {
        const Heights before = heights_in(game, sector);
        game.hold(keys);
        const Heights after = heights_in(game, sector);
        most =
            std::max({most, std::fabs(after.floor_z - before.floor_z), std::fabs(after.ceiling_z - before.ceiling_z)});
        EXPECT_TRUE(is_at_most(kStandingHeight, game.player().height)) << tick;
    }
    return most;
}

/// What a sine of this amplitude and period moves in a tick at most.
double steepest(const BobRecord& swell) { return swell.amplitude * 2 * 3.1416 / swell.period * kTickSeconds; }

// hard case C21
TEST(BobbingFloor, WaitsForWhoTouchesTheCeilingAndGoesOnFromThere) {
    const BobRecord swell = bob(1, 4);
    Game game(bobbing_room(swell));
    EXPECT_LE(most_moved_in_a_tick(game, 0, kNoKeys, 600), steepest(swell));
    EXPECT_GT(game.world.history.changes().size(), 10u);
    EXPECT_NEAR(heights_in(game, 0).floor_z, 0.75, steepest(swell));
    double highest = 0;
    for (int tick = 0; tick < 600; ++tick) {  // who leaves lets it go its whole way again
        EXPECT_LE(most_moved_in_a_tick(game, 0, tick < 120 ? kForward : kNoKeys, 1), steepest(swell)) << tick;
        highest = std::max(highest, heights_in(game, 0).floor_z);
    }
    EXPECT_EQ(game.room(), "hall");
    EXPECT_NEAR(highest, 1, 1e-3);
}

TEST(BobbingRoom, WithBothItsFlatsPressesNobody) {
    MapFile file = bobbing_room(bob(0.5, 3));
    sector(file, "room").ceiling.bob = bob(0.75, 2, 0.4, BobShape::triangle);
    Game game(file);
    most_moved_in_a_tick(game, 0, kNoKeys, 1200);
    EXPECT_GT(game.world.history.changes().size(), 10u);
}

// hard case C21
TEST(BobbingRoom, ThatIsClosedSinksNoDeeperThanWhoLiesInItMay) {
    MapFile file = bobbing_room(bob(0.5, 4));
    sector(file, "room").ceiling.z = 0;  // the floor carries it up, and lets it down again
    sector(file, "hall").floor.z = 0.3;
    place_player(file, "room", {3.5, 2}, kEyeOnFloor);
    Game game(file);
    PlayerWatch watch;
    bool has_lain_half_in_the_hall = false;
    for (int tick = 0; tick < 600; ++tick) {
        const bool is_before_the_hall = game.point().x < 4 - kBodyRadius / 2;
        game.hold(is_before_the_hall ? kForward : kNoKeys);
        ASSERT_EQ(watch.fault_of(game.map, game.world), "") << tick;
        has_lain_half_in_the_hall |= game.room() == "room" && game.point().x > 4 - kBodyRadius;
    }
    EXPECT_TRUE(has_lain_half_in_the_hall);
}

/// Four rooms whose floors and ceilings bob, each in its own way; in their middle stands the player.
MapFile sea() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4, 0, 2.5), box_room("b", 4, 0, 8, 4, 0, 2.5),
                           box_room("c", 0, 4, 4, 8, 0.25, 2.75), box_room("d", 4, 4, 8, 8, 0, 3)});
    join_all(file);
    double phase = 0;
    for (SectorRecord& room : file.sectors) {
        room.floor.bob = bob(0.3, 2 + phase, phase);
        room.ceiling.bob = bob(0.6, 1.5 + phase, phase / 2, BobShape::triangle);
        phase += 0.3;
    }
    place_player(file, "a", {3, 3}, kEyeOnFloor);
    return file;
}

TEST(BobbingRooms, PressNobodyWhoWalksAmongThem) {
    Game game(sea());
    Random random(1);
    for (int leg = 0; leg < 300; ++leg) {
        const TickInput keys[] = {kForward, kBack, kLeft, kRight, kNoKeys, kRunForward};
        most_moved_in_a_tick(game, 0, keys[random.below(6)], 20);
        ASSERT_TRUE(game.is_contained()) << leg;
    }
    EXPECT_GT(game.world.history.changes().size(), 50u);
}

TEST(BobbingRooms, HaveAPastThatCanBeHadAgain) {
    const Map map = built(sea());
    Timeline timeline(*start_of(map));
    std::vector<std::uint64_t> hashes{hash(timeline.world())};
    for (int i = 0; i < 600; ++i) {
        timeline.play(map, i < 400 ? kNoKeys : kForward);
        hashes.push_back(hash(timeline.world()));
    }
    EXPECT_GT(timeline.world().history.changes().size(), 3u);
    for (std::size_t tick = 0; tick <= 600; tick += 7) ASSERT_EQ(hash(timeline.after(map, tick)), hashes[tick]) << tick;
}

TEST(BobbingRooms, AreInASnapshotWhereTheWorldHasThem) {
    Game game(sea());
    Snapshot snapshot = at_rest(game.map);
    for (int i = 0; i < 500; ++i) {
        game.hold(kNoKeys);
        const Instant between(game.map, game.world.history, static_cast<double>(game.world.tick) - 0.25);
        show(between, snapshot);
        for (std::uint32_t sector = 0; sector < 4; ++sector) {
            const Heights world = heights_of(between, SectorId(sector)), seen = heights_at(snapshot, SectorId(sector));
            ASSERT_EQ(seen.floor_z, world.floor_z) << i;
            ASSERT_EQ(seen.ceiling_z, world.ceiling_z) << i;
        }
    }
    EXPECT_GT(game.world.history.changes().size(), 3u);
    show({game.map, game.world.history, 0}, snapshot);  // nothing has held them up then
    EXPECT_EQ(heights_at(snapshot, SectorId(1u)).floor_z, offset_at(*game.map.sectors[1].floor_bob, 0));
}

TEST(BobbingRooms, AreNoChangesThatSnapshotsSeeTo) {
    MapFile file = sea();
    place_player(file, "d", {7, 7}, kEyeOnFloor);
    sector(file, "d").floor.bob.reset();
    sector(file, "d").ceiling.bob.reset();
    Game game(file);
    Snapshot snapshot = at_rest(game.map);
    game.hold(kNoKeys, 100);
    show(now(game.map, game.world), snapshot);
    EXPECT_TRUE(snapshot.changed.empty());
}

TEST(BobbingFloor, IsTakenOverByATriggerFromWhereItIs) {
    for (const double after : {0.0, 1.1, 3.4}) {  // at the last time the player will have held it up
        const BobRecord swell = bob(1, 4);
        MapFile file = bobbing_room(swell);
        TriggerRecord sink = trigger_on(Activation::start, TriggerAction::floor);
        sink.z = -2;
        sink.speed = 1.5;
        sink.after = after;
        sector(file, "room").triggers = {sink};
        Game game(file);
        EXPECT_LE(most_moved_in_a_tick(game, 0, kNoKeys, 480), std::max(steepest(swell), 1.5 * kTickSeconds + 1e-9))
            << after;
        EXPECT_EQ(heights_in(game, 0).floor_z, -2) << after;
    }
}

TEST(BobbingFloor, IsStoppedWhereItIs) {
    MapFile file = bobbing_room(bob(0.5, 4));
    TriggerRecord stop = trigger_on(Activation::enter, TriggerAction::stop, {"room"});
    sector(file, "hall").triggers = {stop};
    Game game(file);
    game.hold(kForward, 60);
    ASSERT_EQ(game.room(), "hall");
    const double stopped = heights_in(game, 0).floor_z;
    game.hold(kNoKeys, 100);
    EXPECT_EQ(heights_in(game, 0).floor_z, stopped);
}

/// Two sectors of one group with the same bob, under a ceiling that is low over the second alone, where the player is.
MapFile bobbing_group() {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4, 0, 2.5), box_room("right", 4, 0, 8, 4, 0, 2.5)});
    join_all(file);
    for (SectorRecord& part : file.sectors) {
        part.group = "raft";
        part.floor.bob = bob(1, 4);
    }
    place_player(file, "right", {4.1, 2}, kEyeOnFloor);
    return file;
}

TEST(BobbingGroup, MovesAsOneAndWaitsAsOne) {
    Game game(bobbing_group());
    for (int tick = 0; tick < 400; ++tick) {
        ASSERT_LE(most_moved_in_a_tick(game, 0, kNoKeys, 1), steepest(bob(1, 4))) << tick;
        ASSERT_EQ(heights_in(game, 0).floor_z, heights_in(game, 1).floor_z) << tick;
    }
    EXPECT_GT(game.world.history.changes().size(), 3u);
}

TEST(FloatingThing, MovesItsPictureAndNotItsBody) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 4)});
    file.things.resize(1);
    file.things[0].position = {4, 4};
    file.things[0].bob = bob(0.5, 4);
    place_player(file, "room", {1, 1}, kEyeOnFloor);
    Game game(file);
    game.hold(kNoKeys, 60);
    Snapshot snapshot = at_rest(game.map);
    show(now(game.map, game.world), snapshot);
    EXPECT_EQ(thing_at(game.map, snapshot, ThingId(0u)).z, 0.5);
    EXPECT_EQ(foot_of(now(game.map, game.world), ThingId(0u)), 0);
}

TEST(TurningThing, TurnsRight) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 4)});
    file.things.resize(1);
    file.things[0].position = {4, 4};
    file.things[0].yaw_degrees = 10;
    file.things[0].turn = 45;
    const Map map = built(file);
    Snapshot snapshot = at_rest(map);
    snapshot.time_s = 10;
    EXPECT_EQ(thing_at(map, snapshot, ThingId(0u)).yaw, Angle::from_degrees(10 + 90));
}

}  // namespace
}  // namespace enfilade
