// Means of light.
#include "render/supersample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace enfilade {
namespace {

std::uint32_t grey(std::uint32_t value) { return 0xFF000000u | value * 0x010101u; }

TEST(LightMean, OfOneColourIsThatColour) {
    for (std::uint32_t value = 0; value < 256; ++value)
        for (const std::uint32_t count : {1u, 3u, 64u}) {
            LightMean mean;
            for (std::uint32_t i = 0; i < count; ++i) mean.add(grey(value));
            EXPECT_EQ(mean.color(count), grey(value)) << value << " x " << count;
        }
}

TEST(LightMean, IsTakenInLinearLightByTheStandardsCurve) {
    const auto light = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto value = [](double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1 / 2.4) - 0.055; };
    for (std::uint32_t a = 0; a < 256; a += 5)
        for (std::uint32_t b = 0; b < 256; b += 7) {
            LightMean mean;
            mean.add(grey(a));
            mean.add(grey(b));
            const double expected = 255 * value((light(a / 255.0) + light(b / 255.0)) / 2);
            EXPECT_NEAR(double(mean.color(2) & 0xFF), expected, 0.55) << a << " " << b;
        }
}

TEST(LightMean, MixesEachChannelByItself) {
    LightMean mean;
    mean.add(0xFF0000FFu);
    mean.add(0xFF00FF00u);
    EXPECT_EQ(mean.color(2), 0xFF00BCBCu);  // half of full light is the value 188
}

// hard case G12
TEST(TakeMeans, GivesEachPixelThoseItCovers) {
    Frame fine, frame;
    fine.resize(4, 2);
    fine.pixels = {grey(0), grey(0), grey(10), grey(10), grey(0), grey(0), grey(10), grey(10)};
    frame.resize(2, 1);
    take_means(fine, 2, frame);
    EXPECT_EQ(frame.pixels, (Pixels{grey(0), grey(10)}));
}

}  // namespace
}  // namespace enfilade
