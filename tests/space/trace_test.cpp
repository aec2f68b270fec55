// Paths through small maps, one hard case at a time.
#include "space/trace.h"

#include <gtest/gtest.h>

#include "math/vec.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

const SectorId kFirst(0u), kSecond(1u);

/// Rooms of 4 x 4 m in a row along x, all joined.
Map row_of_rooms(int count) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < count; ++i) rooms.push_back(box_room("room " + std::to_string(i), 4 * i, 0, 4 * i + 4, 4));
    MapFile file = map_of(std::move(rooms));
    join_all(file);
    return built(file);
}

// hard case C6
TEST(Trace, CrossesEveryPortalOnALongWay) {
    const Map map = row_of_rooms(9);
    const Trace path = trace(map, {kFirst, {1, 2}}, {34, 2});
    EXPECT_EQ(path.crossings.size(), 8u);
    EXPECT_EQ(path.end, (Place{SectorId(8u), {34, 2}}));
}

// hard case C14
TEST(Trace, CrossesAsManyPortalsGoingTheOtherWay) {
    const Map map = row_of_rooms(9);
    EXPECT_EQ(trace(map, {SectorId(8u), {34, 2}}, {1, 2}).end.sector, kFirst);
}

// hard case C15
TEST(Trace, ReportsTheWallBehindTenThousandMetres) {
    const Map map = row_of_rooms(3);
    const Trace path = trace(map, {kFirst, {1, 2}}, {10001, 2});
    EXPECT_EQ(path.end, (Place{SectorId(2u), {12 - kPointGrid, 2}}));
    EXPECT_EQ(map[path.stopped].a, (Vec2{12, 0}));
}

// hard case C4
TEST(Trace, GoesNowhereOnAPathOfNoLength) {
    const Map map = row_of_rooms(2);
    const Place on_the_line{kSecond, {4, 2}};
    const Trace path = trace(map, on_the_line, on_the_line.point);
    EXPECT_EQ(path.end, on_the_line);
    EXPECT_TRUE(path.crossings.empty());
}

// hard case C2
TEST(Trace, CrossesOnceWhenAMoveEndsOnTheLineAndTheNextGoesOn) {
    const Map map = row_of_rooms(2);
    const Trace onto = trace(map, {kFirst, {3, 2}}, {4, 2});
    const Trace beyond = trace(map, onto.end, {5, 2});
    EXPECT_EQ(onto.crossings.size() + beyond.crossings.size(), 1u);
    EXPECT_EQ(beyond.end.sector, kSecond);
}

// hard case C3
TEST(Trace, CrossesTwiceOrNeverWhenAMoveEndsOnTheLineAndTurnsBack) {
    const Map map = row_of_rooms(2);
    const Trace onto = trace(map, {kFirst, {3, 2}}, {4, 2});
    const Trace back = trace(map, onto.end, {3, 2});
    EXPECT_EQ(onto.crossings.size(), back.crossings.size());
    EXPECT_EQ(back.end.sector, kFirst);
}

// hard case C5
TEST(Trace, KeepsToOneSideWhenItRunsAlongAPortal) {
    const Map map = row_of_rooms(2);
    const SectorId side = locate(map, {4, 1});
    const Trace along = trace(map, {side, {4, 1}}, {4, 3});
    EXPECT_TRUE(along.crossings.empty());
    EXPECT_EQ(along.end, (Place{side, {4, 3}}));
}

// hard case C5
TEST(Trace, StopsInsideWhenItRunsAlongAPortalAndPastItsEnd) {
    const Map map = row_of_rooms(2);
    const SectorId side = locate(map, {4, 1});
    const Trace along = trace(map, {side, {4, 1}}, {4, 9});
    EXPECT_TRUE(along.stopped);
    EXPECT_TRUE(contains(map, along.end.sector, along.end.point));
}

// hard case C7
TEST(Trace, StaysInTheWorldWhenItIsAimedAtADoorPost) {
    const Map map = row_of_rooms(2);
    for (Vec2 post : {Vec2{4, 0}, Vec2{4, 4}})
        for (double x = 0.25; x < 4; x += 0.25) {
            const Vec2 from{x, 2};
            const Trace path = trace(map, {kFirst, from}, post + (post - from));
            ASSERT_TRUE(path.stopped);
            ASSERT_TRUE(contains(map, path.end.sector, path.end.point));
        }
}

TEST(Trace, IsStoppedByAPortalThatMayNotBePassed) {
    const Map map = row_of_rooms(3);
    const auto refuse_second = [&](WallId portal, const Rigid&) { return map[portal].sector != kSecond; };
    const Trace path = trace(map, {kFirst, {1, 2}}, {11, 2}, refuse_second);
    EXPECT_EQ(path.end.sector, kSecond);
    EXPECT_EQ(map[path.stopped].a, (Vec2{8, 0}));
    EXPECT_EQ(path.crossings.size(), 1u);
}

TEST(Trace, StaysWhereItStartsWhenItStandsAtTheWall) {
    const Map map = row_of_rooms(1);
    const Place at_wall{kFirst, {4 - kPointGrid, 2}};
    EXPECT_EQ(trace(map, at_wall, {5, 2}).end, at_wall);
}

TEST(Trace, TakesAMirrorForAWall) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
    wall(file, "room", {4, 0}, {4, 4}).mirror = true;
    const Trace path = trace(built(file), {kFirst, {1, 2}}, {7, 2});
    EXPECT_EQ(path.end, (Place{kFirst, {4 - kPointGrid, 2}}));
}

TEST(Trace, PassesAOneWayPortalInItsDirectionOnly) {
    MapFile file = map_of({box_room("from", 0, 0, 4, 4), box_room("to", 4, 0, 8, 4)});
    wall(file, "from", {4, 0}, {4, 4}).next = "to";
    const Map map = built(file);
    EXPECT_EQ(trace(map, {kFirst, {1, 2}}, {7, 2}).end, (Place{kSecond, {7, 2}}));
    EXPECT_EQ(trace(map, {kSecond, {7, 2}}, {1, 2}).end, (Place{kSecond, {4, 2}}));
}

TEST(Trace, StaysInItsArmOfANonConvexRoom) {
    // A U whose arms are joined at the bottom (larger y): the way from arm to arm is stopped, the way round is free.
    MapFile file = map_of({room("u", {{0, 0}, {2, 0}, {2, 6}, {4, 6}, {4, 0}, {6, 0}, {6, 8}, {0, 8}})});
    const Map map = built(file);
    const Trace across = trace(map, {kFirst, {1, 3}}, {5, 3});
    EXPECT_EQ(across.end.point, (Vec2{2 - kPointGrid, 3}));
    EXPECT_EQ(trace(map, trace(map, {kFirst, {1, 3}}, {1, 7}).end, {5, 7}).end.point, (Vec2{5, 7}));
}

TEST(Trace, LeavesAndReentersANonConvexRoom) {
    MapFile file = map_of(
        {room("u", {{0, 0}, {2, 0}, {2, 6}, {4, 6}, {4, 0}, {6, 0}, {6, 8}, {0, 8}}), box_room("between", 2, 0, 4, 6)});
    join_all(file);
    const Map map = built(file);
    const Trace path = trace(map, {kFirst, {1, 3}}, {5, 3});
    EXPECT_EQ(path.crossings.size(), 2u);
    EXPECT_EQ(path.end, (Place{kFirst, {5, 3}}));
}

// hard case T8
TEST(Trace, WalksAroundAHoleWithTwoPillarsTouching) {
    SectorRecord hall = box_room("hall", 0, 0, 8, 8);
    cut_pillar(hall, 2, 2, 4, 4);
    cut_pillar(hall, 4, 4, 6, 6);
    MapFile file = map_of({hall});
    const Map map = built(file);
    // Through the point where the pillars touch, the tie rule lets the path pass on one side or stops it: never both.
    const Trace squeezed = trace(map, {kFirst, {3, 5}}, {5, 3});
    EXPECT_TRUE(contains(map, kFirst, squeezed.end.point));
    const Trace back = trace(map, squeezed.end, {3, 5});
    EXPECT_EQ(squeezed.stopped.is_none(), back.end.point == (Vec2{3, 5}) && squeezed.end.point == (Vec2{5, 3}));
}

TEST(Trace, EndsInTheOverlappingRoomThatThePortalsLeadTo) {
    // "big" lies over "small": from the doorway one gets into big, never into small.
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4), box_room("big", 4, 0, 12, 4), box_room("small", 5, 1, 6, 2)});
    join_all(file);
    const Map map = built(file);
    EXPECT_EQ(trace(map, {kFirst, {1, 1.5}}, {5.5, 1.5}).end, (Place{kSecond, {5.5, 1.5}}));
}

/// A room of 8 x 8 m with a panel that blocks from (4, 2) to (4, 6), and others that only have triggers.
Map room_with_panels(std::initializer_list<std::pair<Vec2, Vec2>> lines = {}) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8)});
    PanelRecord panel;
    panel.texture = spec("-");
    panel.a = {4, 2};
    panel.b = {4, 6};
    panel.blocks = true;
    file.sectors[0].panels.push_back(panel);
    panel.blocks = false;
    panel.triggers.emplace_back();
    for (const auto& [a, b] : lines) {
        panel.a = a;
        panel.b = b;
        file.sectors[0].panels.push_back(panel);
    }
    return built(file);
}

/// As bodies go.
Trace walk_straight(const Map& map, Vec2 from, Vec2 to) {
    return trace(map, {kFirst, from}, to, {}, [&](const MetPanel& met) { return !map[met.panel].blocks; });
}

std::vector<std::uint32_t> panels_of(const Trace& trace) {
    std::vector<std::uint32_t> panels;
    for (const Crossing& crossing : trace.crossings) panels.push_back(crossing.through.panel.index);
    return panels;
}

TEST(TraceThroughPanels, IsStoppedByOneThatBlocksFromEitherSide) {
    const Map map = room_with_panels();
    const Trace there = walk_straight(map, {1, 4}, {7, 4}), back = walk_straight(map, {7, 4}, {1, 4});
    EXPECT_EQ(there.end.point, (Vec2{4 - kPointGrid, 4}));
    EXPECT_EQ(back.end.point, (Vec2{4, 4})) << "the tie rule counts the line as further right";
    EXPECT_EQ(there.barrier, (MetPanel{PanelId(0u), false}));
    EXPECT_EQ(back.barrier, (MetPanel{PanelId(0u), true}));
    EXPECT_FALSE(there.stopped);
}

TEST(TraceThroughPanels, TakesNoNoticeOfThemUnlessAsked) {
    const Map map = room_with_panels({{{5, 2}, {5, 6}}});
    const Trace path = trace(map, {kFirst, {1, 4}}, {7, 4});
    EXPECT_FALSE(path.is_stopped());
    EXPECT_TRUE(path.crossings.empty());
}

TEST(TraceThroughPanels, PassesAnEndOnTheSideOfTheTieRule) {
    // Exactly through an end, the path counts as a little further down and to the right.
    const Map map = room_with_panels();
    EXPECT_TRUE(walk_straight(map, {1, 2}, {7, 2}).is_stopped());
    EXPECT_FALSE(walk_straight(map, {1, 6}, {7, 6}).is_stopped());
    EXPECT_TRUE(walk_straight(map, {7, 2}, {1, 2}).is_stopped());
    EXPECT_FALSE(walk_straight(map, {7, 6}, {1, 6}).is_stopped());
}

// hard case C5
TEST(TraceThroughPanels, RunsAlongOneOnOneSide) {
    const Map map = room_with_panels();
    const Trace along = walk_straight(map, {4, 1}, {4, 7});
    EXPECT_FALSE(along.is_stopped());
    EXPECT_TRUE(walk_straight(map, {4, 4}, {3, 4}).is_stopped()) << "the line belongs to the side where x is larger";
    EXPECT_FALSE(walk_straight(map, {4, 4}, {5, 4}).is_stopped());
}

// hard case C2
TEST(TraceThroughPanels, CrossesOnceWhenAMoveEndsOnTheLine) {
    const Map map = room_with_panels({{{2, 0}, {2, 8}}});
    const Trace onto = walk_straight(map, {1, 4}, {2, 4}), beyond = walk_straight(map, onto.end.point, {3, 4});
    EXPECT_EQ(onto.crossings.size() + beyond.crossings.size(), 1u);
}

TEST(TraceThroughPanels, ReportsThemInOrderHoweverTheyAreListed) {
    const Map map = room_with_panels({{{3, 0}, {3, 8}}, {{1, 0}, {1, 8}}, {{2, 8}, {2, 0}}, {{0, 1}, {1, 1}}});
    EXPECT_EQ(panels_of(walk_straight(map, {0.5, 4}, {3.5, 4})), (std::vector<std::uint32_t>{2, 3, 1}));
    EXPECT_EQ(panels_of(walk_straight(map, {3.5, 4}, {0.5, 4})), (std::vector<std::uint32_t>{1, 3, 2}));
    EXPECT_EQ(panels_of(walk_straight(map, {3.5, 4}, {7, 4})), (std::vector<std::uint32_t>{}));
}

TEST(TraceThroughPanels, ReportsOnlyThoseBeforeTheOneThatStopsIt) {
    const Map map = room_with_panels({{{3, 0}, {3, 8}}, {{5, 0}, {5, 8}}, {{4, 2}, {4, 6}}});
    EXPECT_EQ(panels_of(walk_straight(map, {1, 4}, {7, 4})), std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace enfilade
