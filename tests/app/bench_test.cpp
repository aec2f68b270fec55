// Times of frames: drawn in turn, summed up, written down.
#include "app/bench.h"

#include <gmock/gmock.h>

#include "render/frame.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::pair<std::size_t, int>> order_of(const std::vector<BenchFrame>& frames) {
    std::vector<std::pair<std::size_t, int>> order;
    for (const BenchFrame& frame : frames) order.emplace_back(frame.subject, frame.number);
    return order;
}

TEST(FramesInTurn, TakeOneOfEachSubjectUntilTheyEnd) {
    using Step = std::pair<std::size_t, int>;
    EXPECT_THAT(order_of(frames_in_turn({1, 3, 2})),
                ElementsAre(Step{0, 0}, Step{1, 0}, Step{2, 0}, Step{1, 1}, Step{2, 1}, Step{1, 2}));
    EXPECT_TRUE(frames_in_turn({}).empty());
}

/// Measures one frame that takes these times, one after the other.
BenchFrame measured(const std::vector<std::int64_t>& times_ns) {
    std::vector<BenchFrame> frames = frames_in_turn({1});
    std::size_t next = 0;
    const auto draw = [&](std::size_t, int, bool) -> Result<std::int64_t> { return times_ns[next++]; };
    EXPECT_TRUE(measure(frames, times_ns.size() - 1, draw).ok());
    return frames[0];
}

TEST(Measure, TakesTheFastestAndTheMiddleTime) {
    const BenchFrame frame = measured({5, 70, 20, 90, 30, 40});
    EXPECT_EQ(frame.minimum_ns, 20);
    EXPECT_EQ(frame.median_ns, 40);
}

TEST(Measure, DoesNotCountTheFirstTime) { EXPECT_EQ(measured({1, 7}).minimum_ns, 7); }

TEST(Measure, TellsWhichDrawingsCount) {
    std::vector<BenchFrame> frames = frames_in_turn({2});
    std::vector<bool> told;
    const auto draw = [&](std::size_t, int, bool is_counted) -> Result<std::int64_t> {
        told.push_back(is_counted);
        return std::int64_t{1};
    };
    EXPECT_TRUE(measure(frames, 2, draw).ok());
    EXPECT_THAT(told, ElementsAre(false, false, true, true, true, true));
}

TEST(Measure, EndsWithTheFirstError) {
    std::vector<BenchFrame> frames = frames_in_turn({4});
    int drawn = 0;
    const auto draw = [&](std::size_t, int, bool) -> Result<std::int64_t> {
        if (++drawn == 3) return Error{"card", "gone"};
        return std::int64_t{1};
    };
    EXPECT_EQ(measure(frames, 2, draw).error().text(), "card: gone");
    EXPECT_EQ(drawn, 3);
}

const std::vector<BenchFrame> kTimes{{0, 0, 1'000'000, 1'500'000, {.hash = 7, .pixels = 2'000'000}},
                                     {1, 0, 2'000'000, 2'000'000, {.hash = 8, .pixels = 2'000'000, .walls = 3}},
                                     {1, 1, 4'000'000, 6'000'000, {10, 2'000'000, 5, 400, 20}}};

TEST(BenchCsv, HasALineForEachFrameAndQuotesOddNames) {
    EXPECT_EQ(bench_csv({"a.toml", "b, \"c\".toml"}, kTimes),
              "subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash\n"
              "a.toml,0,1000000,1500000,0,0,0,2000000,0000000000000007\n"
              "\"b, \"\"c\"\".toml\",0,2000000,2000000,3,0,0,2000000,0000000000000008\n"
              "\"b, \"\"c\"\".toml\",1,4000000,6000000,5,400,20,2000000,000000000000000a\n");
}

TEST(BenchTable, TellsMeansTheSlowestFrameAndTheCostOfAPixel) {
    const std::string table = bench_table({"a.toml", "b.toml"}, kTimes);
    EXPECT_THAT(table, HasSubstr("a.toml       1     1.000     1.500     1.000     0    0.500 "));
    EXPECT_THAT(table,
                HasSubstr("b.toml       2     3.000     4.000     4.000     1    1.500       4      200        10"
                          "   2000000  "));
}

TEST(BenchTable, HasOneHashForAllPicturesOfASubject) {
    std::vector<BenchFrame> other = kTimes;
    other[2].counts.hash = 11;
    const std::string before = bench_table({"a", "b"}, kTimes), after = bench_table({"a", "b"}, other);
    EXPECT_EQ(before.substr(0, before.find("\nb")), after.substr(0, after.find("\nb")));
    EXPECT_NE(before, after);
}

TEST(CountsOf, TellsWallsRunsAndPixels) {
    const Map map = test::built(test::map_of({test::box_room("hall", 0, 0, 8, 6)}));
    Frame frame;
    frame.resize(2, 4);
    FrameFacts facts;
    reset(facts, 2, 4);
    const PixelSurface up = ceiling_id(SectorId(0u)), down = floor_id(SectorId(0u));
    const PixelSurface left = wall_id(map, WallId(0u), WallPart::middle),
                       right = wall_id(map, WallId(1u), WallPart::lower),
                       above = wall_id(map, WallId(1u), WallPart::upper);
    facts.ids = {up, above, left, up, left, right, down, right};
    facts.writes.assign(8, 1);
    const BenchCounts counts = counts_of(map, frame, facts);
    EXPECT_EQ(counts.walls, 2u);
    EXPECT_EQ(counts.runs, 6u);
    EXPECT_EQ(counts.pixels, 8u);
    EXPECT_EQ(counts.hash, hash_of(frame));
}

}  // namespace
}  // namespace enfilade
