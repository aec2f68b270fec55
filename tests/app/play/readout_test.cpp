// What the player is told: the F3 read-out, messages on the screen, the end of a map.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/play/readout.h"
#include "support/map_builder.h"

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

// Messages on the screen.

constexpr Color kBlack = 0xFF000000;

class NoticesOnBlack : public ::testing::Test {
protected:
    /// Whether anything is shown at that moment.
    bool shown(double now_s, bool with_panel = true) {
        frame_.resize(200, 100);
        std::ranges::fill(frame_.pixels, kBlack);
        Overlay overlay(frame_, font_);
        notices_.draw(overlay, now_s, with_panel);
        return std::ranges::any_of(frame_.pixels, [](Color color) { return color != kBlack; });
    }

    Notices notices_;
    Frame frame_;
    Font font_;
};

TEST_F(NoticesOnBlack, ShowNothingWhereNothingWasSaid) { EXPECT_FALSE(shown(0)); }

TEST_F(NoticesOnBlack, VanishAfterTheirTime) {
    notices_.say("saved", 10, 3);
    EXPECT_TRUE(shown(12.9));
    EXPECT_FALSE(shown(13));
}

TEST_F(NoticesOnBlack, GoOnInTheNextLineWhereTheyAreLong) {
    notices_.say("saved", 0);
    shown(1);
    const Frame one_line = frame_;
    notices_ = {};
    notices_.say("this has more letters than the picture has room for in one line", 0);
    shown(1);
    const auto lit_below = [](const Frame& frame) {
        const auto below = frame.pixels.begin() + 3 * Font::kHeight / 2 * frame.width;
        return std::any_of(below, frame.pixels.end(), [](Color color) { return color != kBlack; });
    };
    EXPECT_FALSE(lit_below(one_line));
    EXPECT_TRUE(lit_below(frame_));
}

TEST_F(NoticesOnBlack, StayWhilePinned) {
    notices_.pin({"map.toml:3:1: error: something"});
    EXPECT_TRUE(shown(1e6));
    notices_.pin({});
    EXPECT_FALSE(shown(1e6));
}

TEST_F(NoticesOnBlack, LeaveTheirPanelOutWhereSomethingCoversIt) {
    notices_.pin({"map.toml:3:1: error: no"});
    EXPECT_TRUE(shown(0));
    EXPECT_FALSE(shown(0, false));
}

TEST_F(NoticesOnBlack, WrapLongLinesAndSurviveWordsThatAreTooLong) {
    notices_.pin({std::string(500, 'x'), "a " + std::string(300, 'y') + " b"});
    EXPECT_TRUE(shown(0));
}

TEST(Notices, ReplaceWhatIsOldNewsAboutTheSame) {
    const auto rows = [](Notices& notices) {
        Frame frame;
        frame.resize(200, 100);
        std::ranges::fill(frame.pixels, 0xFF000000u);
        const Font font;
        Overlay overlay(frame, font);
        notices.draw(overlay, 1);
        std::size_t last = 0;
        for (std::size_t i = 0; i < frame.pixels.size(); ++i)
            if (frame.pixels[i] == 0xFFFFFFFFu) last = i / 200;
        return last / Font::kHeight;
    };
    Notices notices;
    notices.say("1", 0);
    notices.update("fov", "90", 0);
    notices.update("volume", "5", 0);
    const std::size_t three = rows(notices);
    notices.update("fov", "95", 0);
    EXPECT_EQ(rows(notices), three);
    notices.say("2", 0);
    EXPECT_EQ(rows(notices), three + 1);
}

// What is shown when a map lies behind one, and when one is hurt.

TEST(EndScreen, CountsSectorsThatMoveAsOneAsOneSecret) {
    Map map = test::built(test::map_of(
        {test::box_room("a", 0, 0, 4, 4), test::box_room("b", 10, 0, 14, 4), test::box_room("c", 20, 0, 24, 4)}));
    EXPECT_EQ(count_of_secrets(map), 0u);
    for (Sector& sector : map.sectors) sector.secret = true;
    EXPECT_EQ(count_of_secrets(map), 3u);
    map.sectors[1].leader = SectorId(0u);
    EXPECT_EQ(count_of_secrets(map), 2u);
}

/// How many pixels are written on: neither the picture nor the shade over it.
long ink_of(const MapEnd& end) {
    Frame frame;
    frame.resize(640, 400);
    std::ranges::fill(frame.pixels, 0xFF000000);
    const Font font;
    Overlay overlay(frame, font);
    draw_end(overlay, end);
    return std::ranges::count_if(frame.pixels, [](std::uint32_t pixel) { return (pixel & 0xFFFFFF) != 0; });
}

TEST(EndScreen, TellsOfSecretsOnlyWhereThereAreAny) {
    MapEnd end{"A room", "", "", 61, 0, 0};
    const long without = ink_of(end);
    end.secrets = 3;
    EXPECT_GT(without, 500);
    EXPECT_GT(ink_of(end), without + 100);
}

std::uint32_t shade_of(double strength) {
    Frame frame;
    frame.resize(1, 1);
    frame.pixels[0] = 0xFF808080;
    const Font font;
    Overlay overlay(frame, font);
    draw_hurt(overlay, strength);
    return frame.pixels[0];
}

TEST(Hurt, TurnsThePictureRedAsMuchAsOneIsHurt) {
    EXPECT_EQ(shade_of(0), 0xFF808080u);
    EXPECT_EQ(shade_of(-1), 0xFF808080u);
    const std::uint32_t little = shade_of(0.3), much = shade_of(1);
    EXPECT_GT(little & 255, 0x80u);
    EXPECT_GT(much & 255, little & 255);
    EXPECT_LT(much >> 8 & 255, little >> 8 & 255);
}

}  // namespace
}  // namespace enfilade
