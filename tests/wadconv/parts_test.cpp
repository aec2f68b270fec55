// Outlines, holes and islands put together; deep water; sectors that do not close.
#include "wadconv/parts.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

struct Made {
    Report report;
    Result<Parts> parts;

    explicit Made(const Level& level)
        : parts(make_parts(collect_edges(level.map, report), level.map.sectors.size(), report)) {}

    /// "name: area, loops" of each part.
    std::vector<std::string> texts() const {
        std::vector<std::string> texts;
        for (const Part& part : parts.value().parts)
            texts.push_back(part_name(part) + ": " + std::to_string(double_area(part) / 2) + ", " +
                            std::to_string(part.loops.size()));
        return texts;
    }

    std::string at(int x, int y) const {
        const std::uint32_t part = part_at(parts.value(), to_fine({x, -y}));
        return part == kNone ? "" : part_name(parts.value().parts[part]);
    }
};

Level level_with(int sectors) {
    Level level;
    for (int i = 0; i < sectors; ++i) level.sector();
    return level;
}

TEST(PartName, CountsFurtherPartsByLetters) {
    Part part;
    part.sector = 12;
    std::vector<std::string> names;
    for (std::uint32_t number : {0u, 1u, 25u, 26u, 27u, 701u, 702u}) {
        part.number = number;
        names.push_back(part_name(part));
    }
    EXPECT_THAT(names, ElementsAre("s12", "s12b", "s12z", "s12aa", "s12ab", "s12zz", "s12aaa"));
}

// hard case W6
TEST(MakeParts, GivesHolesToTheOutlineAroundThem) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.box(128, 0, 192, 64, 0);
    level.ring({{140, 16}, {150, 16}, {150, 26}, {140, 26}}, 0);
    EXPECT_THAT(Made(level).texts(), ElementsAre("s0: 4096, 1", "s0b: 3996, 2"));
}

TEST(MakeParts, GivesAHoleToTheSmallestOfNestedOutlines) {
    Level level = level_with(2);
    level.box(0, 0, 100, 100, 0);
    level.box(10, 10, 90, 90, 1, 0);
    level.box(20, 20, 80, 80, 0, 1);
    level.ring({{30, 30}, {40, 30}, {40, 40}, {30, 40}}, 0);
    EXPECT_THAT(Made(level).texts(), ElementsAre("s0: 3600, 2", "s0b: 3500, 2", "s1: 2800, 2"));
}

TEST(MakeParts, PartsTheInsideOfARingOfOneSector) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.box(16, 16, 32, 32, 0, 0);
    const Made made(level);
    EXPECT_THAT(made.texts(), ElementsAre("s0: 3840, 2", "s0b: 256, 1"));
    EXPECT_EQ(made.at(24, 24), "s0b");
}

// Deep water: the ring around the pool has the pool's own sector on both sides, so that nothing is drawn there.
// hard case W2
TEST(MakeParts, GivesTheOutsideOfADeepWaterRingToTheSectorAround) {
    Level level = level_with(2);
    level.box(0, 0, 64, 64, 0);
    level.box(16, 16, 32, 32, 1, 1);
    const Made made(level);
    EXPECT_THAT(made.texts(), ElementsAre("s0: 3840, 2", "s1: 256, 1"));
    EXPECT_EQ(made.at(24, 24), "s1");
    EXPECT_EQ(made.at(8, 8), "s0");
    EXPECT_EQ(made.report.found.at(Kind::deep_water).size(), 4u);
}

// hard case W2
TEST(MakeParts, FindsTheInnermostSectorAroundDeepWater) {
    Level level = level_with(3);
    level.box(0, 0, 100, 100, 0);
    level.box(10, 10, 90, 90, 1, 0);
    level.box(20, 20, 30, 30, 2, 2);
    EXPECT_THAT(Made(level).texts(), ElementsAre("s0: 3600, 2", "s1: 6300, 2", "s2: 100, 1"));
}

// hard case W2
TEST(MakeParts, RefusesADeepWaterRingInTheVoid) {
    Level level = level_with(2);
    level.box(0, 0, 64, 64, 0);
    level.box(100, 100, 120, 120, 1, 1);
    EXPECT_THAT(Made(level).parts.error().what, HasSubstr("sector 1 is inside out"));
}

TEST(MakeParts, RefusesASectorThatIsInsideOut) {
    Level level = level_with(1);
    level.ring({{0, 0}, {64, 0}, {64, 64}, {0, 64}}, 0);
    EXPECT_THAT(Made(level).parts.error().what, HasSubstr("inside out"));
}

// hard case W5
TEST(MakeParts, ClosesAGapOfOneLine) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.map.lines.erase(level.map.lines.begin() + 1);
    const Made made(level);
    EXPECT_THAT(made.texts(), ElementsAre("s0: 4096, 1"));
    const Edge added = made.parts.value().edges.back();
    EXPECT_EQ(added.line, kNone);
    EXPECT_EQ(added.a, (Point{0, -64}));
    EXPECT_EQ(added.b, (Point{64, -64}));
    EXPECT_EQ(made.report.count(Fate::guessed), 1u);
}

// hard case W5
TEST(MakeParts, RefusesASectorWithTwoGaps) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.map.lines.erase(level.map.lines.begin() + 2);
    level.map.lines.erase(level.map.lines.begin());
    EXPECT_THAT(Made(level).parts.error().what, HasSubstr("sector 0 is not closed"));
}

/// A room of four walls, and behind its doorway, line 4, another one around these corners.
Level room_and(const std::vector<Vertex>& corners) {
    Level level = level_with(2);
    level.line({64, 0}, {0, 0}, 0);
    level.line({0, 0}, {0, 64}, 0);
    level.line({0, 64}, {32, 64}, 0);
    level.line({32, 64}, {64, 64}, 0);
    level.line({64, 64}, {64, 0}, 0, 1);
    level.line({64, 64}, corners[0], 1);
    for (std::size_t i = 1; i < corners.size(); ++i) level.line(corners[i - 1], corners[i], 1);
    level.line(corners.back(), {64, 0}, 1);
    return level;
}

TEST(MakeParts, LeavesOutARoomWhoseLinesCross) {
    // More of it the right way round, more of it inside out, as much of both, and lines on each other.
    for (const std::vector<Vertex>& corners : {std::vector<Vertex>{{128, 0}, {160, 96}},
                                               {{160, -32}, {128, 64}},
                                               {{128, 0}, {128, 64}},
                                               {{128, 64}, {96, 64}, {128, 0}}}) {
        const Made made(room_and(corners));
        ASSERT_TRUE(made.parts.ok()) << made.parts.error().what;
        EXPECT_THAT(made.texts(), ElementsAre("s0: 4096, 1"));
        EXPECT_THAT(made.parts.value().lost, ElementsAre(1u));
        EXPECT_THAT(made.report.found.at(Kind::lost_room), ElementsAre(1u));
        EXPECT_THAT(made.report.found.at(Kind::closed_doorway), ElementsAre(4u));
        EXPECT_GE(made.report.found.at(Kind::clashing_line).size(), 2u);
        for (const Edge& edge : made.parts.value().edges) EXPECT_FALSE(edge.is_open);
    }
}

TEST(MakeParts, LeavesOutOnlyThePartWhoseLinesCross) {
    Level level = level_with(2);
    level.box(0, 0, 64, 64, 0);
    level.box(200, 0, 264, 64, 0);
    level.box(232, 32, 300, 48, 1, 0);  // a hole that reaches out of its room
    const Made made(level);
    EXPECT_THAT(made.texts(), ElementsAre("s0: 4096, 1", "s1: 1088, 1"));
    EXPECT_THAT(made.report.found.at(Kind::clashing_line), ElementsAre(6u, 9u, 11u));
    EXPECT_THAT(made.report.found.at(Kind::closed_doorway), ::testing::UnorderedElementsAre(8u, 9u, 10u, 11u));
}

TEST(MakeParts, KeepsRoomsThatOverlapOthers) {
    Level level = level_with(2);
    level.box(0, 0, 64, 64, 0);
    level.box(32, 32, 96, 96, 1);
    const Made made(level);
    EXPECT_THAT(made.texts(), ElementsAre("s0: 4096, 1", "s1: 4096, 1"));
    EXPECT_THAT(made.report.found, IsEmpty());
}

TEST(MakeParts, SetsLoneEdgesAside) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.line({16, 16}, {32, 16}, 0, 0);
    const Parts parts = Made(level).parts.value();
    EXPECT_THAT(parts.lone, ElementsAre(4u, 5u));
    EXPECT_EQ(parts.part_of_edge[4], kNone);
}

TEST(MakeParts, NotesSectorsThatNoLineMentions) {
    Level level = level_with(2);
    level.box(0, 0, 64, 64, 1);
    const Made made(level);
    EXPECT_THAT(made.report.found.at(Kind::unused_sector), ElementsAre(0u));
    EXPECT_THAT(made.texts(), ElementsAre("s1: 4096, 1"));
}

TEST(PartAt, PutsEveryPointInExactlyOnePart) {
    Level level = level_with(2);
    level.line({0, 0}, {0, 64}, 0);
    level.line({0, 64}, {64, 64}, 0);
    level.line({64, 64}, {64, 0}, 0, 1);
    level.line({64, 0}, {0, 0}, 0);
    level.line({64, 64}, {128, 64}, 1);
    level.line({128, 64}, {128, 0}, 1);
    level.line({128, 0}, {64, 0}, 1);
    const Made made(level);
    // The tie rule moves a point right and, less far, down: y is up here.
    EXPECT_EQ(made.at(64, 32), "s1");
    EXPECT_EQ(made.at(0, 32), "s0");
    EXPECT_EQ(made.at(128, 32), "");
    EXPECT_EQ(made.at(32, 64), "s0");
    EXPECT_EQ(made.at(32, 0), "");
    EXPECT_EQ(made.at(64, 64), "s1");
}

TEST(PartAt, LeavesHolesOut) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    level.ring({{16, 16}, {32, 16}, {32, 32}, {16, 32}}, 0);
    EXPECT_EQ(Made(level).at(20, 20), "");
}

TEST(MakeParts, HasNothingToSayAboutASoundMap) {
    Level level = level_with(1);
    level.box(0, 0, 64, 64, 0);
    EXPECT_THAT(Made(level).report.found, IsEmpty());
    EXPECT_THAT(Made(level).parts.value().parts, SizeIs(1));
}

}  // namespace
}  // namespace enfilade::wadconv
