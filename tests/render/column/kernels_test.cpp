// The inner loops, one pixel at a time: every texel in range, runs independent of where they start.
#include "render/column/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/hash.h"

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

/// One column of a wall down to `end`, by the kernels that say what is drawn.
void fill_wall(std::vector<std::uint32_t>& pixels, int first, int end, const Texture& texture, TileSteps v_at_row_0,
               TileSteps v_per_row) {
    const std::uint32_t first_texel = 0;
    const Shade shade = 256;
    scalar_kernels().fill_walls(
        {{pixels.data(), 0, 1, &first, &end}, &texture, &first_texel, &v_at_row_0, &v_per_row, &shade, nullptr});
}

// hard cases R29, W12
TEST(FillWall, ShowsTheTexelOfEachRowForAnyTextureHeight) {
    for (std::uint32_t height : {1u, 3u, 5u, 72u, 127u, 128u, 129u}) {
        const Texture texture = numbered(1, height);
        std::vector<std::uint32_t> pixels(300);
        const double v0 = -3.3, per_row = 0.0137;
        fill_wall(pixels, 0, 300, texture, tile_steps(v0), tile_steps(per_row));
        for (int y = 0; y < 300; ++y)
            ASSERT_EQ(pixels[y] & 0xFFF, texel_of(place_on_tile(v0 + y * per_row), height)) << height << " row " << y;
    }
}

/// Rounding puts what should be at the edge between two texels a little to either side of it.
TEST(FillWall, RoundsToTheEdgesOfTexels) {
    const Texture texture = numbered(1, 64);
    std::vector<std::uint32_t> pixel(1);
    for (const double off : {-1e-11, 0.0, 1e-11}) {
        fill_wall(pixel, 0, 1, texture, tile_steps(17.0 / 64 + off), 0);
        EXPECT_EQ(pixel[0] & 0xFFF, 17u) << off;
    }
}

TEST(FillWall, DrawsTheSameRowsWhereverTheRunStarts) {
    const Texture texture = numbered(1, 77);
    Random random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const TileSteps at_row_0 = random.bits(), per_row = random.bits();
        std::vector<std::uint32_t> whole(120), part(120);
        fill_wall(whole, 0, 120, texture, at_row_0, per_row);
        const int start = static_cast<int>(random.below(120));
        fill_wall(part, start, 120, texture, at_row_0, per_row);
        ASSERT_TRUE(std::equal(whole.begin() + start, whole.end(), part.begin() + start)) << "trial " << trial;
    }
}

TEST(ReadWalls, TellsTexelsWithTheirAlphaAndWhetherAnyIsSeen) {
    for (std::uint32_t height : {1u, 64u, 72u}) {
        Texture texture = numbered(1, height);
        for (std::uint32_t i = 0; i < height; ++i) texture.pixels[i] = (i % 3 * 100) << 24 | i;
        const int top = 5, bottom = 50;
        const TileSteps at_row_0 = tile_steps(0.01), per_row = tile_steps(0.003);
        const std::uint32_t first_texel = 0;
        const Shade shade = 100;
        std::vector<std::uint32_t> pixels(60, 7);
        const PlainWalls wall{
            {pixels.data(), 0, 1, &top, &bottom}, &texture, &first_texel, &at_row_0, &per_row, &shade, nullptr};
        std::uint32_t any = 0;
        read_walls(wall);
        for (int y = 0; y < 60; ++y) {
            const bool is_in = y >= top && y < bottom;
            const std::uint32_t texel = texture.pixels[texel_of(place_on_tile(0.01 + y * 0.003), height)];
            ASSERT_EQ(pixels[static_cast<std::size_t>(y)], is_in ? texel : 7) << height << " row " << y;
            any |= is_in ? texel : 0;
        }
        EXPECT_EQ(read_walls(wall), any);
        for (std::uint32_t& texel : texture.pixels) texel &= 0x00FFFFFFu;
        EXPECT_EQ(read_walls(wall) >> 24, 0u);
    }
}

TEST(LayWalls, LaysTexelsInTheirLightOverWhatIsThere) {
    Texture texture = numbered(1, 72);
    for (std::uint32_t i = 0; i < 72; ++i) texture.pixels[i] = (i % 3 * 100) << 24 | i * 3 << 8;
    const int top = 5, bottom = 50;
    const TileSteps at_row_0 = tile_steps(0.01), per_row = tile_steps(0.003);
    const std::uint32_t first_texel = 0;
    const Shade shade = 100;
    std::vector<std::uint32_t> pixels(60, 0xFF808080u);
    lay_walls({{pixels.data(), 0, 1, &top, &bottom}, &texture, &first_texel, &at_row_0, &per_row, &shade, nullptr});
    for (int y = 0; y < 60; ++y) {
        const std::uint32_t texel = texture.pixels[texel_of(place_on_tile(0.01 + y * 0.003), 72)];
        const std::uint32_t above = (shaded(texel, shade) & 0x00FFFFFFu) | (texel & 0xFF000000u);
        const bool is_in = y >= top && y < bottom;
        ASSERT_EQ(pixels[static_cast<std::size_t>(y)], is_in ? laid_over(0xFF808080u, above) : 0xFF808080u) << y;
    }
}

/// One column of a flat, however far.
std::vector<std::uint32_t> far_flat(const Texture& texture, double base_u, double base_v, double step_u, double step_v,
                                    double farthest, const std::vector<double>& depths) {
    const int top = 0, bottom = static_cast<int>(depths.size());
    const std::vector<std::uint32_t> darkness(depths.size(), darkness_of(nullptr, 256));
    std::vector<std::uint32_t> pixels(depths.size());
    fill_far_flats({{pixels.data(), 0, 1, &top, &bottom},
                    &texture,
                    base_u,
                    base_v,
                    &step_u,
                    &step_v,
                    &farthest,
                    depths.data(),
                    darkness.data(),
                    nullptr});
    return pixels;
}

TEST(FillFarFlats, RoundToTheEdgesOfTexels) {
    const Texture texture = numbered(64, 32);
    for (const double off : {-1e-11, 0.0, 1e-11}) {
        const auto pixels = far_flat(texture, 0.5, 0.25, 11.0 / 64 - off, -3.0 / 32 + off, 1, {1.0});
        EXPECT_EQ(pixels[0] >> 12 & 0xFFF, 43u) << off;
        EXPECT_EQ(pixels[0] & 0xFFF, 5u) << off;
    }
}

/// Rooms, and a tile of a hand's breadth at the far end of the world.
TEST(FillFarFlats, ShowTheTexelUnderEachRow) {
    const Texture texture = numbered(64, 32);
    const std::vector<double> depths{0.5, 1.25, 2, 7.75, 31.3, 1e4, 123456.7};
    const auto pixels = far_flat(texture, 0.3, 0.6, 141.3, -227.7, 2e5, depths);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_EQ(pixels[i] >> 12 & 0xFFF, texel_of(place_on_tile(0.3 + depths[i] * 141.3), 64)) << i;
        EXPECT_EQ(pixels[i] & 0xFFF, texel_of(place_on_tile(0.6 - depths[i] * 227.7), 32)) << i;
    }
}

TEST(FillFarFlats, StayInTheTextureForAnyStepAndDepth) {
    const Texture texture = numbered(3, 5);
    const std::vector<double> depths{0, 1, 1e9, 1e300, std::numeric_limits<double>::infinity()};
    for (double step : {0.0, 1e-9, -0.7, 1e3, -1e9, 1e200})
        for (std::uint32_t pixel : far_flat(texture, 0.25, 0.99, step, -step, 1e5, depths)) {
            EXPECT_LT(pixel >> 12 & 0xFFF, 3u);
            EXPECT_LT(pixel & 0xFFF, 5u);
        }
}

TEST(FillSky, BeginsAgainBelowWhereItsRowsAreStraight) {
    const Texture texture = numbered(1, 10);
    std::vector<double> rises;
    for (int y = 0; y < 60; ++y) rises.push_back(30 - y);
    std::vector<std::uint32_t> pixels(60);
    scalar_kernels().fill_sky({pixels.data(), 0, 60},
                              {texture.pixels.data(), 10, 1, kNearTiles, -0.0625, rises.data()});
    EXPECT_EQ(pixels[0] & 0xFFF, 0u);
    EXPECT_EQ(pixels[29] & 0xFFF, 9u);
    EXPECT_EQ(pixels[30] & 0xFFF, 0u);
    EXPECT_EQ(pixels[46] & 0xFFF, 0u);
    EXPECT_EQ(pixels[45] & 0xFFF, 9u);
}

TEST(FillSky, HoldsItsFirstAndLastRowBeyondThePicture) {
    const Texture texture = numbered(1, 10);
    std::vector<double> rises;
    for (int y = 0; y < 60; ++y) rises.push_back(30 - y);
    std::vector<std::uint32_t> pixels(60);
    scalar_kernels().fill_sky({pixels.data(), 0, 60}, {texture.pixels.data(), 10, 1, kLastPlace, -0.05, rises.data()});
    EXPECT_EQ(pixels[0] & 0xFFF, 0u);
    EXPECT_EQ(pixels[29] & 0xFFF, 9u);
    EXPECT_EQ(pixels[59] & 0xFFF, 9u);
    for (int y = 1; y < 60; ++y) EXPECT_LE(pixels[y - 1] & 0xFFF, pixels[y] & 0xFFF);
}

TEST(LaySky, MixesWhatIsThereByItsAlpha) {
    const std::vector<std::uint32_t> texels{0x00FFFFFFu, 0x80FF0000u, 0xFF0000FFu};
    std::vector<std::uint32_t> pixels(3, 0xFF204060u);
    const std::vector<double> rises{2.5, 1.5, 0.5};
    lay_sky({pixels.data(), 0, 3}, {texels.data(), 3, 1, kLastPlace, -1.0 / 3, rises.data()});
    EXPECT_EQ(pixels[0], 0xFF204060u);
    EXPECT_EQ(pixels[1], laid_over(0xFF204060u, 0x80FF0000u));
    EXPECT_EQ(pixels[2], 0xFF0000FFu);
}

}  // namespace
}  // namespace enfilade::column
