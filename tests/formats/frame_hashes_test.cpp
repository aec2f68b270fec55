// The hash file beside a flythrough.
#include "formats/frame_hashes.h"

#include <gtest/gtest.h>

#include "formats/hostile.h"

namespace enfilade {
namespace {

const FrameRecording kRecording{RecordedPictures{64, 40, "column"},
                                0xFEDCBA9876543210,
                                {{0, 0x0123456789ABCDEF}, {7, 0}, {99999999, ~std::uint64_t{0}}}};

std::string complaint(std::string_view text) {
    const auto hashes = read_frame_hashes(text);
    return hashes.ok() ? "" : hashes.error().text();
}

TEST(FrameHashes, ReadBackWhatWasWritten) {
    const auto hashes = read_frame_hashes(write_frame_hashes(kRecording));
    ASSERT_TRUE(hashes.ok());
    EXPECT_EQ(hashes.value(), kRecording);
}

TEST(FrameHashes, SkipCommentsEmptyLinesAndCarriageReturns) {
    const auto hashes = read_frame_hashes("# a\r\n\r\n3 0123456789abcdef\r\n");
    ASSERT_TRUE(hashes.ok());
    EXPECT_EQ(hashes.value(), (FrameRecording{{}, {}, {{3, 0x0123456789ABCDEF}}}));
}

TEST(FrameHashes, SurviveBeingCutAnywhere) {
    std::string text = write_frame_hashes(kRecording);
    text.pop_back();  // the end of the last line may be missing
    for_each_cut(text, [](std::string_view cut) {
        const auto hashes = read_frame_hashes(cut);
        EXPECT_LT(hashes.ok() ? hashes.value().frames.size() : 0, kRecording.frames.size());
    });
}

TEST(FrameHashes, NameALineWithoutAHash) { EXPECT_EQ(complaint("1"), "1:1: expected \"FRAME HASH\", found '1'"); }

TEST(FrameHashes, NameAFrameThatIsNoNumber) {
    EXPECT_EQ(complaint("# x\n-1 0123456789abcdef"), "2:1: expected a frame's number, found '-1'");
}

TEST(FrameHashes, NameAHashOfTheWrongLength) {
    EXPECT_EQ(complaint("12 0123456789abcde"), "1:4: expected 16 hexadecimal digits, found '0123456789abcde'");
}

TEST(FrameHashes, NameFramesThatDoNotGrow) {
    EXPECT_EQ(complaint("1 0000000000000000\n1 0000000000000000"), "2:1: frames must grow, found 1 after 1");
}

TEST(FrameHashes, NameAPictureThatIsNone) {
    for (const char* text :
         {"picture 64 column", "picture 64x40", "picture 64xcolumn 3", "picture x40 column", "picture 0x7 column",
          "picture 7x0 column", "picture 0x0 column", "picture 7x column", "picture 7x8x9 column",
          "picture -7x8 column", "picture +7x8 column", "picture 4294967296x8 column", "picture  7x8 column",
          "picture 0x07 column", "picture 4294967295x4294967295 column", "picture 4294967295x1 column",
          "picture 1x2147483648 column", "picture 16385x1 column", "picture 1x16385 column"})
        EXPECT_EQ(complaint(text),
                  "1:1: expected \"picture WIDTHxHEIGHT RENDERER\", each side from 1 to 16384 pixels, found '" +
                      std::string(text) + "'");
    EXPECT_EQ(complaint("picture 16384x16384 column"), "");
}

TEST(FrameHashes, NameARendererThatIsNone) {
    EXPECT_EQ(complaint("picture 7x8 colum"), "1:13: expected a renderer, found 'colum'; did you mean 'column'?");
    for (const char* text : {"picture 7x8 R", "picture 7x8 ", "picture 7x8  column", "picture 7x8 column stencil"})
        EXPECT_NE(complaint(text).find("1:13: expected a renderer, found '"), std::string::npos) << text;
}

TEST(FrameHashes, NameASecondLineAboutPictures) {
    EXPECT_EQ(complaint("picture 7x8 column\npicture 7x8 column"), "2:1: expected a frame's number, found 'picture'");
}

TEST(FrameHashes, NameASheetWithoutAHash) {
    EXPECT_EQ(complaint("sheet 0123"), "1:7: expected 16 hexadecimal digits, found '0123'");
    EXPECT_EQ(complaint("sheet 0000000000000000\nsheet 0000000000000000"),
              "2:1: expected a frame's number, found 'sheet'");
}

TEST(FrameHashes, RefuseANumberThatDoesNotFit) {
    for (const char* text : {"4294967296", "4294967295", "2147483648", "100000000"})
        EXPECT_EQ(complaint(text + std::string(" 0000000000000000")),
                  "1:1: expected a frame's number, found '" + std::string(text) + "'");
}

}  // namespace
}  // namespace enfilade
