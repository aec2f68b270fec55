// The inner loops: every texel in range, runs independent of where they start.
#include "render/column/kernels.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.h"

namespace enfilade::column {
namespace {

/// A picture whose every pixel tells its own place.
Texture numbered(std::uint32_t width, std::uint32_t height) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    for (std::uint32_t x = 0; x < width; ++x)
        for (std::uint32_t y = 0; y < height; ++y) texture.pixels.push_back(0xFF000000u | x << 12 | y);
    return texture;
}

TEST(FillWall, ShowsTheTexelOfEachRowForAnyTextureHeight) {
    for (std::uint32_t height : {1u, 3u, 5u, 72u, 127u, 128u, 129u}) {
        const Texture texture = numbered(1, height);
        std::vector<std::uint32_t> pixels(300);
        const double v0 = -3.3, per_row = 0.0137;
        fill_wall({pixels.data(), 0, 300}, {texture.pixels.data(), height, tile_steps(v0), tile_steps(per_row), 256});
        for (int y = 0; y < 300; ++y)
            ASSERT_EQ(pixels[y] & 0xFFF, texel_index(fraction(v0 + y * per_row), height)) << height << " row " << y;
    }
}

TEST(FillWall, DrawsTheSameRowsWhereverTheRunStarts) {
    const Texture texture = numbered(1, 77);
    Random random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const WallRun wall{texture.pixels.data(), 77, random.bits(), random.bits(), 200};
        std::vector<std::uint32_t> whole(120), part(120);
        fill_wall({whole.data(), 0, 120}, wall);
        const int start = static_cast<int>(random.below(120));
        fill_wall({part.data(), start, 120 - start}, wall);
        ASSERT_TRUE(std::equal(whole.begin() + start, whole.end(), part.begin())) << "trial " << trial;
    }
}

TEST(FillFlat, StaysInTheTextureForAnyStepAndDepth) {
    const Texture texture = numbered(3, 5);
    const std::vector<double> depths{0, 1, 1e9, 1e300, std::numeric_limits<double>::infinity()};
    const std::vector<Shade> shades(depths.size(), 256);
    for (double step : {0.0, 1e-9, -0.7, 1e3, -1e9, 1e200}) {
        std::vector<std::uint32_t> pixels(depths.size());
        fill_flat({pixels.data(), 0, 5}, {&texture, 0.25, 0.99, step, -step, 1e5, depths.data(), shades.data()});
        for (std::uint32_t pixel : pixels) {
            EXPECT_LT(pixel >> 12 & 0xFFF, 3u);
            EXPECT_LT(pixel & 0xFFF, 5u);
        }
    }
}

TEST(FillFlat, ShowsTheTexelUnderEachRow) {
    const Texture texture = numbered(64, 32);
    const std::vector<double> depths{0.5, 1.25, 2, 7.75, 31.3};
    const std::vector<Shade> shades(depths.size(), 256);
    std::vector<std::uint32_t> pixels(depths.size());
    fill_flat({pixels.data(), 0, 5}, {&texture, 0.3, 0.6, 0.41, -0.27, 100, depths.data(), shades.data()});
    for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_EQ(pixels[i] >> 12 & 0xFFF, texel_index(fraction(0.3 + depths[i] * 0.41), 64)) << i;
        EXPECT_EQ(pixels[i] & 0xFFF, texel_index(fraction(0.6 - depths[i] * 0.27), 32)) << i;
    }
}

TEST(FillSky, HoldsItsFirstAndLastRowBeyondThePicture) {
    const Texture texture = numbered(1, 10);
    std::vector<double> rises;
    for (int y = 0; y < 60; ++y) rises.push_back(30 - y);
    std::vector<std::uint32_t> pixels(60);
    fill_sky({pixels.data(), 0, 60}, {texture.pixels.data(), 10, 1, -0.05, rises.data()});
    EXPECT_EQ(pixels[0] & 0xFFF, 0u);
    EXPECT_EQ(pixels[29] & 0xFFF, 9u);
    EXPECT_EQ(pixels[59] & 0xFFF, 9u);
    for (int y = 1; y < 60; ++y) EXPECT_LE(pixels[y - 1] & 0xFFF, pixels[y] & 0xFFF);
}

TEST(LaySky, MixesWhatIsThereByItsAlpha) {
    const std::vector<std::uint32_t> texels{0x00FFFFFFu, 0x80FF0000u, 0xFF0000FFu};
    std::vector<std::uint32_t> pixels(3, 0xFF204060u);
    const std::vector<double> rises{2.5, 1.5, 0.5};
    lay_sky({pixels.data(), 0, 3}, {texels.data(), 3, 1, -1.0 / 3, rises.data()});
    EXPECT_EQ(pixels[0], 0xFF204060u);
    EXPECT_EQ(pixels[1], laid_over(0xFF204060u, 0x80FF0000u));
    EXPECT_EQ(pixels[2], 0xFF0000FFu);
}

}  // namespace
}  // namespace enfilade::column
