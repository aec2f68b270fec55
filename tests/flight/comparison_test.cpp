// Where two frames differ.
#include "flight/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace enfilade {
namespace {

Frame grey(int width, int height) {
    Frame frame;
    frame.resize(width, height);
    std::ranges::fill(frame.pixels, 0xFF808080u);
    return frame;
}

TEST(DifferenceOf, IsNothingForEqualFrames) {
    const Difference difference = difference_of(grey(4, 3), grey(4, 3));
    EXPECT_EQ(difference.pixels, 0u);
    EXPECT_EQ(difference.largest, 0);
}

TEST(DifferenceOf, CountsPixelsAndFindsTheLargestChannel) {
    Frame other = grey(4, 3);
    other.pixels[2] = 0xFF808090u;
    other.pixels[7] = 0xFF608080u;
    const Difference difference = difference_of(grey(4, 3), other);
    EXPECT_EQ(difference.pixels, 2u);
    EXPECT_EQ(difference.largest, 0x20);
}

TEST(DifferenceOf, ShowsRedWhereFramesDiffer) {
    Frame other = grey(2, 1);
    other.pixels[1] = 0xFF808081u;
    const auto& picture = difference_of(grey(2, 1), other).picture;
    EXPECT_EQ(picture.pixels[0], 0xFF2A2A2Au);
    EXPECT_EQ(picture.pixels[1] & 0xFF, 0xFFu);
}

TEST(Mismatches, ListsFramesWithAnotherHash) {
    const auto found = mismatches({{0, 10}, {1, 11}, {2, 12}}, 0, {10, 99, 12});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].frame, 1);
    EXPECT_EQ(found[0].expected, 11u);
    EXPECT_EQ(found[0].actual, 99u);
}

TEST(Mismatches, LooksOnlyAtTheFramesThatWereDrawn) {
    EXPECT_TRUE(mismatches({{0, 10}, {1, 11}, {2, 12}}, 1, {11}).empty());
}

TEST(MismatchPage, ShowsThreePicturesAndEscapesNames) {
    MismatchRow row;
    row.mismatch = {7, 1, 2};
    row.expected_picture = "e.png";
    row.actual_picture = "a.png";
    row.difference_picture = "d.png";
    const std::string page = mismatch_page({"<script>", "", 5}, {row});
    for (const char* part : {"e.png", "a.png", "d.png", "frame 7", "&lt;script&gt;", "5 frames differ"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(page.find("<script>"), std::string::npos);
}

TEST(MismatchPage, SaysWhenSmallPicturesCannotShowTheDifference) {
    MismatchRow row;
    row.difference_picture = "d.png";
    row.reduction = 4;
    row.of_pixels = 4000;
    const std::string page = mismatch_page({"", "", 1}, {row});
    EXPECT_NE(page.find("0 of 4000 pixels differ"), std::string::npos);
    EXPECT_NE(page.find("less than such small pictures can show"), std::string::npos);
    row.pixels = 1;
    EXPECT_EQ(mismatch_page({"", "", 1}, {row}).find("less than"), std::string::npos);
}

TEST(MismatchPage, ShowsNoPictureWhereThereIsNone) {
    MismatchRow row;
    row.actual_picture = "a.png";
    row.expected_origin = "no picture was kept";
    const std::string page = mismatch_page({"", "", 1}, {row});
    EXPECT_EQ(page.find("<img"), page.rfind("<img"));
    EXPECT_NE(page.find("no picture was kept"), std::string::npos);
    EXPECT_EQ(page.find("pixels differ"), std::string::npos);
}

}  // namespace
}  // namespace enfilade
