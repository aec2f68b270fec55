// Means of light, and pictures made smaller.
#include "render/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

// Pictures made smaller.

Texture picture(std::uint32_t width, std::uint32_t height, std::vector<std::uint32_t> pixels) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.pixels = std::move(pixels);
    return texture;
}

constexpr std::uint32_t kBlack = 0xFF000000u, kWhite = 0xFFFFFFFFu, kHalfLight = 0xFFBCBCBCu;

TEST(MipChains, HalveBothSidesUntilOneTexelIsLeft) {
    TextureSet set;
    set.textures.push_back(picture(8, 2, std::vector<std::uint32_t>(16, kWhite)));
    const MipChains mips(set);
    const Texture& whole = set.textures[0];
    EXPECT_EQ(&mips.at(whole, 0), &whole);
    const std::pair<std::uint32_t, std::uint32_t> sizes[] = {{4, 1}, {2, 1}, {1, 1}, {1, 1}, {1, 1}};
    for (int level = 1; level <= 5; ++level) {
        const Texture& smaller = mips.at(whole, level);
        EXPECT_EQ(std::pair(smaller.width, smaller.height), sizes[level - 1]) << level;
        EXPECT_EQ(smaller.pixels, std::vector<std::uint32_t>(smaller.pixels.size(), kWhite));
    }
}

TEST(MipChains, MixAsMuchLightAsThereWas) {
    TextureSet set;
    set.textures.push_back(picture(2, 2, {kBlack, kWhite, kWhite, kBlack}));
    EXPECT_EQ(MipChains(set).at(set.textures[0], 1).pixels, std::vector{kHalfLight});
}

TEST(MipChains, CoverEveryTexelOfAnOddSideOnce) {
    TextureSet set;
    set.textures.push_back(picture(5, 1, {kWhite, kWhite, kBlack, kBlack, kBlack}));
    const MipChains mips(set);
    const Texture& half = mips.at(set.textures[0], 1);
    ASSERT_EQ(half.width, 2u);
    EXPECT_EQ(half.pixels[0], kWhite);
    EXPECT_EQ(half.pixels[1], kBlack);
}

TEST(MipChains, LeaveWhatHasHoles) {
    TextureSet set;
    set.textures.push_back(picture(2, 1, {0, kWhite}));
    set.textures[0].has_holes = true;
    const MipChains mips(set);
    EXPECT_EQ(&mips.at(set.textures[0], 3), &set.textures[0]);
    EXPECT_EQ(&mips.at(set.placeholder, 3), &set.placeholder);
}

TEST(MipChains, TakeTheColorTablesNearestColors) {
    std::vector<std::uint32_t> columns;  // three colours of one shade and 32 levels
    for (const std::uint32_t color : {kBlack, 0xFFB0B0B0u, kWhite})
        columns.insert(columns.end(), ColorTable::kLevels + 1, color);
    TextureSet set;
    set.color_table = ColorTable::read(picture(3, ColorTable::kLevels + 1, columns)).value();
    set.textures.push_back(picture(2, 1, {kBlack, kWhite}));
    set.textures[0].numbers = set.color_table.numbers_in(set.textures[0]);
    const MipChains mips(set);
    const Texture& half = mips.at(set.textures[0], 1);
    EXPECT_EQ(half.pixels, std::vector{0xFFB0B0B0u});
    EXPECT_EQ(half.numbers, std::vector<std::uint8_t>{1});
}

TEST(MipPlace, GoesStraightFromEachLevelToTheNext) {
    const auto expect = [](double texels_per_pixel, int level, std::uint32_t part) {
        const MipPlace place = mip_place(texels_per_pixel);
        EXPECT_EQ(place.level, level) << texels_per_pixel;
        EXPECT_EQ(place.part, part) << texels_per_pixel;
    };
    expect(0, 0, 0);
    expect(0.9, 0, 0);
    expect(1, 0, 0);
    expect(1.5, 0, 128);
    expect(1.999, 0, 255);
    expect(2, 1, 0);
    expect(2 * (1 - 1e-12), 1, 0);  // rounded as other ways of computing it would be
    expect(3, 1, 128);
    expect(40, 5, 64);
    expect(1e300, 31, 0);
    expect(std::numeric_limits<double>::infinity(), 31, 0);
}

TEST(MipLevel, MakesTexelsAboutAsLargeAsPixels) {
    EXPECT_EQ(mip_level(0), 0);
    EXPECT_EQ(mip_level(1.4), 0);
    EXPECT_EQ(mip_level(1.5), 1);
    EXPECT_EQ(mip_level(2.8), 1);
    EXPECT_EQ(mip_level(2.9), 2);
    EXPECT_EQ(mip_level(1e300), 31);
}

}  // namespace

}  // namespace enfilade
