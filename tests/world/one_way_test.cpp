// Bodies in one-way portals: how they get through, stand in the exit, and leave it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "world/body.h"
#include "world/one_way_maps.h"

namespace enfilade {
namespace {

using namespace test;

/// A link and a pair of neighbours, straight and turned.
std::vector<OneWayPair> some_pairs() {
    OneWayPair link, neighbours, turned, wide;
    neighbours.is_link = false;
    turned.near_turn = {16, 63};
    turned.far_turn = {-33, 56};
    turned.rise = 8;
    wide.width = 65.0 / 32;
    wide.far_bend[0] = wide.far_bend[1] = -1;
    return {link, neighbours, turned, wide};
}

/// Calls visit(game, rooms) for a player in each pair, before the portal or wherever `local` is.
template <class Visit>
void in_each_pair(Vec2 local, double yaw_degrees, Visit visit) {
    for (const OneWayPair& pair : some_pairs()) {
        OneWayMap rooms(pair);
        rooms.place(local, yaw_degrees);
        SCOPED_TRACE(testing::Message() << "portal of " << pair.width << " m, turned by " << pair.near_turn.x << ", "
                                        << pair.near_turn.y << (pair.is_link ? ", link" : ", neighbours"));
        Game game(rooms.file());
        ASSERT_NO_FATAL_FAILURE(visit(game, rooms));
    }
}

Vec2 local_of(const Game& game, const OneWayMap& rooms) { return rooms.local(game.map, game.player().place); }

TEST(OneWay, LetsThroughWhoWalksRunsAndCrouches) {
    for (const TickInput& keys : {kForward, kRunForward, kCrouchForward})
        in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
            for (int i = 0; i < 180; ++i) {
                game.hold(keys);
                ASSERT_TRUE(game.is_contained()) << i;
            }
            EXPECT_EQ(game.room(), "far");
            EXPECT_GT(local_of(game, rooms).x, 2);
        });
}

TEST(OneWay, DoesNotSlowWhoPasses) {
    in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
        game.hold(kForward, 20);
        for (int i = 0; i < 40; ++i) {
            const double before = local_of(game, rooms).x;
            game.hold(kForward);
            ASSERT_NEAR(local_of(game, rooms).x - before, 4 * kTickSeconds, 1e-3) << i;
        }
        EXPECT_EQ(game.room(), "far");
    });
}

TEST(OneWay, LetsThroughWhoComesAtASlant) {
    for (const double yaw : {-60.0, -30.0, 15.0, 45.0, 60.0})
        in_each_pair(direction(Angle::from_degrees(yaw)) * -1.5, yaw, [&](Game& game, const OneWayMap&) {
            game.hold(kForward, 240);
            EXPECT_EQ(game.room(), "far") << yaw;
            EXPECT_TRUE(game.is_contained());
        });
}

TEST(OneWay, LetsThroughWhoFalls) {
    for (OneWayPair pair : some_pairs()) {
        pair.drop = 2;
        OneWayMap rooms(pair);
        rooms.place({-2, 0});
        Game game(rooms.file());
        for (int i = 0; i < 180; ++i) {
            game.hold(kRunForward);
            ASSERT_TRUE(game.is_contained()) << i;
        }
        EXPECT_EQ(game.room(), "far");
        EXPECT_EQ(game.player().feet_z, pair.rise - 2);
    }
}

/// Just through the portal: the middle of the body is in the far room and most of its disc still in the exit.
void stand_in_exit(Game& game) {
    for (int i = 0; i < 200 && game.room() == "near"; ++i) game.hold(kForward);
    for (int i = 0; i < 60 && game.player().velocity != Vec2{}; ++i) {
        game.world.player.velocity = {};
        game.hold(kNoKeys);
    }
    ASSERT_EQ(game.room(), "far");
}

TEST(OneWay, LetsOneStandInTheExit) {
    in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
        ASSERT_NO_FATAL_FAILURE(stand_in_exit(game));
        const Vec2 here = game.point();
        ASSERT_LT(local_of(game, rooms).x, kBodyRadius / 2);
        game.hold(kNoKeys, 100);
        EXPECT_EQ(game.point(), here);
    });
}

TEST(OneWay, LetsNobodyBackOffIntoTheExit) {
    for (const TickInput& keys : {kBack, TickInput{.forward = -127, .buttons = kButtonRun}})
        in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
            ASSERT_NO_FATAL_FAILURE(stand_in_exit(game));
            const double depth = local_of(game, rooms).x;
            game.hold(keys, 3000);
            EXPECT_EQ(game.room(), "far");
            EXPECT_GE(local_of(game, rooms).x, depth - 2 * kPointGrid) << "never deeper, however long one pushes";
            game.hold(kForward, 60);
            EXPECT_GT(local_of(game, rooms).x, 1) << "and not held";
        });
}

TEST(OneWay, ExitIsAWallForWhoIsOutOfIt) {
    in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
        game.hold(kForward, 60);
        ASSERT_GT(local_of(game, rooms).x, 0.5);
        game.hold(kBack, 120);
        EXPECT_GE(local_of(game, rooms).x, kBodyRadius - 2 * kPointGrid);
        EXPECT_LT(local_of(game, rooms).x, kBodyRadius + 1e-3);
    });
}

const Wall& exit_of(const Map& map) {
    const auto portal = std::find_if(map.walls.begin(), map.walls.end(),
                                     [](const Wall& wall) { return wall.kind == WallKind::portal; });
    return map[portal->exit];
}

TEST(OneWay, ExitsJambsHoldWhoStrafesInIt) {
    for (const TickInput& keys : {kLeft, kRight})
        in_each_pair({-2, 0}, 0, [&](Game& game, const OneWayMap& rooms) {
            ASSERT_NO_FATAL_FAILURE(stand_in_exit(game));
            game.hold(keys, 60);
            const Vec2 here = local_of(game, rooms);
            EXPECT_EQ(game.room(), "far");
            EXPECT_GT(std::fabs(here.y), 0.1) << "one slides along the exit";
            for (const Vec2 jamb : {exit_of(game.map).a, exit_of(game.map).b})
                EXPECT_FALSE(segment_is_nearer(jamb, jamb, game.point(), kBodyRadius));
            EXPECT_TRUE(game.is_contained());
        });
}

/// Walks straight through the portal, or as near to it as the body gets, and on. Where that leads.
Place walked_through(const Game& game, double radius, double speed) {
    Body body{game.player().place, game.player().feet_z};
    body.radius = snap_to_point_grid(radius);
    Vec2 velocity = direction(game.player().yaw) * speed;
    const int ticks = static_cast<int>(4.5 / (speed * kTickSeconds));
    for (int i = 0; i < ticks; ++i) {
        const Walk walked = walk(game.map, body, velocity, kTickSeconds);
        body.place = walked.end;
        body.feet_z += walked.passage.rise;
        velocity = walked.passage.turn(velocity);
        EXPECT_TRUE(contains(game.map, body.place.sector, body.place.point));
    }
    return body.place;
}

TEST(OneWay, LetsThroughBodiesOfAllSizesAndSpeeds) {
    for (const double radius : {0x1p-10, 0.1, 0.35, 0.5, 1.0})
        for (const double speed : {0.5, 8.0, 60.0})
            in_each_pair({-2, 0}, 0, [&](const Game& game, const OneWayMap& rooms) {
                if (rooms.width() < 2 * radius) return;
                const Place end = walked_through(game, radius, speed);
                EXPECT_EQ(game.map[end.sector].name, "far") << radius << " m, " << speed << " m/s";
                EXPECT_GT(rooms.local(game.map, end).x, 1);
            });
}

TEST(OneWay, IsNotClosedByWhatStandsBehindTheExit) {
    OneWayPair pair;
    pair.pillar = 0.0625;
    pair.behind = 0.0625;
    OneWayMap rooms(pair);
    rooms.place({-2, 0});
    Game game(rooms.file());
    game.hold(kForward, 60);
    EXPECT_EQ(game.room(), "far");
    EXPECT_GT(rooms.local(game.map, game.player().place).x, 1);
}

// hard case T13
TEST(OneWay, HoldsSeveralWaysIntoOneExit) {
    OneWayMap rooms(OneWayPair{});
    rooms.place({-2, 0});
    MapFile file = rooms.file();
    SectorRecord& near = sector(file, "near");
    near.loops.front().vertices.insert(near.loops.front().vertices.begin() + 5, {{-1, 3}, {-1 - 65.0 / 64, 3}});
    auto& walls = near.loops.front().walls;
    const WallRecord solid = walls[4], portal = walls[2];
    walls.insert(walls.begin() + 5, {portal, solid});
    for (const double yaw : {0.0, 90.0}) {
        place_player(file, "near", {yaw == 0 ? -2 : -1 - 65.0 / 128, 0}, kEyeOnFloor, yaw);
        Game game(file);
        game.hold(kForward, 90);
        EXPECT_EQ(game.room(), "far") << yaw;
        EXPECT_GT(rooms.local(game.map, game.player().place).x, 1) << yaw;
    }
}

}  // namespace
}  // namespace enfilade
