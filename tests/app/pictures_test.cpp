// Frames as picture files and films.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/pictures.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

TEST(IdsImage, PutsTheHighByteIntoRed) {
    FrameFacts facts;
    facts.ids = {0x123456};
    EXPECT_EQ(ids_image(facts, 1, 1).pixels[0], 0xFF563412u);
}

TEST(NumberedPicture, CountsFromZeroWithSixDigits) {
    EXPECT_EQ(numbered_picture("out", 0), "out/000000.png");
    EXPECT_EQ(numbered_picture("out", 1234567), "out/1234567.png");
}

TEST(NamesPicture, TellsFilesFromFolders) {
    EXPECT_TRUE(names_picture("a/b.png"));
    EXPECT_TRUE(names_picture("B.PNG"));
    EXPECT_FALSE(names_picture("a.png/b"));
    EXPECT_FALSE(names_picture("png"));
}

TEST(MakeFolder, MakesThoseAboveToo) {
    const test::TempDir dir;
    EXPECT_TRUE(make_folder(dir.path("a/b/c")).ok());
    EXPECT_TRUE(std::filesystem::is_directory(dir.path("a/b/c")));
    EXPECT_TRUE(make_folder(dir.path("a/b/c")).ok());
}

TEST(MakeFolder, RefusesAPathThroughAFile) {
    const test::TempDir dir;
    ASSERT_TRUE(write_file(dir.path("file"), std::string_view("x")).ok());
    EXPECT_FALSE(make_folder(dir.path("file")).ok());
    EXPECT_FALSE(make_folder(dir.path("file/below")).ok());
}

// Films in YUV4MPEG2.

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

TEST(Y4mHeader, TellsSizeAndRate) { EXPECT_EQ(y4m_header({320, 200, 30}), "YUV4MPEG2 W320 H200 F30:1 Ip A1:1 C444\n"); }

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
