// A body against walls: contact, sliding, corners, gaps, and rooms joined by links.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/hash.h"
#include "math/predicates.h"
#include "space/trace.h"
#include "support/generate_map.h"
#include "world/body.h"
#include "world/door_and_link.h"
#include "world/game.h"
#include "world/player_fault.h"

namespace enfilade {
namespace {

using namespace test;

MapFile box_with_player(double x, double y, double yaw) {
    MapFile file = map_of({box_room("box", 0, 0, 10, 10)});
    place_player(file, "box", {x, y}, kEyeOnFloor, yaw);
    return file;
}

/// No wall of the player's sector is nearer than the body's radius, exactly.
bool touches_nothing(const Game& game) {
    const Sector& sector = game.map[game.player().place.sector];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = game.map.walls[i];
        if (wall.kind == WallKind::solid && segment_is_nearer(wall.a, wall.b, game.point(), kBodyRadius)) return false;
    }
    return true;
}

TEST(Walk, StopsABodysRadiusFromAWall) {
    Game game(box_with_player(5, 5, 0));
    game.hold(kForward, 200);
    EXPECT_EQ(game.point().x, 10 - kBodyRadius);
    EXPECT_EQ(game.point().y, 5);
}

// hard case C18
TEST(Walk, IsNotMovedByTenThousandTicksAgainstAWall) {
    Game game(box_with_player(5, 5, 0));
    game.hold(kRunForward, 200);
    const Vec2 before = game.point();
    game.hold(kRunForward, 10000);
    EXPECT_EQ(game.point(), before);
}

// hard case C18
TEST(Walk, IsNotMovedByTenThousandTicksAgainstASlantedWall) {
    MapFile file = map_of({room("slanted", {{0, 0}, {10, 0}, {7, 9}, {0, 10}})});
    place_player(file, "slanted", {4, 4}, kEyeOnFloor);
    Game game(file);
    // Straight at the wall from (10, 0) to (7, 9), whose inward normal is (-3, -1): 18.43 degrees.
    game.world.player.yaw = angle_of({3, 1});
    game.hold(kForward, 400);
    const Vec2 before = game.point();
    game.hold(kForward, 10000);
    // The yaw is off the normal by up to half a step of the angle, which leaves that share of the pace to slide by.
    EXPECT_LE(
        std::fabs(exact_cross({10, 0}, {7, 9}, game.point()) - exact_cross({10, 0}, {7, 9}, before)) / std::sqrt(90.0),
        2 * kPointGrid);
    EXPECT_TRUE(touches_nothing(game));
}

TEST(Walk, SlidesAlongAWallAtTheSpeedThatIsLeft) {
    Game game(box_with_player(5, 9, 60));
    game.hold(kForward, 30);
    const double x = game.point().x;
    EXPECT_EQ(game.point().y, 10 - kBodyRadius);
    game.hold(kForward, 30);
    EXPECT_EQ(game.point().y, 10 - kBodyRadius) << "not a grid step off while sliding";
    EXPECT_NEAR(game.point().x - x, kWalkSpeed / 2 * 30 * kTickSeconds, 1e-3);
}

// hard case C17
TEST(Walk, SlidesAlongSixtyFourPiecesAsAlongOne) {
    Game whole(box_with_player(1, 9, 45));
    MapFile file = box_with_player(1, 9, 45);
    std::vector<Vec2> outline{{0, 0}, {10, 0}, {10, 10}};
    for (int i = 1; i < 64; ++i) outline.push_back({10 - snap_to_vertex_grid(i * 10.0 / 64), 10});
    outline.push_back({0, 10});
    file.sectors[0] = room("box", outline);
    Game pieces(file);
    for (int i = 0; i < 250; ++i) {
        whole.hold(kForward);
        pieces.hold(kForward);
        ASSERT_EQ(pieces.point(), whole.point()) << "tick " << i;
    }
}

// hard case C17
TEST(Walk, SlidesAlongPiecesThatBelongToManyRooms) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < 20; ++i) rooms.push_back(box_room(std::to_string(i), 0.5 * i, 0, 0.5 * i + 0.5, 10));
    MapFile file = map_of(std::move(rooms));
    join_all(file);
    place_player(file, "2", {1.25, 9}, kEyeOnFloor, 45);
    Game pieces(file), whole(box_with_player(1.25, 9, 45));
    for (int i = 0; i < 200; ++i) {
        whole.hold(kForward);
        pieces.hold(kForward);
        ASSERT_EQ(pieces.point(), whole.point()) << "tick " << i;
    }
}

// hard case C14
TEST(Walk, GivesTheMirroredWayInTheMirroredMap) {
    const std::vector<Vec2> outline{{0, 0}, {9, 1}, {12, 5}, {8, 7}, {9, 11}, {1, 10}};
    std::vector<Vec2> mirrored;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 v = outline[(outline.size() - i) % outline.size()];
        mirrored.push_back({v.x, -v.y});
    }
    MapFile file = map_of({room("room", outline)}), image = map_of({room("room", mirrored)});
    place_player(file, "room", {5, 5}, kEyeOnFloor, 10);
    place_player(image, "room", {5, -5}, kEyeOnFloor, -10);
    Game game(file), reflected(image);
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const auto turn = static_cast<std::int32_t>(random.bits()) / 32;
        game.hold({.forward = 127, .strafe = 40, .yaw_steps = turn, .buttons = kButtonRun});
        reflected.hold({.forward = 127, .strafe = -40, .yaw_steps = -turn, .buttons = kButtonRun});
        ASSERT_EQ(reflected.point(), (Vec2{game.point().x, -game.point().y})) << "tick " << i;
    }
}

// hard case C16
TEST(Walk, ComesToRestInASharpCorner) {
    // Six degrees at the tip, pushed into for twenty seconds.
    MapFile sharp = map_of({room("spike", {{0, -1}, {20, 0}, {0, 1}})});
    place_player(sharp, "spike", {1, 0.1}, kEyeOnFloor, 1);
    Game game(sharp);
    game.hold(kRunForward, 600);
    ASSERT_TRUE(touches_nothing(game));
    const Vec2 at_rest = game.point();
    for (int i = 0; i < 600; ++i) {
        game.hold(kRunForward);
        ASSERT_TRUE(touches_nothing(game));
        ASSERT_NEAR(game.point().x, at_rest.x, 4 * kPointGrid);
        ASSERT_NEAR(game.point().y, at_rest.y, 4 * kPointGrid);
    }
}

// hard case C16
TEST(Walk, NeverGetsIntoTheWallsOfASharpCornerHoweverItTurns) {
    MapFile file = map_of({room("spike", {{0, -1}, {20, 0}, {0, 1}})});
    place_player(file, "spike", {1, 0.1}, kEyeOnFloor);
    Game game(file);
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const auto turn = static_cast<std::int32_t>(random.bits()) / 64;
        game.hold({.forward = 127, .yaw_steps = turn, .buttons = kButtonRun});
        ASSERT_TRUE(touches_nothing(game)) << "tick " << i;
    }
}

TEST(Walk, RoundsAPillarWithoutStopping) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 10)});
    cut_pillar(file.sectors[0], 4, 4, 6, 6);
    place_player(file, "hall", {3, 3.9}, kEyeOnFloor, 0);
    Game game(file);
    game.hold(kForward, 240);
    EXPECT_GT(game.point().x, 7) << "past the pillar's corner, which its middle passes 0.1 m off";
}

TEST(Walk, PassesADoorThatIsWiderThanTheBodyOnly) {
    for (const double width : {0.75, 0.625}) {
        MapFile file = map_of(
            {box_room("a", 0, 0, 4, 4), box_room("b", 4, 2 - width / 2, 5, 2 + width / 2), box_room("c", 5, 0, 9, 4)});
        split_and_join(file);
        place_player(file, "a", {2, 2}, kEyeOnFloor, 0);
        Game game(file);
        game.hold(kForward, 200);
        EXPECT_EQ(game.room(), width > 2 * kBodyRadius ? "c" : "a") << width;
    }
}

/// Two rooms of 4 x 4 m with a slanted pillar just behind the doorway between them at x = 4.
MapFile room_with_pillar_behind_door() {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 4, 0, 8, 4)});
    file.sectors[1].loops.push_back(loop_of({{4.25, 1}, {4.5, 1.75}, {5, 1.5}}));
    join_all(file);
    return file;
}

/// The same with the far room somewhere else, turned by a quarter and linked.
MapFile room_with_pillar_behind_link() {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 100, 50, 104, 54)});
    file.sectors[1].loops.push_back(loop_of({{103, 50.25}, {102.25, 50.5}, {102.5, 51}}));
    link(file, "near", {4, 0}, {4, 4}, "far", {100, 50}, {104, 50});
    return file;
}

/// Two rooms with a fence between them that one of them names.
MapFile fenced_rooms(bool named_by_first) {
    MapFile file = map_of({box_room("first", 0, 0, 4, 4), box_room("second", 4, 0, 8, 4)});
    join(file, "first", "second", {4, 0}, {4, 4});
    WallRecord& fence = named_by_first ? wall(file, "first", {4, 0}, {4, 4}) : wall(file, "second", {4, 4}, {4, 0});
    fence.blocks = true;
    place_player(file, "first", {2, 2}, kEyeOnFloor);
    return file;
}

TEST(Walk, StopsABodysRadiusFromAFenceWhicheverSideNamesIt) {
    for (const bool named_by_first : {true, false}) {
        Game game(fenced_rooms(named_by_first));
        game.hold(kForward, 200);
        EXPECT_EQ(game.point(), (Vec2{4 - kBodyRadius, 2}));
    }
}

// hard case C19
TEST(Walk, CollidesBehindALinkWithTheHalfThatIsThere) {
    expect_same_walks(room_with_pillar_behind_door(), room_with_pillar_behind_link(), [](const Game&) {});
}

TEST(Walk, SlidesThroughALinkAtAnyAngleWithoutStalling) {
    // A corridor between slanted walls, its two halves turned against each other: the link turns by 36.87 degrees. The
    // wall along (4, 3) goes on, beyond the link, along (1, 0).
    MapFile file = map_of({room("slanted", {{0, 0}, {8, 6}, {6.5, 8}, {-1.5, 2}}),
                           room("straight", {{100, 0}, {110, 0}, {110, 2.5}, {100, 2.5}})});
    link(file, "slanted", {8, 6}, {6.5, 8}, "straight", {100, 2.5}, {100, 0});
    place_player(file, "slanted", {0, 1.25}, kEyeOnFloor);
    for (const double push : {-30, -10, 10, 30}) {  // against the wall on the left, and on the right
        Game game(file);
        game.world.player.yaw = angle_of({4, 3}) + Angle::from_degrees(push);
        game.hold(kForward, 40);
        double shortest = kWalkSpeed * kTickSeconds;
        for (int i = 0; i < 180; ++i) {
            game.hold(kForward);
            const Vec2 way = inverse(game.world.passage).apply(game.point()) - game.world.before.place.point;
            shortest = std::fmin(shortest, std::sqrt(dot(way, way)));
        }
        EXPECT_EQ(game.room(), "straight");
        EXPECT_GT(shortest, kWalkSpeed * kTickSeconds * std::cos(push * std::numbers::pi / 180) - 1e-5) << push;
    }
}

TEST(Walk, SlidesRoundTheDoorPostOfAHutThatIsBiggerInside) {
    // The hut's whole east side is its door; inside, the door is a hole in the middle of a long wall. Around each door
    // post there is more than a full turn, so that from outside no straight look shows the wall inside.
    SectorRecord yard = box_room("yard", 0, 0, 12, 12);
    cut_pillar(yard, 4, 5, 6, 7);
    MapFile file = map_of({std::move(yard), room("inside", {{80, 0}, {90, 0}, {90, 5}, {90, 7}, {90, 12}, {80, 12}})});
    link(file, "yard", {6, 7}, {6, 5}, "inside", {90, 5}, {90, 7});
    for (double y = 4.75; y <= 7.25; y += 0.125) {
        place_player(file, "yard", {8, y}, kEyeOnFloor, 180);
        Game game(file);
        game.hold(kForward, 120);
        EXPECT_EQ(game.room(), std::fabs(y - 6) < 1 ? "inside" : "yard") << y;
        EXPECT_TRUE(touches_nothing(game)) << y;
    }
}

TEST(Walk, TurnsWithALinkThatTurns) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    place_player(file, "a", {3, 2}, kEyeOnFloor, 0);
    Game game(file);
    game.hold(kForward, 40);
    EXPECT_EQ(game.room(), "b");
    EXPECT_EQ(game.player().yaw.degrees(), 90);
    EXPECT_EQ(game.player().velocity.x, 0);
    EXPECT_NEAR(game.player().velocity.y, kWalkSpeed, 0.01);
    EXPECT_EQ(game.point().x, 102);
}

TEST(Walk, IsNotStoppedByARoomThatMerelyOverlaps) {
    // The pillar of "big" stands where the hall is, but no portal near the player leads to it.
    MapFile file = map_of({box_room("hall", 0, 0, 10, 4), box_room("big", 0, 0, 10, 4)});
    cut_pillar(file.sectors[1], 4, 1, 6, 3);
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    Game game(file);
    game.hold(kForward, 200);
    EXPECT_EQ(game.point().x, 10 - kBodyRadius);
}

TEST(Walk, IsNotStoppedByAWallBehindALink) {
    // A slab with a link on its face, too near to the yard's wall for anybody to get between the two.
    SectorRecord yard = box_room("yard", 3.75, 0, 12, 12);
    cut_pillar(yard, 3.875, 5, 4, 7);
    MapFile file = map_of({std::move(yard), box_room("hall", 80, 5, 90, 7)});
    link(file, "yard", {4, 7}, {4, 5}, "hall", {90, 5}, {90, 7});
    place_player(file, "yard", {8, 6}, kEyeOnFloor, 180);
    Game game(file);
    game.hold(kForward, 120);
    EXPECT_EQ(game.room(), "hall");
}

TEST(Walk, LeavesAStartThatIsTooNearToAWall) {
    for (const Vec2 start : {Vec2{0.01, 5}, Vec2{0, 0}, Vec2{9.99, 9.99}, Vec2{5, 0}}) {
        Game game(box_with_player(start.x, start.y, 0));
        EXPECT_TRUE(touches_nothing(game)) << "there is room to be moved off";
        EXPECT_TRUE(game.is_contained());
    }
}

TEST(Walk, LeavesAGapThatIsNarrowerThanTheBody) {
    MapFile file = map_of({box_room("gap", 0, 1.75, 4, 2.25), box_room("hall", 4, 0, 8, 4)});
    split_and_join(file);
    place_player(file, "gap", {1, 1.9}, kEyeOnFloor, 3);
    Game game(file);
    game.hold(kForward, 150);
    EXPECT_EQ(game.room(), "hall");
    EXPECT_TRUE(touches_nothing(game)) << "and is as wide as ever";
    game.world.player.yaw = game.player().yaw + Angle::from_degrees(180);
    game.hold(kForward, 200);
    EXPECT_EQ(game.room(), "hall") << "no way back";
}

// hard case C15
TEST(Walk, GoesAnyDistanceInOneTickWithoutPassingAWall) {
    Game game(box_with_player(5, 5, 0));
    Body body = body_of(game.map, game.player());
    for (const Vec2 velocity : {Vec2{1e6, 0}, Vec2{-1e6, 3e5}, Vec2{0, -1e6}, Vec2{600, 601}}) {
        const Walk gone = walk(game.map, body, velocity, kTickSeconds);
        body.place = gone.end;
        EnteredPortals entered;
        const Reach found = around(game.map, body, &entered);
        EXPECT_TRUE(fits(game.map, body, found, entered));
    }
}

// A low ceiling over one side of the body and a step under the other: what it may do under one it may not on both.
TEST(Squeezed, BodiesTouchNothingUnderTheCeilingThatTheyAreGiven) {
    const Map map = built([] {
        MapFile file = map_of({box_room("low", -4, 0, 0, 4, 0, 1.25), box_room("middle", 0, 0, 0.5, 4, 0, 1.5),
                               box_room("step", 0.5, 0, 4, 4, 0.25, 1.5)});
        join_all(file);
        return file;
    }());
    int narrow = 0;
    for (int h = 0; h <= 28; ++h)
        for (const double x : {0.125, 0.25, 0.3125}) {
            const Body body = squeezed(map, {{SectorId(1u), {x, 2}}, 0, 0.0625 * h, kBodyRadius, kWorldLimit});
            const Reach reached = around(map, body);
            EXPECT_TRUE(reached.walls.empty()) << body.height << " high at " << x;
            EXPECT_EQ(body.ceiling_z, clearance(map, body, reached.sectors).ceiling_z);
            narrow += body.radius < kBodyRadius;
        }
    EXPECT_GT(narrow, 0);
}

/// The dearest of many walks near the middle of a fan.
struct Dearest {
    int queries = 0;
    std::size_t walls_a_query = 0;
};

Dearest dearest_walk(const Map& map, double speed) {
    Random random(1);
    const History nothing;
    Dearest most;
    for (int i = 0; i < 500; ++i) {
        const Vec2 p = snap_to_point_grid(Vec2{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)});
        const Instant now(map, nothing, 0.0);
        const Body body = body_of(now, player_at(map, {locate(map, p), p, kEyeOnFloor, {}}));
        const Vec2 velocity{random.uniform(-speed, speed), random.uniform(-speed, speed)};
        const Walk walked = walk(now, body, velocity, kTickSeconds);
        most.queries = std::max(most.queries, walked.queries);
        most.walls_a_query =
            std::max(most.walls_a_query, walked.walls_looked_at / static_cast<std::size_t>(walked.queries));
    }
    return most;
}

// hard case T15
TEST(WalkCost, WhereManyRoomsMeetFollowsTheRoomsOnceEach) {
    constexpr std::size_t kParts = 120, kSectors = 4;
    const Map map = built(fan_of_scattered_sectors(kParts, kSectors));
    for (const double speed : {4.0, 40.0, 2000.0}) {
        const Dearest most = dearest_walk(map, speed);
        EXPECT_LE(most.walls_a_query, (kParts + 1) * (3 * kParts / kSectors) + kParts * kParts) << speed;
        EXPECT_LE(most.queries, 2) << speed << ": nothing is in the way";
    }
}

/// A hall, a narrow lintel before the corner where four rooms meet, twice around it: above it to the north "over",
/// which leads on to a step, to the south "beyond". Who is under the lintel is too high for the step.
MapFile lintel_before_a_double_corner() {
    constexpr double kLintel = 1.0 / 64, kCeiling = 4, kStep = 0.5;
    const double x = 4 - kLintel;
    MapFile file =
        map_of({room("hall", {{0, -4}, {x, -4}, {x, 4}, {0, 4}}, 0, kCeiling),
                room("lintel", {{x, -4}, {4, -4}, {4, 0}, {4, 4}, {x, 4}}, 0, kStep + kStandingHeight - 0.125),
                room("over", {{100, -4}, {104, -4}, {104, 4}, {100, 4}, {100, 0}}, 0, kCeiling),
                room("step", {{96, -4}, {100, -4}, {100, 0}, {100, 4}, {96, 4}}, kStep, kCeiling),
                room("beyond", {{4, -4}, {8, -4}, {8, 4}, {4, 4}, {4, 0}}, 0, kCeiling)});
    join(file, "hall", "lintel", {x, -4}, {x, 4});
    link(file, "lintel", {4, -4}, {4, 0}, "over", {100, 0}, {100, -4});
    join(file, "step", "over", {100, 0}, {100, 4});
    link(file, "step", {100, -4}, {100, 0}, "beyond", {4, 0}, {4, -4});
    wall(file, "step", {100, -4}, {100, 0}).rise = 0;
    join(file, "lintel", "beyond", {4, 0}, {4, 4});
    return file;
}

// The step is touched around the corner only, so nothing but the ceiling that one would come under forbids it.
// hard case C20
TEST(Walk, ComesUnderNoCeilingThatIsTooLowForAStepRoundTheCorner) {
    for (double y = -0.25; y <= 0.25; y += 0.03125) {
        MapFile file = lintel_before_a_double_corner();
        place_player(file, "hall", {3, y}, kEyeOnFloor);
        Game game(file);
        PlayerWatch watch;
        for (int tick = 0; tick < 120; ++tick) {
            game.hold(kForward);
            ASSERT_EQ(watch.fault_of(game.map, game.world), "") << "from y = " << y << ", tick " << tick;
        }
    }
}

}  // namespace
}  // namespace enfilade
