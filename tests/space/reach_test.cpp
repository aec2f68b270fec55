// What a disc touches, checked by walking straight from its middle in many directions.
#include "space/reach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "math/vec.h"
#include "space/mosaic.h"
#include "space/trace.h"
#include "support/generate_map.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const SectorId kNearRoom(0u), kFarRoom(1u);

std::vector<WallId> walls_of(const Reach& found) {
    std::vector<WallId> walls;
    for (const ReachedWall& w : found.walls) walls.push_back(w.wall);
    return walls;
}

std::vector<SectorId> sectors_of(const Reach& found) {
    std::vector<SectorId> sectors;
    for (const ReachedSector& s : found.sectors) sectors.push_back(s.sector);
    return sectors;
}

bool overlaps(const Reach& found, SectorId sector) {
    return std::any_of(found.sectors.begin(), found.sectors.end(),
                       [&](const ReachedSector& s) { return s.sector == sector; });
}

double distance_to(const ReachedWall& wall) {
    const Vec2 to_it = nearest_point(wall.stretch, wall.centre) - wall.centre;
    return std::sqrt(dot(to_it, to_it));
}

double distance_to_nearest(const Reach& found) {
    double nearest = kWorldLimit;
    for (const ReachedWall& w : found.walls) nearest = std::min(nearest, distance_to(w));
    return nearest;
}

/// Walks from the place in many directions; each way must be stopped only by what was found, and must end in a
/// sector that was found.
void expect_no_more_than_found(const Map& map, const Place& place, double radius, const Reach& found) {
    constexpr int kDirections = 64;
    const double nearest = distance_to_nearest(found);
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const Vec2 ahead = direction({i * (1u << 26) + 12345u});
        const double length = std::min(radius, nearest) - 4 * kPointGrid;
        if (length <= 0) return;
        const Trace way = trace(map, place, snap_to_point_grid(place.point + ahead * length));
        ASSERT_TRUE(way.stopped.is_none()) << "direction " << i;
        ASSERT_TRUE(overlaps(found, way.end.sector)) << "direction " << i;
    }
}

Place random_place(const Mosaic& mosaic, Random& random) {
    while (true) {
        const Vec2 p = snap_to_point_grid({random.uniform(0, 32), random.uniform(0, 32)});
        if (const SectorId sector = mosaic.sector_at(p)) return {sector, p};
    }
}

TEST(Reach, FindsAllThatStraightWaysRunInto) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Mosaic mosaic = lay_mosaic({.jitter = 0.9, .labels = 12, .solid = 0.3}, seed);
        Random random(seed);
        for (int i = 0; i < 300; ++i) {
            const Place place = random_place(mosaic, random);
            const double radius = snap_to_point_grid(random.uniform(0.1, 5));
            const Reach found = reach(mosaic.map, place, radius);
            expect_no_more_than_found(mosaic.map, place, radius, found);
            ASSERT_FALSE(testing::Test::HasFatalFailure()) << "seed " << seed << ", disc " << i;
        }
    }
}

TEST(Reach, FindsNoNearestWallThatAStraightWayDoesNotRunInto) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Mosaic mosaic = lay_mosaic({.jitter = 0.9, .labels = 12, .solid = 0.3}, seed);
        Random random(seed);
        for (int i = 0; i < 300; ++i) {
            const Place place = random_place(mosaic, random);
            Reach found = reach(mosaic.map, place, 2);
            found.walls.erase_if([](const ReachedWall& w) { return w.stretch.a == w.stretch.b; });
            if (found.walls.empty()) continue;
            const auto nearest = std::min_element(
                found.walls.begin(), found.walls.end(),
                [](const ReachedWall& v, const ReachedWall& w) { return distance_to(v) < distance_to(w); });
            // A little beyond the wall, off its ends: there the way has to end.
            const Vec2 inner = (nearest->stretch.a + nearest->stretch.b) * 0x1p-20 +
                               nearest_point(nearest->stretch, place.point) * (1 - 0x1p-19);
            const Vec2 beyond = snap_to_point_grid(place.point + (inner - place.point) * 1.0001);
            ASSERT_TRUE(trace(mosaic.map, place, beyond).stopped) << "seed " << seed << ", disc " << i;
        }
    }
}

TEST(Reach, DoesNotCountTouching) {
    const Map map = built(map_of({box_room("room", 0, 0, 4, 4)}));
    EXPECT_THAT(reach(map, {kNearRoom, {2, 1}}, 1).walls, IsEmpty());
    EXPECT_THAT(reach(map, {kNearRoom, {2, 1}}, 1 + kPointGrid).walls, SizeIs(1));
}

TEST(Reach, LooksThroughPortals) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 0, 4.25, 4)});
    join_all(file);
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {3.5, 2}}, 1);
    EXPECT_THAT(sectors_of(found), testing::ElementsAre(kNearRoom, kFarRoom));
    ASSERT_THAT(found.walls, SizeIs(1));
    EXPECT_EQ(map[found.walls[0].wall].a, (Vec2{4.25, 0}));
}

TEST(Reach, FindsNoWallOnTheBackOfTheDoorway) {
    // The room behind the doorway has another part, on the near side of it: where the first room is, too.
    SectorRecord behind = box_room("behind", 4, 0, 8, 4);
    behind.loops.push_back(box_room("", 0, 0, 4, 4).loops[0]);
    MapFile file = map_of({box_room("before", 0, 0, 4, 4), std::move(behind)});
    join(file, "before", "behind", {4, 0}, {4, 4});
    const Map map = built(file);
    EXPECT_THAT(reach(map, {kNearRoom, {3.9, 2}}, 1).walls, IsEmpty());
}

TEST(Reach, FindsAWallThatOnlyShowsItsEndAroundACorner) {
    // Outside, the corner of a hut whose whole front is a door; inside, the door is a hole in a long wall.
    SectorRecord yard = box_room("yard", 0, 0, 12, 12);
    cut_pillar(yard, 4, 5, 6, 7);
    MapFile file = map_of({std::move(yard), room("inside", {{80, 0}, {90, 0}, {90, 5}, {90, 7}, {90, 12}, {80, 12}})});
    link(file, "yard", {6, 7}, {6, 5}, "inside", {90, 5}, {90, 7});
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {6.5, 5.25}}, 1);
    ASSERT_THAT(found.walls, SizeIs(1));
    EXPECT_EQ(map[found.walls[0].wall].b, (Vec2{90, 5}));
    EXPECT_EQ(distance_to(found.walls[0]), std::sqrt(0.5 * 0.5 + 0.25 * 0.25));
    EXPECT_THAT(reach(map, {kNearRoom, {6.5, 6}}, 1).walls, IsEmpty());
}

// A portal that lets nobody out, but in: what is open goes all the way round the corner and comes back into the room,
// whose own look does not show that wall.
TEST(Reach, FindsTheEndOfAClosedWallThatTurnsItsBackWhereAllElseRoundItsCornerIsOpen) {
    MapFile file =
        map_of({room("yard", {{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 4}, {0, 4}}), box_room("hut", 0, 4, 4, 8)});
    join_all(file);
    const Map map = built(file);
    const WallId open(3u), closed(4u);  // (4, 8) to (4, 4), (4, 4) to (0, 4)
    const auto reached_from = [&](Vec2 p) {
        return reach(map, {kNearRoom, p}, 0.5, [&](WallId id, const Rigid&) { return id != closed; });
    };
    const Reach found = reached_from({4.125, 4.25});
    ASSERT_THAT(walls_of(found), testing::ElementsAre(closed));
    EXPECT_EQ(found.walls[0].stretch.a, (Vec2{4, 4}));
    EXPECT_EQ(found.walls[0].stretch.b, (Vec2{4, 4}));
    EXPECT_TRUE(overlaps(found, map[open].behind));
    EXPECT_THAT(reached_from({4.125, 4.75}).walls, IsEmpty());
}

TEST(Reach, CountsARefusedPortalAsAWall) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 0, 8, 4)});
    join_all(file);
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {3.5, 2}}, 1, [](WallId, const Rigid&) { return false; });
    EXPECT_THAT(walls_of(found), testing::ElementsAre(WallId(1u)));
    EXPECT_THAT(sectors_of(found), testing::ElementsAre(kNearRoom));
}

/// A panel from a to b that blocks.
PanelRecord fence(Vec2 a, Vec2 b) {
    PanelRecord panel;
    panel.a = a;
    panel.b = b;
    panel.texture = spec("-");
    panel.blocks = true;
    return panel;
}

TEST(Reach, FindsAPanelThatBlocksTurnedToTheMiddle) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8)});
    file.sectors[0].panels = {fence({4, 2}, {4, 6})};
    const Map map = built(file);
    EXPECT_THAT(reach(map, {kNearRoom, {3, 4}}, 1).walls, IsEmpty()) << "touching does not count";
    for (const double x : {3., 5.}) {
        const Reach found = reach(map, {kNearRoom, {x, 4}}, 1 + kPointGrid);
        ASSERT_THAT(found.walls, SizeIs(1));
        EXPECT_EQ(found.walls[0].panel, PanelId(0u));
        EXPECT_EQ(found.walls[0].a, (Vec2{4, x < 4 ? 2. : 6.}));
    }
}

TEST(Reach, FindsAPanelByItsEnd) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8)});
    file.sectors[0].panels = {fence({4, 2}, {4, 5})};
    const Map map = built(file);
    EXPECT_THAT(reach(map, {kNearRoom, {4, 6}}, 1).walls, IsEmpty());
    EXPECT_THAT(reach(map, {kNearRoom, {4, 6}}, 1 + kPointGrid).walls, SizeIs(1));
}

TEST(Reach, LeavesOutPanelsThatDoNotBlock) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8)});
    file.sectors[0].panels = {fence({4, 2}, {4, 6}), fence({4.5, 2}, {4.5, 6})};
    file.sectors[0].panels[0].blocks = false;
    const Reach found = reach(built(file), {kNearRoom, {4.25, 4}}, 1);
    ASSERT_THAT(found.walls, SizeIs(1));
    EXPECT_EQ(found.walls[0].panel, PanelId(1u));
}

TEST(Reach, FindsAPanelBehindALinkWhereItIs) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    file.sectors[1].panels = {fence({101, 50.25}, {103, 50.25}), fence({101, 53}, {103, 53})};
    const Reach found = reach(built(file), {kNearRoom, {3.5, 2}}, 1);
    ASSERT_THAT(found.walls, SizeIs(1));
    EXPECT_EQ(found.walls[0].panel, PanelId(0u));
    EXPECT_EQ(distance_to(found.walls[0]), 0.75);
}

TEST(Reach, DoesNotFindAPanelThatADoorwayDoesNotShow) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 1, 5, 3), box_room("c", 5, 0, 9, 4)});
    split_and_join(file);
    sector(file, "c").panels = {fence({5.125, 0}, {5.125, 0.75})};
    EXPECT_THAT(reach(built(file), {kNearRoom, {3.75, 2.5}}, 2.5).walls, SizeIs(testing::Gt(0u)));
    for (const ReachedWall& wall : reach(built(file), {kNearRoom, {3.75, 2.5}}, 2.5).walls) EXPECT_FALSE(wall.panel);
}

TEST(Reach, FindsAPanelThatOnlyShowsItsEndAroundACorner) {
    // As above: around the corner of the hut's door there is more than a full turn.
    SectorRecord yard = box_room("yard", 0, 0, 12, 12);
    cut_pillar(yard, 4, 5, 6, 7);
    MapFile file = map_of({std::move(yard), room("inside", {{80, 0}, {90, 0}, {90, 5}, {90, 7}, {90, 12}, {80, 12}})});
    link(file, "yard", {6, 7}, {6, 5}, "inside", {90, 5}, {90, 7});
    file.sectors[1].panels = {fence({90, 5}, {85, 2})};
    const Reach found = reach(built(file), {kNearRoom, {6.5, 5.25}}, 1);
    EXPECT_TRUE(
        std::any_of(found.walls.begin(), found.walls.end(), [](const ReachedWall& w) { return bool(w.panel); }));
}

TEST(Reach, IsEndedByPanelsAsByThePortalsTheyStandIn) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Mosaic mosaic = lay_mosaic({.jitter = 0.9, .labels = 12, .solid = 0.1}, seed);
        Map fenced = mosaic.map;
        const auto is_fenced = [&](WallId id) { return std::min(id, mosaic.map[id].exit).index % 3 == 0; };
        for (Sector& sector : fenced.sectors) {
            sector.first_panel = static_cast<std::uint32_t>(fenced.panels.size());
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
                const Wall& wall = fenced.walls[w];
                // On one side of the portal, now the one and now the other, and in either direction.
                if (wall.kind != WallKind::portal || !is_fenced(WallId(w))) continue;
                const std::uint32_t lower = std::min(w, wall.exit.index);
                if ((w == lower) != (lower % 2 == 0)) continue;
                Panel panel;
                panel.a = w % 5 < 2 ? wall.a : wall.b;
                panel.b = w % 5 < 2 ? wall.b : wall.a;
                panel.blocks = true;
                fenced.panels.push_back(panel);
            }
            sector.panel_count = sector.active_panels =
                static_cast<std::uint32_t>(fenced.panels.size()) - sector.first_panel;
        }
        Random random(seed);
        for (int i = 0; i < 1000; ++i) {
            const Place place = random_place(mosaic, random);
            const double radius = snap_to_point_grid(random.uniform(0.1, 2));
            const Reach by_panels = reach(fenced, place, radius);
            const Reach by_portals =
                reach(mosaic.map, place, radius, [&](WallId id, const Rigid&) { return !is_fenced(id); });
            ASSERT_EQ(by_panels.walls.empty(), by_portals.walls.empty()) << "seed " << seed << ", disc " << i;
        }
    }
}

TEST(Reach, LooksThroughLinksFromBothSides) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {3.5, 0.25}}, 1);
    // The north wall of a, and beyond the link the east wall of b, which stands in line with it: its corner and face.
    EXPECT_THAT(walls_of(found), testing::ElementsAre(WallId(0u), WallId(5u), WallId(5u)));
    EXPECT_EQ(found.walls.back().centre, (Vec2{103.75, 49.5}));
}

TEST(Reach, IgnoresWallsOfTheOtherRoomThatLieOnThisSideOfTheDoorway) {
    // "big" surrounds "hut" and overlaps it: its pillar stands, on the drawing, in the middle of the hut.
    SectorRecord big = box_room("big", -10, -10, 14, 14);
    cut_pillar(big, 1, 1, 2, 3);
    big.loops.push_back(loop_of({{4, 0}, {3.75, 0}, {3.75, 4}, {4, 4}}));
    MapFile file = map_of({box_room("hut", 0, 0, 4, 4), std::move(big)});
    wall(file, "hut", {4, 0}, {4, 4}).next = "big";
    wall(file, "big", {4, 4}, {4, 0}).next = "hut";
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {2.5, 2}}, 1.75);
    for (const ReachedWall& w : found.walls) EXPECT_EQ(map[w.wall].sector, kNearRoom);
    EXPECT_TRUE(overlaps(found, kFarRoom));
}

TEST(Reach, CutsAWallToThePartThatIsSeenThroughTheDoorway) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 1, 5, 3)});
    split_and_join(file);
    const Map map = built(file);
    const Reach found = reach(map, {kNearRoom, {3.5, 2}}, 2);
    const auto east = std::find_if(found.walls.begin(), found.walls.end(),
                                   [&](const ReachedWall& w) { return map[w.wall].a == (Vec2{5, 1}); });
    ASSERT_NE(east, found.walls.end());
    EXPECT_FALSE(east->is_cut) << "the look through the doorway is wider than the niche";
    const Reach beside = reach(map, {kNearRoom, {3.5, 0.5}}, 2.5);
    const auto cut = std::find_if(beside.walls.begin(), beside.walls.end(),
                                  [&](const ReachedWall& w) { return map[w.wall].a == (Vec2{5, 1}); });
    ASSERT_NE(cut, beside.walls.end());
    EXPECT_TRUE(cut->is_cut);
    EXPECT_EQ(cut->stretch.a, (Vec2{5, 2})) << "past the door post at 4, 1";
}

TEST(Reach, EndsInARoomThatIsLinkedToItself) {
    MapFile file = map_of({box_room("loop", 0, 0, 1, 1)});
    link(file, "loop", {1, 0}, {1, 1}, "loop", {0, 1}, {0, 0});
    const Reach found = reach(built(file), {kNearRoom, {0.5, 0.5}}, 10);
    EXPECT_THAT(found.sectors, SizeIs(testing::AllOf(testing::Ge(21u), testing::Le(kMaxReachedSectors))));
}

TEST(Reach, EndsAroundATipWhereSpaceIsNarrow) {
    // The two long sides are one: a body beside the tip sees it over and over.
    MapFile file = map_of({room("wedge", {{0, 0}, {8, 0}, {8, 0.0078125}})});
    link(file, "wedge", {0, 0}, {8, 0}, "wedge", {8, 0.0078125}, {0, 0});
    const Reach found = reach(built(file), {kNearRoom, {1, 0.0009765625}}, 0.5);
    EXPECT_THAT(found.sectors, SizeIs(kMaxReachedLinks + 1));
}

TEST(Reach, FindsEveryStepOfTheFinestRamp) {
    constexpr double kStep = 0x1p-10, kRadius = 0.25;
    std::vector<SectorRecord> steps;
    for (int i = 0; i < 1024; ++i)
        steps.push_back(box_room("step " + std::to_string(i), i * kStep, 0, (i + 1) * kStep, 4));
    MapFile file = map_of(std::move(steps));
    join_all(file);
    const Reach found = reach(built(file), {SectorId(512u), {512.5 * kStep, 2}}, kRadius);
    EXPECT_THAT(found.sectors, SizeIs(static_cast<std::size_t>(2 * kRadius / kStep) + 1));
    EXPECT_THAT(found.walls, SizeIs(0));
}

TEST(Reach, LooksAcrossACornerItStandsOn) {
    MapFile file = map_of({box_room("nw", 0, 0, 2, 2), box_room("ne", 2, 0, 4, 2), box_room("sw", 0, 2, 2, 4),
                           box_room("se", 2, 2, 4, 4)});
    join_all(file);
    const Reach found = reach(built(file), {SectorId(3u), {2, 2}}, 1);
    EXPECT_THAT(found.walls, IsEmpty());
    for (std::uint32_t s = 0; s < 4; ++s) EXPECT_TRUE(overlaps(found, SectorId(s))) << s;
}

/// The most that a disc of this radius costs anywhere near the middle of a fan.
struct Cost {
    std::size_t rooms = 0, walls = 0;
};

Cost cost_near_the_middle(const Map& map, double radius, double spread) {
    Random random(1);
    Cost most;
    for (int i = 0; i < 300; ++i) {
        const Vec2 p = snap_to_point_grid(Vec2{random.uniform(-spread, spread), random.uniform(-spread, spread)});
        const Reach found = reach(map, {locate(map, p), p}, radius);
        most.rooms = std::max(most.rooms, found.sectors.size());
        most.walls = std::max(most.walls, found.walls_looked_at);
    }
    return most;
}

// Portals of parts that a look does not lead to are passed, too, so each part may be entered from many others. All the
// way round one gets back into the part that one stands in.
// hard case T15
TEST(ReachCost, InAFanOfScatteredSectorsGrowsWithItsParts) {
    for (const std::size_t sectors : {2u, 4u, 5u, 8u})
        for (const std::size_t parts : {40u, 80u, 120u}) {
            const Map map = built(fan_of_scattered_sectors(parts, sectors));
            const Cost most = cost_near_the_middle(map, 0.35, 0.4);
            const std::size_t walls_each = 3 * parts / sectors, around_corners = parts * parts;
            EXPECT_LE(most.rooms, parts + 1) << sectors << " sectors of " << parts << " parts";
            EXPECT_LE(most.walls, (parts + 1) * walls_each + around_corners);
        }
}

}  // namespace
}  // namespace enfilade
