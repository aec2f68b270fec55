// Frames as YUV4MPEG2.
#include "flight/y4m.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

/// Y, Cb and Cr of a single pixel.
std::vector<int> yuv(std::uint32_t color) {
    Frame frame;
    frame.resize(1, 1);
    frame.pixels[0] = color;
    const Bytes bytes = y4m_frame(frame);
    EXPECT_EQ(as_text(bytes).substr(0, 6), "FRAME\n");
    EXPECT_EQ(bytes.size(), 9u);
    return {int(bytes[6]), int(bytes[7]), int(bytes[8])};
}

TEST(Y4mHeader, TellsSizeAndRate) { EXPECT_EQ(y4m_header(320, 200, 30), "YUV4MPEG2 W320 H200 F30:1 Ip A1:1 C444\n"); }

TEST(Y4mFrame, GivesTheColoursOfBt601) {
    EXPECT_EQ(yuv(0xFF000000), (std::vector{16, 128, 128}));
    EXPECT_EQ(yuv(0xFFFFFFFF), (std::vector{235, 128, 128}));
    EXPECT_EQ(yuv(0xFF0000FF), (std::vector{81, 90, 240}));   // red
    EXPECT_EQ(yuv(0xFF00FF00), (std::vector{145, 54, 34}));   // green
    EXPECT_EQ(yuv(0xFFFF0000), (std::vector{41, 240, 110}));  // blue
}

TEST(Y4mFrame, KeepsEveryGreyGrey) {
    for (std::uint32_t grey = 0; grey < 256; ++grey) {
        const auto color = yuv(0xFF000000u | grey << 16 | grey << 8 | grey);
        EXPECT_EQ(color[1], 128);
        EXPECT_EQ(color[2], 128);
    }
}

TEST(Y4mFrame, WritesPlanesOneAfterTheOther) {
    Frame frame;
    frame.resize(2, 1);
    frame.pixels = {0xFF000000, 0xFFFFFFFF};
    const Bytes bytes = y4m_frame(frame);
    ASSERT_EQ(bytes.size(), 12u);
    EXPECT_EQ(int(bytes[6]), 16);
    EXPECT_EQ(int(bytes[7]), 235);
}

}  // namespace
}  // namespace enfilade
