// The inner loops: every texel in range, runs independent of where they start.
#include "render/column/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
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
            ASSERT_EQ(pixels[y] & 0xFFF, texel_of(place_on_tile(v0 + y * per_row), height)) << height << " row " << y;
    }
}

/// Rounding puts what should be at the edge between two texels a little to either side of it.
TEST(FillWall, RoundsToTheEdgesOfTexels) {
    const Texture texture = numbered(1, 64);
    std::uint32_t pixel = 0;
    for (const double off : {-1e-11, 0.0, 1e-11}) {
        fill_wall({&pixel, 0, 1}, {texture.pixels.data(), 64, tile_steps(17.0 / 64 + off), 0, 256});
        EXPECT_EQ(pixel & 0xFFF, 17u) << off;
    }
}

TEST(FillFlat, RoundsToTheEdgesOfTexels) {
    const Texture texture = numbered(64, 32);
    const double depth = 1;
    const Shade shade = 256;
    std::uint32_t pixel = 0;
    for (const double off : {-1e-11, 0.0, 1e-11}) {
        fill_flat({&pixel, 0, 1}, {&texture, 0.5, 0.25, 11.0 / 64 - off, -3.0 / 32 + off, 1, &depth, &shade});
        EXPECT_EQ(pixel >> 12 & 0xFFF, 43u) << off;
        EXPECT_EQ(pixel & 0xFFF, 5u) << off;
    }
}

/// A tile of a hand's breadth at the far end of the world.
TEST(FillFlat, ShowsTheTexelsOfFarTiles) {
    const Texture texture = numbered(64, 32);
    const std::vector<double> depths{0.5, 1e4, 123456.7};
    const std::vector<Shade> shades(depths.size(), 256);
    std::vector<std::uint32_t> pixels(depths.size());
    fill_flat({pixels.data(), 0, 3}, {&texture, 0.3, 0.6, 141.3, -227.7, 2e5, depths.data(), shades.data()});
    for (std::size_t i = 0; i < depths.size(); ++i) {
        EXPECT_EQ(pixels[i] >> 12 & 0xFFF, texel_of(place_on_tile(0.3 + depths[i] * 141.3), 64)) << i;
        EXPECT_EQ(pixels[i] & 0xFFF, texel_of(place_on_tile(0.6 - depths[i] * 227.7), 32)) << i;
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
        EXPECT_EQ(pixels[i] >> 12 & 0xFFF, texel_of(place_on_tile(0.3 + depths[i] * 0.41), 64)) << i;
        EXPECT_EQ(pixels[i] & 0xFFF, texel_of(place_on_tile(0.6 - depths[i] * 0.27), 32)) << i;
    }
}

TEST(FillSky, HoldsItsFirstAndLastRowBeyondThePicture) {
    const Texture texture = numbered(1, 10);
    std::vector<double> rises;
    for (int y = 0; y < 60; ++y) rises.push_back(30 - y);
    std::vector<std::uint32_t> pixels(60);
    scalar_kernels().fill_sky({pixels.data(), 0, 60}, {texture.pixels.data(), 10, 1, -0.05, rises.data()});
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

/// A pool of light with a dark rim on some sides, as it lies on a floor.
LightGrid random_pool(Random& random) {
    LightGrid pool{0, 0, 5, 6, {}};
    pool.is_dark_before_u = random.below(2) == 0;
    pool.is_dark_after_u = random.below(2) == 0;
    pool.is_dark_before_v = random.below(2) == 0;
    pool.is_dark_after_v = random.below(2) == 0;
    for (int column = 0; column < 5; ++column)
        for (int row = 0; row < 6; ++row) {
            const bool is_rim = (column == 0 && pool.is_dark_before_u) || (column == 4 && pool.is_dark_after_u) ||
                                (row == 0 && pool.is_dark_before_v) || (row == 5 && pool.is_dark_after_v);
            const auto light = static_cast<std::uint32_t>(random.below(is_rim ? kLightSteps : 4000));
            pool.cells.push_back(light_cell(light, light / 2, light / 3));
        }
    return pool;
}

TEST(FillLitFlat, LightsEachPixelByItsPlaceWhereverTheLightEnds) {
    const Texture texture = numbered(64, 32);
    Random random(11);
    for (int trial = 0; trial < 500; ++trial) {
        const LightGrid pool = random_pool(random);
        std::vector<double> depths(60);
        std::vector<Shade> shades(60);
        for (std::size_t i = 0; i < 60; ++i) {
            depths[i] = 40.0 / static_cast<double>(i + 1 + random.below(3));
            shades[i] = static_cast<Shade>(random.below(257));
        }
        const auto number = [&] { return static_cast<double>(random.below(1000)) / 100 - 5; };
        const FlatRun flat{&texture, 0.3, 0.6, number(), number(), 20, depths.data(), shades.data()};
        const FlatGlow glow{&pool, number(), number(), number() / 4, number() / 4};
        std::vector<std::uint32_t> plain(60), lit_up(60);
        const std::vector<Shade> bright(60, 256);
        FlatRun painted = flat;
        painted.row_shades = bright.data();
        fill_flat({plain.data(), 0, 60}, painted);
        fill_lit_flat({lit_up.data(), 0, 60}, flat, glow);
        for (std::size_t i = 0; i < 60; ++i) {
            const double depth = std::min(depths[i], 20.0);
            const GridStep across = grid_step(glow.base_u + depth * glow.step_u, 5);
            const GridStep along = grid_step(glow.base_v + depth * glow.step_v, 6);
            ASSERT_EQ(lit_up[i], lit(plain[i], shades[i], light_between(pool, across, along))) << trial << " " << i;
        }
    }
}

/// The light at a row, by the definition.
LightCell light_at_row(const std::vector<LightCell>& cells, const WallGlow& glow, int row) {
    const auto position = static_cast<std::int64_t>(glow.at_row_0 + glow.per_row * static_cast<std::uint64_t>(row));
    const std::int64_t last = (static_cast<std::int64_t>(cells.size() - 1) << 32) - 1;
    const std::int64_t at = std::clamp(position, std::int64_t{0}, last);
    const auto cell = static_cast<std::size_t>(at >> 32);
    return between(cells[cell], cells[cell + 1], static_cast<std::uint32_t>(at >> 24) & 0xFF);
}

TEST(FillLitWall, LightsEachPixelByItsPlaceAsFarAsAnyLightReaches) {
    Random random(12);
    for (int trial = 0; trial < 2000; ++trial) {
        Texture texture = numbered(1, 77);
        for (std::uint32_t& texel : texture.pixels)
            texel = static_cast<std::uint32_t>(random.bits()) & (random.below(3) == 0 ? 0x00FFFFFFu : 0xFFFFFFFFu);
        std::vector<LightCell> cells;
        const auto channel = [&] { return static_cast<std::uint32_t>(random.below(kMostLight + 1)); };
        const std::size_t count = 2 + random.below(trial % 10 == 0 ? 90 : 8);
        for (std::size_t i = 0; i < count; ++i) cells.push_back(light_cell(channel(), channel(), channel()));
        const double place = random.uniform(-2, 10), step = random.uniform(0, 0.3);  // mostly beyond both ends
        const WallGlow glow{cells.data(), static_cast<int>(count), tile_steps(place / 4294967296.0),
                            tile_steps(step / 4294967296.0)};
        const WallRun wall{texture.pixels.data(),
                           77,
                           tile_steps(random.uniform(0, 1)),
                           tile_steps(random.uniform(0, 0.1)),
                           static_cast<Shade>(random.below(257)),
                           static_cast<Mist>(random.below(2) * random.below(257)),
                           0xFF80FF40u};
        const int rows = static_cast<int>(random.below(40)), first = static_cast<int>(random.below(100));
        const std::vector<std::uint32_t> before(40, 0xFF104070u);
        std::vector<std::uint32_t> filled = before, laid = before;
        fill_lit_wall({filled.data(), first, rows}, wall, glow);
        lay_lit_wall({laid.data(), first, rows}, wall, glow);
        for (int i = 0; i < 40; ++i) {
            const TileSteps v = wall.v_at_row_0 + wall.v_per_row * static_cast<TileSteps>(first + i) + kHalfPlace;
            const std::uint32_t texel = texture.pixels[texel_of(static_cast<TilePlace>(v >> 32), 77)];
            const std::uint32_t clear = lit(texel, wall.shade, light_at_row(cells, glow, first + i));
            const std::uint32_t color = misted(clear, wall.fog, wall.mist);
            const std::uint32_t over = laid_over(before[i], (color & 0x00FFFFFFu) | (texel & 0xFF000000u));
            ASSERT_EQ(filled[i], i < rows ? color : before[i]) << trial << " row " << i;
            ASSERT_EQ(laid[i], i < rows && texel >> 24 != 0 ? over : before[i]) << trial << " row " << i;
        }
    }
}

TEST(FillLitWall, IsPlainInLightThatIsTooFaintToBeSeen) {
    const Texture texture = numbered(1, 77);
    const WallRun wall{texture.pixels.data(), 77, tile_steps(0.1), tile_steps(0.013), 200};
    const std::vector<LightCell> faint(4, light_cell(15, 7, 15)), seen{faint[0], faint[0], light_cell(1600, 0, 0), 0};
    const auto drawn = [&](const std::vector<LightCell>& cells) {
        std::vector<std::uint32_t> pixels(100);
        fill_lit_wall({pixels.data(), 0, 100}, wall, {cells.data(), 4, 0, tile_steps(0.03 * 0x1p-32)});
        return pixels;
    };
    std::vector<std::uint32_t> plain(100);
    fill_wall({plain.data(), 0, 100}, wall);
    EXPECT_EQ(drawn(faint), plain);
    EXPECT_NE(drawn(seen), plain);
}

}  // namespace
}  // namespace enfilade::column
