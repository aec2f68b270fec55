// Lines, boxes and text over a frame.
#include "app/draw/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace enfilade {
namespace {

constexpr Color kBlack = 0xFF000000, kWhite = 0xFFFFFFFF;

class OverlayOnBlack : public ::testing::Test {
protected:
    OverlayOnBlack() {
        frame_.resize(40, 30);
        std::ranges::fill(frame_.pixels, kBlack);
    }

    Color at(int x, int y) const { return frame_.pixels[std::size_t(y * 40 + x)]; }
    long inked() const {
        return std::ranges::count_if(frame_.pixels, [](Color color) { return color != kBlack; });
    }

    Frame frame_;
    Font font_;
    Overlay overlay_{frame_, font_};
};

TEST_F(OverlayOnBlack, FillsTheBoxAndNothingElse) {
    overlay_.fill({3, 4, 5, 6}, kWhite);
    EXPECT_EQ(inked(), 30);
    EXPECT_EQ(at(3, 4), kWhite);
    EXPECT_EQ(at(7, 9), kWhite);
}

TEST_F(OverlayOnBlack, LeavesOutWhatLiesOutside) {
    overlay_.fill({-5, -5, 6, 6}, kWhite);
    overlay_.dot(40, 0, kWhite);
    overlay_.dot(0, -1, kWhite);
    EXPECT_EQ(inked(), 1);
}

TEST_F(OverlayOnBlack, MixesByAlpha) {
    overlay_.dot(0, 0, 0x80FFFFFF);
    EXPECT_EQ(at(0, 0), 0xFF808080u);
}

TEST_F(OverlayOnBlack, OutlinesOnlyTheRim) {
    overlay_.outline({0, 0, 10, 10}, kWhite);
    EXPECT_EQ(inked(), 36);
    EXPECT_EQ(at(5, 5), kBlack);
}

TEST_F(OverlayOnBlack, DrawsALineWithoutGaps) {
    overlay_.line({2, 3}, {30, 17}, kWhite);
    for (int x = 2; x <= 30; ++x) {
        bool hit = false;
        for (int y = 0; y < 30; ++y) hit = hit || at(x, y) == kWhite;
        EXPECT_TRUE(hit) << "column " << x;
    }
}

TEST_F(OverlayOnBlack, DrawsALineFromFarOutsideInNoTime) {
    overlay_.line({-1e9, 15.5}, {1e9, 15.5}, kWhite);
    EXPECT_EQ(inked(), 40);
}

TEST_F(OverlayOnBlack, DrawsNothingOfALineThatMissesThePicture) {
    overlay_.line({-10, 50}, {60, 90}, kWhite);
    EXPECT_EQ(inked(), 0);
}

TEST_F(OverlayOnBlack, WritesTextWhereItIsTold) {
    overlay_.text(10, 5, "A", kWhite);
    EXPECT_EQ(at(13, 8), kWhite);
    EXPECT_EQ(at(9, 8), kBlack);
}

TEST_F(OverlayOnBlack, ScalesTextByWholePixels) {
    Overlay large(frame_, font_, 2);
    large.text(0, 0, "A", kWhite);
    for (const auto& [x, y] : {std::pair{6, 6}, {7, 6}, {6, 7}, {7, 7}}) EXPECT_EQ(at(x, y), kWhite);
    EXPECT_EQ(large.text_width("AB"), 28);
}

}  // namespace
}  // namespace enfilade
