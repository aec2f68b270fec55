// Messages on the screen.
#include "app/play/readout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace enfilade {
namespace {

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

}  // namespace
}  // namespace enfilade
