// A body among solid things: it stops at them, slides around them, stands on them and goes under them.
#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "math/predicates.h"
#include "world/body.h"
#include "world/game.h"
#include "world/player_fault.h"

namespace enfilade {
namespace {

using namespace test;

constexpr double kThingRadius = 0.5;
constexpr double kApart = kBodyRadius + kThingRadius;

ThingRecord barrel_at(Vec2 position, double height = 1.3) {
    ThingRecord thing;
    thing.position = position;
    thing.radius = kThingRadius;
    thing.height = height;
    thing.solid = true;
    return thing;
}

/// A room of 20 x 10 m; the player at (2, 5) looks along +x.
MapFile hall_with(std::vector<ThingRecord> things, double ceiling_z = 4) {
    MapFile file = map_of({box_room("hall", 0, 0, 20, 10, 0, ceiling_z)});
    file.things = std::move(things);
    place_player(file, "hall", {2, 5}, kEyeOnFloor);
    return file;
}

/// No solid thing of the map is nearer to the player than both radii, where the rooms are not linked. Exact.
bool is_free(const Game& game) {
    for (const Thing& thing : game.map.things)
        if (segment_is_nearer(thing.position, thing.position, game.point(), kBodyRadius + thing.radius)) return false;
    return true;
}

TEST(SolidThing, StopsWhoWalksStraightAtIt) {
    Game game(hall_with({barrel_at({10, 5})}));
    game.hold(kForward, 300);
    EXPECT_EQ(game.point(), (Vec2{10 - kApart, 5}));
    EXPECT_TRUE(is_free(game));
}

// hard case C18
TEST(SolidThing, IsNotMovedIntoByTenThousandTicks) {
    Game game(hall_with({barrel_at({10, 5})}));
    game.hold(kRunForward, 300);
    const Vec2 before = game.point();
    game.hold(kRunForward, 10'000);
    EXPECT_EQ(game.point(), before);
}

TEST(SolidThing, IsWalkedAroundByWhoComesFromABitOff) {
    Game game(hall_with({barrel_at({10, 5.05})}));
    for (int i = 0; i < 600 && game.point().x < 12; ++i) {
        game.hold(kForward);
        ASSERT_TRUE(is_free(game)) << "tick " << i;
    }
    EXPECT_GE(game.point().x, 12);
    EXPECT_LT(game.point().y, 5.05 - kApart + 0.01);
}

TEST(SolidThing, ThatIsNotSolidIsWalkedThrough) {
    ThingRecord plant = barrel_at({10, 5});
    plant.solid = false;
    Game game(hall_with({plant}));
    game.hold(kForward, 300);
    EXPECT_GT(game.point().x, 15);
}

TEST(SolidThing, IsNotFeltThroughAWall) {
    MapFile file = map_of({box_room("hall", 0, 0, 20, 10), box_room("cell", 0, 10, 20, 14)});
    file.things = {barrel_at({10, 10.25})};
    place_player(file, "hall", {2, 10 - kBodyRadius}, kEyeOnFloor);
    Game game(file);
    game.hold(kForward, 400);
    EXPECT_GT(game.point().x, 15);
}

TEST(SolidThing, InTheNextRoomStopsWhoIsStillInThisOne) {
    MapFile file = map_of({box_room("near", 0, 0, 6, 10), box_room("far", 6, 0, 12, 10)});
    join_all(file);
    file.things = {barrel_at({6.5, 5})};
    place_player(file, "near", {2, 5}, kEyeOnFloor);
    Game game(file);
    game.hold(kForward, 200);
    EXPECT_EQ(game.point(), (Vec2{6.5 - kApart, 5}));
    EXPECT_EQ(game.room(), "near");
}

// hard case C19
TEST(SolidThing, BehindALinkStopsWhoIsStillBeforeIt) {
    MapFile file = map_of({box_room("near", 0, 0, 6, 4), box_room("far", 100, 0, 104, 6, 3, 6)});
    link(file, "near", {6, 0}, {6, 4}, "far", {100, 0}, {104, 0});
    sector(file, "near").ceiling.z = 3;
    file.things = {barrel_at({102, 0.5})};
    place_player(file, "near", {2, 2}, kEyeOnFloor);
    Game game(file);
    game.hold(kForward, 200);
    EXPECT_EQ(game.point(), (Vec2{6.5 - kApart, 2}));
}

// hard case C19
TEST(SolidThing, BeforeALinkStopsWhoComesOutOfIt) {
    MapFile file = map_of({box_room("near", 0, 0, 6, 4), box_room("far", 100, 0, 104, 6)});
    link(file, "near", {6, 0}, {6, 4}, "far", {100, 0}, {104, 0});
    file.things = {barrel_at({5.5, 2})};
    place_player(file, "far", {102, 4}, kEyeOnFloor, -90);
    Game game(file);
    game.hold(kForward, 200);
    EXPECT_EQ(game.point(), (Vec2{102, kApart - 0.5}));
}

TEST(SolidThing, ThatHangsHighIsWalkedUnder) {
    ThingRecord lamp = barrel_at({10, 5}, 1);
    lamp.hanging = true;
    Game game(hall_with({lamp}, 4));
    game.hold(kForward, 300);
    EXPECT_GT(game.point().x, 15);
}

TEST(SolidThing, ThatHangsLowIsOnlyPassedCrouching) {
    ThingRecord lamp = barrel_at({10, 5}, 1);
    lamp.hanging = true;
    Game game(hall_with({lamp}, 2.5));
    game.hold(kForward, 200);
    EXPECT_EQ(game.point().x, 10 - kApart);
    game.hold(kCrouchForward, 30);
    EXPECT_GT(game.point().x, 9.5);
    game.hold(kNoKeys, 30);
    EXPECT_LE(game.player().height, 1.5);  // no room to stand up below it
}

TEST(SolidThing, CarriesWhoFallsOntoIt) {
    MapFile file = map_of({box_room("ledge", 0, 0, 5, 10, 2, 6), box_room("yard", 5, 0, 20, 10, 0, 6)});
    join_all(file);
    file.things = {barrel_at({6, 5})};
    place_player(file, "ledge", {3, 5}, 2 + kEyeOnFloor);
    Game game(file);
    while (game.point().x < 6) game.hold(kForward);
    game.hold(kBack, 3);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(game.player().feet_z, 1.3);
    EXPECT_TRUE(game.player().on_ground);
}

TEST(SolidThing, CarriesNobodyAboveACeiling) {
    const Map map = built(hall_with({barrel_at({10, 5}, 1.3)}, 1));
    const Body lying{.place = {SectorId(0u), {10, 5}}, .feet_z = 1.4, .height = 0};
    const Reach found = around(map, lying);
    const Clearance free = clearance(map, lying, found.sectors);
    EXPECT_EQ(free.floor_z, 0);
    EXPECT_EQ(free.ceiling_z, 1);
}

TEST(SolidThing, HangsNotBelowAFloor) {
    ThingRecord lamp = barrel_at({10, 5}, 1.5);
    lamp.hanging = true;
    const Map map = built(hall_with({lamp}, 1));
    const Body sunken{.place = {SectorId(0u), {10, 5}}, .feet_z = -1, .height = 0.4};
    const Reach found = around(map, sunken);
    const Clearance free = clearance(map, sunken, found.sectors);
    EXPECT_EQ(free.floor_z, 0);
    EXPECT_EQ(free.ceiling_z, 1);
}

TEST(SolidThing, IsOverTheEyesOfWhoStepsDownBelowIt) {
    MapFile file = map_of({box_room("step", 0, 0, 5, 10, 0.7, 6), box_room("yard", 5, 0, 20, 10, 0, 6)});
    join_all(file);
    ThingRecord lamp = barrel_at({4.6, 5}, 6 - 1.8);
    lamp.hanging = true;
    file.things = {lamp};
    place_player(file, "step", {4.9, 5}, 0.7 + kEyeOnFloor);  // in it
    Game game(file);
    PlayerWatch watch;
    for (int tick = 0; tick < 60; ++tick) {
        game.hold(kForward);
        ASSERT_EQ(watch.fault_of(game.map, game.world), "") << tick;
    }
}

TEST(SolidThing, LetsWhoStartsInsideOutButNotDeeperIn) {
    for (const auto& keys : {kForward, kBack, kLeft, kRight}) {
        MapFile file = hall_with({barrel_at({2.3, 5})});
        Game game(file);
        double before = 0.3;
        for (int i = 0; i < 200; ++i) {
            game.hold(keys);
            const Vec2 away = game.point() - Vec2{2.3, 5};
            const double distance = std::sqrt(dot(away, away));
            EXPECT_GE(distance, std::fmin(before, kApart) - 4 * kPointGrid);
            before = distance;
        }
        EXPECT_EQ(before > kApart, keys != kForward);
    }
}

TEST(SolidThings, AreNeverWalkedIntoByAnyWalk) {
    Random random(5);
    std::vector<ThingRecord> things;
    for (int x = 4; x < 19; x += 2)
        for (int y = 1; y < 10; y += 2)
            things.push_back(barrel_at({x + random.uniform(-0.4, 0.4), y + random.uniform(-0.4, 0.4)}));
    Game game(hall_with(things));
    double way = 0;
    for (int i = 0; i < 20'000; ++i) {
        TickInput input = kRunForward;
        input.yaw_steps = static_cast<std::int32_t>(random.uniform(-1, 1) * 0x10000000);
        const Vec2 before = game.point();
        game.hold(input);
        ASSERT_TRUE(is_free(game)) << "tick " << i;
        way += std::sqrt(dot(game.point() - before, game.point() - before));
    }
    EXPECT_GT(way, 200);  // it gets about
}

}  // namespace
}  // namespace enfilade
