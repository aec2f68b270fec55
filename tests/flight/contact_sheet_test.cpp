// Small pictures of a flight on one sheet.
#include "flight/comparison.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace enfilade {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

Frame plain(int width, int height, std::uint32_t color) {
    Frame frame;
    frame.resize(width, height);
    std::ranges::fill(frame.pixels, color);
    return frame;
}

/// A colour of its own for each frame.
std::uint32_t color_of(int frame) { return 0xFF000000u | std::uint32_t(frame) * 0x010309u; }

TEST(Reduced, IsTheRoundedMeanOfEachSquare) {
    Frame picture = plain(4, 2, 0xFF000000u);
    picture.pixels = {0xFF000001u, 0xFF000002u, 0xFFFF0000u, 0xFFFF0000u,   //
                      0xFF000001u, 0xFF000002u, 0xFFFF0000u, 0xFF00FF00u};  // 6 / 4 = 1.5; 191.25; 63.75
    EXPECT_THAT(reduced(picture, 2).pixels, ElementsAre(0xFF000002u, 0xFFBF4000u));
}

TEST(Reduced, TakesWhatThereIsAtTheEdges) {
    Frame picture = plain(3, 3, 0xFF000010u);
    picture.pixels[8] = 0xFF000050u;
    const Frame small = reduced(picture, 2);
    EXPECT_EQ(small.width, 2);
    EXPECT_EQ(small.height, 2);
    EXPECT_THAT(small.pixels, ElementsAre(0xFF000010u, 0xFF000010u, 0xFF000010u, 0xFF000050u));
}

TEST(Reduced, HasNoSideLongerThanASmallPictures) {
    for (const auto& [width, height] : {std::pair{1, 1}, {80, 80}, {81, 3}, {320, 200}, {200, 640}, {1023, 5}}) {
        const int reduction = reduction_of(width, height);
        const Frame small = reduced(plain(width, height, color_of(7)), reduction);
        EXPECT_LE(std::max(small.width, small.height), kSmallSide) << width << " x " << height;
        EXPECT_GT(std::max(width, height), (reduction - 1) * kSmallSide) << width << " x " << height;
        EXPECT_THAT(small.pixels, Each(color_of(7)));
    }
}

TEST(FramesOnSheet, AreAllOfAShortFlight) {
    EXPECT_THAT(frames_on_sheet(1), ElementsAre(0));
    EXPECT_THAT(frames_on_sheet(3), ElementsAre(0, 1, 2));
}

TEST(FramesOnSheet, GoEvenlyFromTheFirstToTheLast) {
    for (const int frames : {kMostOnSheet, kMostOnSheet + 1, 111, 5'000'000}) {
        const std::vector<int> chosen = frames_on_sheet(frames);
        ASSERT_EQ(chosen.size(), std::size_t(kMostOnSheet)) << frames;
        EXPECT_EQ(chosen.front(), 0);
        EXPECT_EQ(chosen.back(), frames - 1);
        for (std::size_t i = 1; i < chosen.size(); ++i) {
            EXPECT_GE(chosen[i] - chosen[i - 1], (frames - 1) / (kMostOnSheet - 1));
            EXPECT_LE(chosen[i] - chosen[i - 1], (frames - 1) / (kMostOnSheet - 1) + 1);
        }
    }
}

TEST(ContactSheet, GivesBackEachFramesPicture) {
    ContactSheet sheet(7, 160, 100);
    for (int frame = 6; frame >= 0; --frame) sheet.put(frame, plain(160, 100, color_of(frame)));
    EXPECT_EQ(sheet.image().width, 4 * 80);
    EXPECT_EQ(sheet.image().height, 2 * 50);
    for (int frame = 0; frame < 7; ++frame) {
        const auto picture = sheet.picture_of(frame);
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->width, 80);
        EXPECT_EQ(picture->height, 50);
        EXPECT_THAT(picture->pixels, Each(color_of(frame))) << frame;
    }
    EXPECT_EQ(sheet.image().pixels.back(), 0xFF000000u);  // no eighth picture
}

TEST(ContactSheet, HasNothingOfFramesBetween) {
    ContactSheet sheet(100, 8, 5), empty(100, 8, 5);
    sheet.put(1, plain(8, 5, color_of(1)));
    EXPECT_EQ(sheet.image().pixels, empty.image().pixels);
    EXPECT_FALSE(sheet.picture_of(1));
    EXPECT_FALSE(sheet.picture_of(-1));
    EXPECT_FALSE(sheet.picture_of(100));
    EXPECT_TRUE(sheet.picture_of(99));
}

TEST(ContactSheet, TakesOnlyAnImageOfItsSize) {
    ContactSheet sheet(2, 8, 5);
    EXPECT_FALSE(sheet.take(plain(15, 5, color_of(3))));
    EXPECT_FALSE(sheet.take(plain(16, 4, color_of(3))));
    EXPECT_EQ(sheet.image().pixels.front(), 0xFF000000u);
    EXPECT_TRUE(sheet.take(plain(16, 5, color_of(3))));
    EXPECT_THAT(sheet.picture_of(1)->pixels, Each(color_of(3)));
}

}  // namespace
}  // namespace enfilade
