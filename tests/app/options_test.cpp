// Arguments from text to values.
#include "app/options.h"

#include <gtest/gtest.h>

#include <climits>

namespace enfilade {
namespace {

TEST(ParseSize, TakesWidthAndHeight) { EXPECT_EQ(parse_size("640x400").value(), (PictureSize{640, 400})); }

TEST(ParseSize, TakesTheSmallestAndTheLargest) {
    EXPECT_TRUE(parse_size("1x1").ok());
    EXPECT_TRUE(parse_size("16384x16384").ok());
}

TEST(ParseSize, RefusesEverythingElseAndSaysWhatItExpects) {
    for (const char* text : {"", "640", "640x", "x400", "0x400", "640x-1", "16385x1", "640x400x1", "640 x 400", "axb",
                             "640x400 ", "99999999999x1", "6.5x4"}) {
        const auto size = parse_size(text);
        ASSERT_FALSE(size.ok()) << text;
        EXPECT_NE(size.error().what.find("WIDTHxHEIGHT"), std::string::npos) << text;
    }
}

TEST(ParseFrames, TakesARangeWithBothEnds) { EXPECT_EQ(parse_frames("10..59").value(), (FrameRange{10, 59})); }

TEST(ParseFrames, TakesASingleFrame) { EXPECT_EQ(parse_frames("7").value(), (FrameRange{7, 7})); }

TEST(ParseFrames, RefusesEverythingElse) {
    for (const char* text : {"", "..", "5..", "..5", "9..3", "-1..3", "1.5..3", "1...3", "a..b"})
        EXPECT_FALSE(parse_frames(text).ok()) << text;
}

TEST(FrameParts, CoverAFlightOnceAndEvenly) {
    for (const int frames : {1, 2, 7, 71, 1'000'000, 2'000'000'000})
        for (const int count : {1, 2, 3, 8, 1000}) {
            int next = 0;
            for (int number = 1; number <= count; ++number) {
                const auto range = frames_of(FramePart{number, count}, frames);
                if (!range.ok()) continue;
                EXPECT_EQ(range.value().first, next);
                next = range.value().last + 1;
                EXPECT_LE(next - range.value().first, frames / count + 1);
            }
            EXPECT_EQ(next, frames) << count;
        }
}

TEST(FrameParts, MayBeAsManyAsCanBeNamed) {
    EXPECT_EQ(frames_of(FramePart{INT_MAX, INT_MAX}, 11).value(), (FrameRange{10, 10}));
    EXPECT_FALSE(frames_of(FramePart{1, INT_MAX}, 11).ok());
}

}  // namespace
}  // namespace enfilade
