// Lines as directed edges, and the repairs on the way.
#include "wadconv/parts.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The edges of a map with what was noted on the way.
struct Collected {
    Report report;
    std::vector<Edge> edges;

    explicit Collected(const DoomMap& map) : edges(collect_edges(map, report)) {}

    std::vector<std::uint32_t> noted(Kind kind) const {
        const auto found = report.found.find(kind);
        return found == report.found.end() ? std::vector<std::uint32_t>{} : found->second;
    }
};

/// Two rooms, 0 and 1, that share the line (64, 0) -> (64, 64), which is line 2.
Level two_rooms() {
    Level level;
    for (int i = 0; i < 2; ++i) level.sector();
    level.line({0, 0}, {0, 64}, 0);
    level.line({0, 64}, {64, 64}, 0);
    level.line({64, 64}, {64, 0}, 0, 1);
    level.line({64, 0}, {0, 0}, 0);
    level.ring({{64, 64}, {128, 64}, {128, 0}, {64, 0}}, 1);
    level.map.lines.pop_back();  // the one from (64, 0) to (64, 64)
    return level;
}

TEST(CollectEdges, TurnsTheYAxisDown) {
    Level level;
    level.sector();
    level.line({1, 2}, {3, -4}, 0);
    const Edge edge = Collected(level.map).edges[0];
    EXPECT_EQ(edge.a, (Point{1, -2}));
    EXPECT_EQ(edge.b, (Point{3, 4}));
}

TEST(CollectEdges, HoldsTheLowestCoordinateTurned) {
    Level level;
    level.sector();
    level.line({-32768, -32768}, {0, 0}, 0);
    EXPECT_EQ(Collected(level.map).edges[0].a, (Point{-32768, 32768}));
}

TEST(CollectEdges, RunsLeftSidesFromTheLinesEndToItsStart) {
    const Collected c(two_rooms().map);
    const Edge &right = c.edges[2], &left = c.edges[3];
    EXPECT_EQ(right.sector, 0u);
    EXPECT_EQ(left.sector, 1u);
    EXPECT_TRUE(left.is_left);
    EXPECT_EQ(left.a, right.b);
    EXPECT_EQ(left.b, right.a);
    EXPECT_EQ(right.opposite, 3u);
    EXPECT_EQ(left.opposite, 2u);
    EXPECT_TRUE(right.is_open);
}

TEST(CollectEdges, CountsEverySideOnce) {
    Collected c(two_rooms().map);
    c.report.sides.walls = c.edges.size();
    EXPECT_EQ(c.report.sides.referred, 8u);
    EXPECT_TRUE(c.report.sides.is_complete());
}

// hard case W7
TEST(CollectEdges, LeavesOutLinesWithoutLength) {
    Level level = two_rooms();
    level.line({5, 5}, {5, 5}, 0, 1);
    const Collected c(level.map);
    EXPECT_EQ(c.edges.size(), 8u);
    EXPECT_THAT(c.noted(Kind::zero_length_line), ElementsAre(7u));
    EXPECT_EQ(c.report.sides.dropped, 2u);
}

TEST(CollectEdges, LeavesOutLinesWithVerticesThatAreNotThere) {
    Level level = two_rooms();
    level.map.lines[0].end = 60000;
    const Collected c(level.map);
    EXPECT_EQ(c.edges.size(), 7u);
    EXPECT_THAT(c.noted(Kind::bad_vertex), ElementsAre(0u));
}

// hard case W5
TEST(CollectEdges, CountsSidesThatAreNotThereAsNone) {
    Level level = two_rooms();
    level.map.lines[2].left = 60000;
    const Collected c(level.map);
    EXPECT_EQ(c.edges.size(), 7u);
    EXPECT_FALSE(c.edges[2].is_open);
    EXPECT_THAT(c.noted(Kind::bad_side), ElementsAre(2u));
    EXPECT_EQ(c.report.sides.dropped, 1u);
}

// hard case W5
TEST(CollectEdges, CountsSidesOfSectorsThatAreNotThereAsNone) {
    Level level = two_rooms();
    level.map.sides[0].sector = 2;
    const Collected c(level.map);
    EXPECT_EQ(c.edges.size(), 7u);
    EXPECT_THAT(c.noted(Kind::bad_sector), ElementsAre(0u));
}

// hard case W5
TEST(CollectEdges, KeepsALineWithALeftSideOnly) {
    Level level;
    level.sector();
    level.line({0, 0}, {8, 0}, -1, 0);
    const Collected c(level.map);
    EXPECT_EQ(c.edges[0].a, (Point{8, 0}));
    EXPECT_THAT(c.noted(Kind::left_side_only), ElementsAre(0u));
}

TEST(CollectEdges, MakesTwoSidesSolidThatAreNotMarked) {
    Level level = two_rooms();
    level.map.lines[2].flags = 0;
    const Collected c(level.map);
    EXPECT_FALSE(c.edges[2].is_open);
    EXPECT_EQ(c.edges[2].opposite, 3u);
    EXPECT_THAT(c.noted(Kind::two_sides_unmarked), ElementsAre(2u));
}

// hard case W7
TEST(CollectEdges, KeepsTheFirstOfLinesDrawnTwice) {
    Level level = two_rooms();
    level.line({64, 64}, {64, 0}, 0, 1);
    const Collected c(level.map);
    EXPECT_EQ(c.edges.size(), 8u);
    EXPECT_THAT(c.noted(Kind::doubled_line), ElementsAre(7u, 7u));
    EXPECT_EQ(c.report.sides.doubled, 2u);
}

// hard case W7
TEST(CollectEdges, KeepsTheFirstOfLinesDrawnBackToFront) {
    Level level = two_rooms();
    level.line({64, 0}, {64, 64}, 1, 0);
    EXPECT_EQ(Collected(level.map).edges.size(), 8u);
}

// Freedoom E3M6 has sector 110 between two lines with the same ends.
TEST(CollectEdges, JoinsTheOuterSidesOfASliver) {
    Level level;
    for (int i = 0; i < 3; ++i) level.sector();
    level.line({0, 0}, {0, 64}, 0, 2);
    level.line({0, 64}, {0, 0}, 1, 2);
    const Collected c(level.map);
    ASSERT_EQ(c.edges.size(), 2u);
    EXPECT_EQ(c.edges[0].sector, 0u);
    EXPECT_EQ(c.edges[1].sector, 1u);
    EXPECT_EQ(c.edges[0].opposite, 1u);
    EXPECT_TRUE(c.edges[0].is_open);
}

// hard case W7
TEST(CollectEdges, NeverHasTwoEdgesFromOnePointToAnother) {
    Level level;
    for (int i = 0; i < 3; ++i) level.sector();
    for (int i = 0; i < 200; ++i) level.line({0, 0}, {0, 64}, i % 3, (i + 1) % 3);
    EXPECT_EQ(Collected(level.map).edges.size(), 2u);
}

// hard case W5
TEST(CollectEdges, NotesSidesThatSeveralLinesShare) {
    Level level = two_rooms();
    level.map.lines[1].right = level.map.lines[0].right;
    EXPECT_THAT(Collected(level.map).noted(Kind::shared_side), ElementsAre(0u));
}

TEST(CollectEdges, NotesNothingInASoundMap) { EXPECT_THAT(Collected(two_rooms().map).report.found, IsEmpty()); }

}  // namespace
}  // namespace enfilade::wadconv
