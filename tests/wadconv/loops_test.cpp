// Tracing a sector's edges: outlines, holes, pinches, lone edges, open ends.
#include "wadconv/parts.h"

#include <gmock/gmock.h>

#include <numeric>

#include "base/hash.h"
#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Everything that belongs to sector 0, traced.
struct Traced {
    std::vector<Edge> edges;
    Tracing tracing;

    explicit Traced(const Level& level) {
        Report report;
        edges = collect_edges(level.map, report);
        std::vector<std::uint32_t> own;
        for (std::uint32_t e = 0; e < edges.size(); ++e)
            if (edges[e].sector == 0) own.push_back(e);
        tracing = trace_loops(edges, own);
    }

    /// Areas in map units, rising.
    std::vector<std::int64_t> areas() const {
        std::vector<std::int64_t> areas;
        for (const Loop& loop : tracing.loops) areas.push_back(loop.double_area / 2);
        std::ranges::sort(areas);
        return areas;
    }
};

Level empty_level() {
    Level level;
    level.sector();
    level.sector();
    return level;
}

TEST(TraceLoops, MakesAnOutlineOfARoom) {
    Level level = empty_level();
    level.box(0, 0, 64, 32, 0);
    EXPECT_THAT(Traced(level).areas(), ElementsAre(64 * 32));
}

TEST(TraceLoops, MakesAHoleOfAPillar) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.ring({{16, 16}, {32, 16}, {32, 32}, {16, 32}}, 0);
    EXPECT_THAT(Traced(level).areas(), ElementsAre(-16 * 16, 64 * 64));
}

TEST(TraceLoops, FollowsEachLoopFromPointToPoint) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.ring({{0, 0}, {32, 16}, {16, 32}}, 0);  // a pillar in the corner, touching the outline
    const Traced t(level);
    for (const Loop& loop : t.tracing.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i)
            EXPECT_EQ(t.edges[loop.edges[i]].b, t.edges[loop.edges[(i + 1) % loop.edges.size()]].a);
}

TEST(TraceLoops, PartsRoomsThatTouchInAPoint) {
    Level level = empty_level();
    level.box(0, 0, 32, 32, 0);
    level.box(32, 32, 64, 64, 0);
    EXPECT_THAT(Traced(level).areas(), ElementsAre(32 * 32, 32 * 32));
}

TEST(TraceLoops, CutsAHoleLooseThatTouchesTheOutline) {
    Level level = empty_level();
    level.ring({{0, 0}, {0, 64}, {64, 64}, {64, 0}}, 0);
    level.ring({{64, 64}, {32, 48}, {48, 32}}, 0);
    const Traced t(level);
    EXPECT_THAT(t.tracing.loops, SizeIs(2));
    EXPECT_LT(t.areas()[0], 0);
    EXPECT_EQ(t.areas()[1], 64 * 64);
}

TEST(TraceLoops, CutsHolesLooseThatTouchEachOther) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.ring({{8, 8}, {16, 8}, {16, 16}, {8, 16}}, 0);
    level.ring({{16, 16}, {24, 16}, {24, 24}, {16, 24}}, 0);
    EXPECT_THAT(Traced(level).areas(), ElementsAre(-64, -64, 64 * 64));
}

TEST(TraceLoops, TakesOutALineThatSeparatesNothing) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.line({16, 16}, {32, 16}, 0, 0);
    level.line({32, 16}, {32, 32}, 0, 0);
    const Traced t(level);
    EXPECT_THAT(t.areas(), ElementsAre(64 * 64));
    EXPECT_THAT(t.tracing.lone, ElementsAre(4u, 5u, 6u, 7u));
}

TEST(TraceLoops, TakesOutABridgeFromTheOutlineToAHole) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.ring({{16, 16}, {32, 16}, {32, 32}, {16, 32}}, 0);
    level.line({0, 0}, {16, 16}, 0, 0);
    const Traced t(level);
    EXPECT_THAT(t.areas(), ElementsAre(-16 * 16, 64 * 64));
    EXPECT_THAT(t.tracing.lone, SizeIs(2));
}

TEST(TraceLoops, PartsARoomAlongALineAcrossIt) {
    Level level = empty_level();
    level.ring({{0, 0}, {0, 64}, {32, 64}, {64, 64}, {64, 0}, {32, 0}}, 0);
    level.line({32, 64}, {32, 0}, 0, 0);
    const Traced t(level);
    EXPECT_THAT(t.areas(), ElementsAre(32 * 64, 32 * 64));
    EXPECT_THAT(t.tracing.lone, IsEmpty());
}

// hard case W2
TEST(TraceLoops, GivesARingOfLinesWithOneSectorAnInsideAndAnOutside) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.box(16, 16, 32, 32, 0, 0);
    EXPECT_THAT(Traced(level).areas(), ElementsAre(-256, 256, 64 * 64));
}

TEST(TraceLoops, SaysWhereASectorIsOpen) {
    Level level = empty_level();
    level.box(0, 0, 64, 64, 0);
    level.map.lines.pop_back();
    const Tracing tracing = Traced(level).tracing;
    EXPECT_THAT(tracing.loops, IsEmpty());
    ASSERT_THAT(tracing.open_ends, SizeIs(2));
    EXPECT_EQ(tracing.open_ends[0].point, (Point{0, 0}));
    EXPECT_EQ(tracing.open_ends[0].surplus, 1);
    EXPECT_EQ(tracing.open_ends[1].surplus, -1);
}

TEST(TraceLoops, HasNothingToDoWithoutEdges) { EXPECT_THAT(Traced(empty_level()).tracing.loops, IsEmpty()); }

TEST(TraceLoops, KeepsTheAreaWhateverTheEdges) {
    // Rooms of a chequered floor, chosen at random: neighbours merge, corners pinch, courts become holes.
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        Random random(trial);
        Level level = empty_level();
        std::int64_t area = 0;
        bool is_room[8][8];
        for (auto& column : is_room)
            for (bool& cell : column) area += cell = random.below(2) == 0;
        const auto room = [&](int x, int y) { return x >= 0 && y >= 0 && x < 8 && y < 8 && is_room[x][y]; };
        const auto at = [](int x, int y) { return Vertex{std::int16_t(x), std::int16_t(y)}; };
        for (int x = 0; x <= 8; ++x)
            for (int y = 0; y <= 8; ++y) {
                if (room(x, y) && !room(x - 1, y)) level.line(at(x, y), at(x, y + 1), 0);
                if (!room(x, y) && room(x - 1, y)) level.line(at(x, y + 1), at(x, y), 0);
                if (room(x, y) && !room(x, y - 1)) level.line(at(x + 1, y), at(x, y), 0);
                if (!room(x, y) && room(x, y - 1)) level.line(at(x, y), at(x + 1, y), 0);
            }
        const Traced t(level);
        std::int64_t traced = 0;
        for (const Loop& loop : t.tracing.loops) traced += loop.double_area;
        EXPECT_EQ(traced, 2 * area) << "trial " << trial;
    }
}

}  // namespace
}  // namespace enfilade::wadconv
