// Arguments from text to values.
#include "app/options.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(ParseViewpoint, TakesFiveNumbers) {
    const auto viewpoint = parse_viewpoint("-1.5,2,+0.25,-90,1e1").value();
    EXPECT_EQ(viewpoint.x, -1.5);
    EXPECT_EQ(viewpoint.y, 2);
    EXPECT_EQ(viewpoint.z, 0.25);
    EXPECT_EQ(viewpoint.yaw_degrees, -90);
    EXPECT_EQ(viewpoint.pitch_degrees, 10);
}

TEST(ParseViewpoint, RefusesEverythingElse) {
    for (const char* text : {"", "1,2,3,4", "1,2,3,4,5,6", "1,2,3,4,", "1,2,x,4,5", "nan,0,0,0,0", "inf,0,0,0,0",
                             "32769,0,0,0,0", "0,0,0,0,90", "0,0,0,0,-89.5", "0,0,0,1e300,0", "1, 2,3,4,5"})
        EXPECT_FALSE(parse_viewpoint(text).ok()) << text;
}

TEST(CheckViewpoint, RefusesWhatIsNoNumber) {
    Viewpoint viewpoint;
    viewpoint.pitch_degrees = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(check_viewpoint(viewpoint));
}

TEST(ParseFrames, TakesARangeWithBothEnds) { EXPECT_EQ(parse_frames("10..59").value(), (FrameRange{10, 59})); }

TEST(ParseFrames, TakesASingleFrame) { EXPECT_EQ(parse_frames("7").value(), (FrameRange{7, 7})); }

TEST(ParseFrames, RefusesEverythingElse) {
    for (const char* text : {"", "..", "5..", "..5", "9..3", "-1..3", "1.5..3", "1...3", "a..b"})
        EXPECT_FALSE(parse_frames(text).ok()) << text;
}

TEST(ParseNumber, TakesTheWholeTextOnly) {
    EXPECT_EQ(parse_number("--fov", "90.5").value(), 90.5);
    EXPECT_FALSE(parse_number("--fov", "90deg").ok());
    EXPECT_FALSE(parse_number("--fov", "nan").ok());
}

}  // namespace
}  // namespace enfilade
