// The eye between two ticks, on plain floors and through portals and links.
#include "world/world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;

/// Two rooms far apart whose doorway turns by a quarter and rises by 5 m.
MapFile turning_rooms() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4, 0, 3), box_room("b", 100, 50, 104, 54, 5, 8)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    place_player(file, "a", {3, 2}, kEyeOnFloor, 0);
    return file;
}

MapFile plain_rooms() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4, 0, 3), box_room("b", 4, 0, 8, 4, 0, 3)});
    join_all(file);
    place_player(file, "a", {3, 2}, kEyeOnFloor, 0);
    return file;
}

TEST(EyeBetweenTicks, IsThePlayersAtTheEndOfTheTick) {
    Game game(plain_rooms());
    game.hold({.forward = 127, .yaw_steps = 12345, .pitch_steps = 777}, 5);
    const Eye eye = eye_between_ticks(game.map, game.world, 1);
    EXPECT_EQ(eye.place, game.player().place);
    EXPECT_EQ(eye.z, game.player().eye_z);
    EXPECT_EQ(eye.yaw, game.player().yaw);
    EXPECT_EQ(eye.pitch_steps, game.player().pitch_steps);
}

TEST(EyeBetweenTicks, IsWhereItWasAtTheBeginningOfTheTick) {
    Game game(turning_rooms());
    game.hold(kForward, 30);
    const Eye eye = eye_between_ticks(game.map, game.world, 0);
    EXPECT_EQ(eye.place, game.world.before.place);
    EXPECT_EQ(eye.yaw, game.world.before.yaw);
}

TEST(EyeBetweenTicks, IsHalfWayInTheMiddle) {
    Game game(plain_rooms());
    game.hold({.forward = 127, .yaw_steps = 1 << 20}, 3);
    const Eye eye = eye_between_ticks(game.map, game.world, 0.5);
    EXPECT_NEAR(eye.place.point.x, (game.world.before.place.point.x + game.point().x) / 2, kPointGrid);
    EXPECT_EQ(eye.yaw, game.world.before.yaw + Angle{1 << 19});
}

TEST(EyeBetweenTicks, TurnsOverTheShorterArc) {
    Game game(plain_rooms());
    game.world.player.yaw = Angle{0u - 100u};
    game.hold({.yaw_steps = 200});
    EXPECT_EQ(eye_between_ticks(game.map, game.world, 0.5).yaw, Angle{0});
}

TEST(EyeBetweenTicks, GoesThroughALinkLikeThroughAPlainDoorway) {
    Game linked(turning_rooms()), plain(plain_rooms());
    int in_between = 0;
    for (int i = 0; i < 60; ++i) {
        linked.hold(kForward);
        plain.hold(kForward);
        for (const double part : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
            const Eye eye = eye_between_ticks(linked.map, linked.world, part);
            const Eye expected = eye_between_ticks(plain.map, plain.world, part);
            const bool far = expected.place.sector.index == 1;
            ASSERT_TRUE(contains(linked.map, eye.place.sector, eye.place.point));
            ASSERT_EQ(eye.place.sector, expected.place.sector) << "tick " << i << ", part " << part;
            // What was y - 2 to the side is x - 102, what was x - 4 beyond the door is y - 50.
            const Vec2 p = expected.place.point;
            ASSERT_EQ(eye.place.point, far ? (Vec2{102 - (p.y - 2), 50 + (p.x - 4)}) : p);
            ASSERT_EQ(eye.yaw, Angle::from_degrees(far ? 90 : 0));
            ASSERT_NEAR(eye.z, far ? expected.z + 5 : expected.z, 1e-12);
            in_between += part < 1 && eye.place.sector != linked.player().place.sector;
        }
    }
    EXPECT_GT(in_between, 0) << "the eye was seen on the other side of the link during the tick that crosses it";
}

TEST(EyeBetweenTicks, StaysBelowTheCeilingInEveryRoom) {
    MapFile file = map_of({box_room("high", 0, 0, 4, 4, 0, 4), box_room("low", 4, 0, 8, 4, -0.75, 1.1)});
    join_all(file);
    place_player(file, "high", {2, 2}, kEyeOnFloor, 0);
    Game game(file);
    for (int i = 0; i < 90; ++i) {
        game.hold(kRunForward);
        for (double part = 0; part <= 1; part += 0.125) {
            const Eye eye = eye_between_ticks(game.map, game.world, part);
            ASSERT_LE(eye.z, game.map[eye.place.sector].ceiling.z);
        }
    }
}

}  // namespace
}  // namespace enfilade
