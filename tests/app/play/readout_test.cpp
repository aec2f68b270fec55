// The F3 read-out.
#include "app/play/readout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace enfilade {
namespace {

TEST(FrameTimes, AreZeroBeforeThereAreTwo) {
    FrameTimes times;
    times.add(5'000'000, 0);
    EXPECT_EQ(times.summary().per_second, 0);
}

TEST(FrameTimes, GiveMeanWorstAndRate) {
    FrameTimes times;
    times.add(1'000'000, 0);
    times.add(3'000'000, 10'000'000);
    times.add(2'000'000, 20'000'000);
    const auto summary = times.summary();
    EXPECT_DOUBLE_EQ(summary.mean_draw_ms, 2);
    EXPECT_DOUBLE_EQ(summary.worst_draw_ms, 3);
    EXPECT_DOUBLE_EQ(summary.per_second, 100);
}

TEST(FrameTimes, ForgetWhatIsLongAgo) {
    FrameTimes times;
    times.add(99'000'000, 0);
    for (int i = 1; i <= 100; ++i) times.add(1'000'000, i * 1'000'000);
    EXPECT_DOUBLE_EQ(times.summary().worst_draw_ms, 1);
    EXPECT_DOUBLE_EQ(times.summary().per_second, 1000);
}

TEST(Readout, OutlinesViewports) {
    Frame frame;
    frame.resize(100, 100);
    std::ranges::fill(frame.pixels, 0xFF000000u);
    const Font font;
    Overlay overlay(frame, font);
    draw_readout(overlay, {}, {}, {{SectorId(0u), 1, 20, 22, {5, 7}, {15, 15}}});
    const auto at = [&](int x, int y) { return frame.pixels[std::size_t(y * 100 + x)]; };
    EXPECT_EQ(at(20, 5), 0xFF40FFFFu);
    EXPECT_EQ(at(21, 6), 0xFF40FFFFu);  // where the edge jumps it is joined
    EXPECT_EQ(at(21, 14), 0xFF40FFFFu);
    EXPECT_EQ(at(19, 5), 0xFF000000u);
}

}  // namespace
}  // namespace enfilade
