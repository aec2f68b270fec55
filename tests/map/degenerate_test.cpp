// Geometry that breaks maps: each case is accepted with one meaning or refused with the place, never anything else.
#include <gmock/gmock.h>

#include <algorithm>

#include "map/edge_sweep.h"
#include "map/sector_finder.h"
#include "math/angle.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The codes of all errors of a map of these rooms.
std::vector<std::string> errors_of(const MapFile& file) {
    std::vector<std::string> codes;
    for (const Finding& finding : findings_of(file))
        if (finding.severity == Severity::error) codes.push_back(finding.code);
    return codes;
}

std::vector<std::string> errors_of(SectorRecord sector) { return errors_of(map_of({std::move(sector)})); }

/// How many sectors contain the point.
int sectors_around(const Map& map, Vec2 p) {
    int count = 0;
    for (std::size_t i = 0; i < map.sectors.size(); ++i) count += is_inside(map, SectorId(i), p);
    return count;
}

// hard case T3
TEST(Rounding, OfHalfAStepDoesNotDependOnTheOrderOfTheFile) {
    // Half a step and a whole one: 0.5 rounds to 0, 1.5 to 2, in whatever sector and wherever in the loop they come.
    const double half = kVertexGrid / 2;
    const std::vector<Vec2> outline{{0, half}, {4, 3 * half}, {4, 4}, {0, 4}};
    for (std::size_t turn = 0; turn < outline.size(); ++turn) {
        std::vector<Vec2> turned = outline;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
        const Map map = built(map_of({room("a", turned), box_room("b", 10, half, 11, 3 * half)}));
        EXPECT_EQ(map.sectors[0].min.y, 0);
        EXPECT_THAT(map.walls, testing::Contains(testing::Field(&Wall::a, Vec2{4, kVertexGrid * 2})));
        EXPECT_EQ(map.sectors[1].max.y, kVertexGrid * 2);
    }
}

// hard case T2
TEST(Rounding, JoinsVerticesThatDifferByRoundingErrors) {
    MapFile file = map_of({box_room("left", 0, 0, 0.1 + 0.2, 1), box_room("right", 0.3, 0, 1, 1)});
    wall(file, "left", {0.1 + 0.2, 0}, {0.1 + 0.2, 1}).next = "right";
    EXPECT_THAT(errors_of(file), IsEmpty());
}

// hard case T11
TEST(Rounding, ComesBeforeTheChecks) {
    // As written, the spike misses the opposite wall by a ten-thousandth; on the grid it stands on it.
    EXPECT_THAT(errors_of(room("r", {{0, 0}, {8, 0}, {8, 4}, {4.0001, 0.0001}, {0, 4}})), ElementsAre("edges-touch"));
    // And the other way round: written as touching its neighbour, on the grid it is clear of it.
    EXPECT_THAT(errors_of(room("r", {{0, 0}, {8, 0}, {8, 4}, {4, 0.00049}, {0, 4}})), IsEmpty());
}

// hard case T5
TEST(Duplicates, OfAVertexAreRefusedWhereTheyStand) {
    EXPECT_THAT(errors_of(room("r", {{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}})), ElementsAre("zero-length"));
}

// hard case T5
TEST(Duplicates, OfAWallAreRefused) {
    SectorRecord twice = box_room("r", 0, 0, 4, 4);
    twice.loops.push_back(twice.loops[0]);
    EXPECT_THAT(errors_of(twice), testing::Each(std::string("edges-overlap")));
    EXPECT_THAT(errors_of(twice), testing::SizeIs(4));
}

// hard cases T3, T6
TEST(Gap, OfOneGridStepBetweenRoomsIsNamed) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4 + kVertexGrid, 0, 8, 4)});
    wall(file, "left", {4, 0}, {4, 4}).next = "right";
    EXPECT_THAT(text_of(findings_of(file)),
                HasSubstr("expected an edge (4, 4)-(4, 0) in sector 'right', which this portal leads into, found none; "
                          "its nearest edge is (4.001, 4)-(4.001, 0)"));
}

// hard case T7
TEST(Winding, IsDecidedByGeometryNotByNames) {
    SectorRecord r = box_room("r", 0, 0, 8, 8);
    cut_pillar(r, 2, 2, 4, 4);
    r.loops[0].name = "inner";
    r.loops[1].name = "border";
    std::swap(r.loops[0], r.loops[1]);
    EXPECT_THAT(errors_of(r), IsEmpty());
}

// hard case T7
TEST(Winding, OfALoopInsideAHoleIsAnOutlinesAgain) {
    SectorRecord r = box_room("r", 0, 0, 8, 8);
    cut_pillar(r, 1, 1, 7, 7);
    r.loops.push_back(loop_of({{2, 2}, {6, 2}, {6, 6}, {2, 6}}));
    const Map map = built(map_of({r}));
    EXPECT_EQ(sectors_around(map, {4, 4}), 1);
    EXPECT_EQ(sectors_around(map, {1.5, 1.5}), 0);
}

// hard case T7
TEST(Winding, OfEachWrongLoopIsReportedOnItsOwn) {
    SectorRecord r = room("r", {{0, 0}, {0, 8}, {8, 8}, {8, 0}});      // an outline the wrong way round,
    r.loops.push_back(loop_of({{2, 2}, {3, 2}, {3, 3}, {2, 3}}));      // a wrong hole in it,
    cut_pillar(r, 5, 5, 6, 6);                                         // a right one,
    r.loops.push_back(loop_of({{20, 0}, {21, 0}, {21, 1}, {20, 1}}));  // a right outline beside it
    EXPECT_THAT(errors_of(r), ElementsAre("hole-outside", "wrong-winding"));
}

TEST(Winding, OfAnOutlineIsTheOutlinesFaultWhenItsHoleIsWrongToo) {
    SectorRecord r = room("r", {{0, 0}, {0, 8}, {8, 8}, {8, 0}});
    r.loops.push_back(loop_of({{2, 2}, {3, 2}, {3, 3}, {2, 3}}));
    EXPECT_THAT(errors_of(r), ElementsAre("wrong-winding", "wrong-winding"));
}

// hard case T7
TEST(BowTie, NamesTheCrossingAsAFraction) {
    const auto findings = findings_of(map_of({room("r", {{0, 0}, {4, 6}, {4, 0}, {0, 3}})}));
    EXPECT_THAT(text_of(findings), HasSubstr("edges (0, 0)-(4, 6) and (4, 0)-(0, 3) of sector 'r' cross at "
                                             "(4/3, 2), about (1.333, 2)"));
}

TEST(CrossingText, IsADecimalWhereItCan) {
    EXPECT_EQ(crossing_text({0, 0}, {4, 4}, {0, 4}, {4, 0}), "(2, 2)");
    EXPECT_EQ(crossing_text({0, 0}, {4, -1}, {2, -4}, {2, 4}), "(2, -0.5)");
}

// hard case T10
TEST(CrossingText, ReducesItsFractions) {
    EXPECT_EQ(crossing_text({0, 0}, {-3, -3}, {-3, 0}, {0, -1.5}), "(-1, -1)");
    EXPECT_EQ(crossing_text({0, 0}, {-6, -3}, {-3, 0}, {0, -3}), "(-2, -1)");
    EXPECT_EQ(crossing_text({0, 0}, {-3, -1}, {-3, 0}, {0, -1}), "(-1.5, -0.5)");
    EXPECT_EQ(crossing_text({0, 0}, {-1, -1}, {-1, 0}, {0.5, -0.75}), "(-1/3, -1/3), about (-0.333, -0.333)");
}

// hard case T10
TEST(CrossingText, HoldsTheWholeWorld) {
    const double far = kWorldLimit, step = kVertexGrid;
    // Two diagonals, one a step off at one end: they cross nearly a quarter of a step off the middle.
    EXPECT_EQ(crossing_text({-far, -far}, {far, far}, {-far, far - step}, {far, -far}),
              "(-32768/134217727, -32768/134217727), about (0, 0)");
}

// hard case T8
TEST(Pinch, OfTwoSectorsLeavesEveryPointInAtMostOne) {
    const Map map = built(map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 4, 8, 8)}));
    EXPECT_EQ(sectors_around(map, {4, 4}), 1);
    EXPECT_EQ(sectors_around(map, {2, 2}), 1);
    EXPECT_EQ(sectors_around(map, {6, 2}), 0);
}

// hard case T8
TEST(Pinch, OfOneSectorIsLegal) {
    SectorRecord r = box_room("r", 0, 0, 4, 4);
    r.loops.push_back(loop_of({{4, 4}, {8, 4}, {8, 8}, {4, 8}}));
    r.loops.push_back(loop_of({{0, 0}, {1, 2}, {2, 1}}));  // a hole that touches the corner
    const Map map = built(map_of({r}));
    EXPECT_EQ(sectors_around(map, {4, 4}), 1);
    EXPECT_EQ(sectors_around(map, {1, 1}), 0);
}

// hard case T9
TEST(Overlap, OfHalfAWallLeavesAPortalWithoutATwin) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 2, 8, 6)});
    wall(file, "left", {4, 0}, {4, 4}).next = "right";
    EXPECT_THAT(errors_of(file), ElementsAre("missing-twin"));
}

// hard case T9
TEST(Overlap, OfALongerWallWillDoInTheTutorialDialect) {
    MapFile file = map_of({box_room("left", 0, 1, 4, 3), box_room("right", 4, 0, 8, 4)});
    wall(file, "left", {4, 1}, {4, 3}).next = "right";
    EXPECT_THAT(errors_of(file), ElementsAre("missing-twin"));
    file.format = 0;
    const Map map = built(file);
    EXPECT_EQ(map[map.walls[1].exit].a, (Vec2{4, 4}));
}

TEST(Overlap, OfSectorsIsLegal) {
    EXPECT_THAT(errors_of(map_of({box_room("a", 0, 0, 4, 4), box_room("b", 1, 1, 5, 5), box_room("c", 0, 0, 4, 4)})),
                IsEmpty());
}

// hard case T14
TEST(Circle, OfSixteenRoundedVerticesClosesAndJoins) {
    // As an editor writes it: 16 decimals of cos and sin, once from above and once from below.
    std::vector<Vec2> around;
    for (std::uint32_t i = 0; i < 16; ++i) around.push_back(direction(Angle{i << 28}) * 5.3);
    std::vector<Vec2> hole(around.rbegin(), around.rend());
    for (Vec2& v : hole) v = {v.x + 1e-15, v.y - 1e-15};
    SectorRecord court = box_room("court", -10, -10, 10, 10);
    court.loops.push_back(loop_of(hole));
    MapFile file = map_of({court, room("well", around)});
    for (WallRecord& w : file.sectors[0].loops[1].walls) w.next = "well";
    for (WallRecord& w : file.sectors[1].loops[0].walls) w.next = "court";
    EXPECT_THAT(errors_of(file), IsEmpty());
}

// hard case T16
TEST(EmptyMap, IsRefused) { EXPECT_THAT(errors_of(map_of({})), ElementsAre("no-sectors")); }

// hard case T16
TEST(EmptyLoop, AndTheLoopOfTwoAreRefused) {
    EXPECT_THAT(errors_of(room("r", {})), ElementsAre("too-few-vertices"));
    EXPECT_THAT(errors_of(room("r", {{0, 0}, {4, 0}})), ElementsAre("too-few-vertices"));
}

// hard case T16
TEST(SectorWithoutLoops, IsRefused) {
    SectorRecord nowhere;
    nowhere.name = "nowhere";
    EXPECT_THAT(errors_of(map_of({box_room("r", 0, 0, 4, 4), nowhere})), ElementsAre("missing-key"));
}

TEST(EmptyLoop, DoesNotHideOtherFindings) {
    SectorRecord r = box_room("r", 0, 0, 4, 4, 1, 0);
    r.loops.push_back(loop_of({{1, 1}}));
    EXPECT_THAT(errors_of(map_of({r, room("turned", {{0, 0}, {0, 4}, {4, 4}})})),
                ElementsAre("too-few-vertices", "ceiling-below-floor", "wrong-winding"));
}

// hard case R17
TEST(Sliver, NarrowerThanTheGridIsRefused) {
    EXPECT_THAT(errors_of(box_room("r", 0, 0, 1e-6, 4)), testing::Contains(std::string("zero-length")));
}

// hard case R17
TEST(Sliver, OfOneGridStepIsARoomLikeAnyOther) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("sliver", 4, 0, 4 + kVertexGrid, 4),
                           box_room("right", 4 + kVertexGrid, 0, 8, 4)});
    join_all(file);
    const Map map = built(file);
    EXPECT_TRUE(is_inside(map, SectorId(1u), {4 + kVertexGrid / 2, 2}));
    EXPECT_EQ(map[map.walls[1].exit].sector, SectorId(1u));
}

TEST(Inside, OfASharedEdgeBelongsToOneSide) {
    const Map map = built(map_of(
        {box_room("a", 0, 0, 4, 4), box_room("b", 4, 0, 8, 4), box_room("c", 0, 4, 4, 8), box_room("d", 4, 4, 8, 8)}));
    for (const double y : {0.0, 1.0, 4.0, 7.0}) EXPECT_EQ(sectors_around(map, {4, y}), 1) << y;
    for (const double x : {0.0, 1.0, 4.0, 7.0}) EXPECT_EQ(sectors_around(map, {x, 4}), 1) << x;
}

TEST(Inside, OfTheHubOfAFanBelongsToOneSector) {
    std::vector<SectorRecord> fan;
    for (std::uint32_t i = 0; i < 16; ++i)
        fan.push_back(room("s" + std::to_string(i),
                           {{0, 0}, direction(Angle{i << 28}) * 8, direction(Angle{(i + 1) << 28}) * 8}));
    const Map map = built(map_of(std::move(fan)));
    EXPECT_EQ(sectors_around(map, {0, 0}), 1);
    for (std::uint32_t i = 0; i < 16; ++i) {
        const Vec2 spoke = map.walls[3 * i].b;
        EXPECT_EQ(sectors_around(map, {spoke.x / 2, spoke.y / 2}), 1) << i;
    }
}

}  // namespace
}  // namespace enfilade
