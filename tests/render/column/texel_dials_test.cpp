// Pixels that show several texels: the blend in closed form, and the inner loops pixel by pixel.
#include "render/column/texel_dials.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/hash.h"

namespace enfilade::column {
namespace {

constexpr std::uint32_t kBlack = 0xFF000000u, kWhite = 0xFFFFFFFFu;
constexpr Shade kFullBright = 256;

Texture picture(std::uint32_t width, std::uint32_t height, std::vector<std::uint32_t> pixels) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.pixels = std::move(pixels);
    return texture;
}

/// A chequer of 2 x 2 texels.
Texture chequer() { return picture(2, 2, {kBlack, kWhite, kWhite, kBlack}); }

std::uint32_t grey(std::uint32_t value) { return kBlack | value << 16 | value << 8 | value; }

TilePlace place(double tiles) { return place_on_tile(tiles); }

constexpr int kBlendedRows = 96;

/// One column of a wall, `u` and `v_per_row` in tiles, from the picture's top.
std::vector<std::uint32_t> wall_column(const Texture& texture, double u, double v_per_row,
                                       const Texture* smaller = nullptr, std::uint32_t part = 0) {
    std::vector<std::uint32_t> pixels(kBlendedRows, 0);
    const int top = 0, bottom = kBlendedRows;
    const TilePlace at = place(u);
    const TileSteps v = tile_steps(v_per_row / 2), step = tile_steps(v_per_row);
    const std::uint32_t none = 0;
    const Shade shade = kFullBright;
    fill_blended_walls({{pixels.data(), 0, 1, &top, &bottom}, &texture, &none, &v, &step, &shade, nullptr},
                       {&at, smaller, &part});
    return pixels;
}

/// One column of a floor from `depth` 0 on, one row a step along v.
std::vector<std::uint32_t> flat_column(const Texture& texture, double u, double v_per_row,
                                       const Texture* smaller = nullptr, std::uint32_t part = 0) {
    std::vector<std::uint32_t> pixels(kBlendedRows, 0), parts(kBlendedRows, part),
        darkness(kBlendedRows, kFullBright * 0x10001u);
    std::vector<double> depths(kBlendedRows);
    for (int y = 0; y < kBlendedRows; ++y) depths[static_cast<std::size_t>(y)] = y + 0.5;
    const int top = 0, bottom = kBlendedRows;
    const double still = 0, farthest = kBlendedRows;
    fill_blended_flats(NumberKind::real64,
                       {{pixels.data(), 0, 1, &top, &bottom},
                        &texture,
                        u,
                        0,
                        &still,
                        &v_per_row,
                        &farthest,
                        depths.data(),
                        darkness.data(),
                        nullptr},
                       {smaller, parts.data()});
    return pixels;
}

TEST(TexelsAround, AreThoseWhoseMiddlesAPlaceLiesBetween) {
    const auto expect = [](double tiles, std::uint32_t size, std::array<std::uint32_t, 3> expected) {
        const TexelPair pair = texels_around(place(tiles), size);
        EXPECT_EQ((std::array{pair.first, pair.second, pair.part}), expected) << tiles << " of " << size;
    };
    expect(0.5 / 8, 8, {0, 1, 0});
    expect(1.0 / 8, 8, {0, 1, 128});
    expect(1.25 / 8, 8, {0, 1, 192});
    expect(1.5 / 8, 8, {1, 2, 0});
    expect(0.75 / 5, 5, {0, 1, 64});
    // The picture repeats: left of the first middle and right of the last one.
    expect(0, 8, {7, 0, 128});
    expect(0.25 / 8, 8, {7, 0, 192});
    expect(7.75 / 8, 8, {7, 0, 64});
    expect(0.3, 1, {0, 0, 205});  // 0.8 of the way
    // To the nearest part, and into the next texel where that is the nearest.
    expect((0.5 + 0.4 / 256) / 8, 8, {0, 1, 0});
    expect((0.5 + 0.6 / 256) / 8, 8, {0, 1, 1});
    expect((0.5 - 0.4 / 256) / 8, 8, {0, 1, 0});
}

TEST(BlendedTexels, AreTheMeanByProductsOfWays) {
    const FourTexels texels{kBlack, kWhite, kWhite, kBlack};
    for (std::uint32_t across = 0; across < kBlendParts; ++across)
        for (std::uint32_t down = 0; down < kBlendParts; ++down) {
            const double x = across / 256.0, y = down / 256.0;
            const double white = x * (1 - y) + y * (1 - x);
            ASSERT_EQ(blended(texels, across, down), grey(static_cast<std::uint32_t>(std::floor(255 * white + 0.5))));
        }
    EXPECT_EQ(blended({0x00102030, 0x12345678, 0, 0}, 0, 64), 0xFF192E42u);  // (3 * 0x10 + 0x34) / 4, ...
}

TEST(BlendedTexels, LeaveOneColorAsItIs) {
    Random random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const std::uint32_t color = kBlack | static_cast<std::uint32_t>(random.below(1 << 24));
        const auto part = [&] { return static_cast<std::uint32_t>(random.below(kBlendParts)); };
        ASSERT_EQ(blended({color, color, color, color}, part(), part()), color);
        ASSERT_EQ(mixed(color, color, part()), color);
    }
}

TEST(MixedColors, AreOnAStraightLine) {
    EXPECT_EQ(mixed(kBlack, kWhite, 0), kBlack);
    EXPECT_EQ(mixed(kBlack, kWhite, 128), grey(128));  // 127.5, the half up
    EXPECT_EQ(mixed(0xFF000000u, 0xFF408001u, 64), 0xFF102000u);
}

TEST(BlendedRuns, ShowAMagnifiedChequerAsTheExactBlend) {
    const Texture texture = chequer();
    for (const double u : {0.0, 0.25, 0.375, 0.5, 0.75, 0.9375}) {
        const std::vector<std::uint32_t> wall = wall_column(texture, u, 1.0 / 64),
                                         flat = flat_column(texture, u, 1.0 / 64);
        for (int y = 0; y < kBlendedRows; ++y) {
            // White along one side is a zigzag between the middles of texels.
            const auto white_at = [](double tiles) {
                const double part = tiles + 0.25 - std::floor(tiles + 0.25);
                return 2 * std::min(part, 1 - part);  // 1 at 1/4 + 1/2
            };
            const double x = white_at(u), v = white_at((y + 0.5) / 64);
            const auto expected = grey(static_cast<std::uint32_t>(std::floor(255 * (x * (1 - v) + v * (1 - x)) + 0.5)));
            ASSERT_EQ(wall[static_cast<std::size_t>(y)], expected) << u << ", row " << y;
            ASSERT_EQ(flat[static_cast<std::size_t>(y)], expected) << u << ", row " << y;
        }
    }
}

TEST(BlendedRuns, GoOnFromTheLastTexelToTheFirst) {
    std::vector<std::uint32_t> pixels(8, kBlack);
    pixels[7] = kWhite;
    const Texture texture = picture(1, 8, pixels);
    const std::vector<std::uint32_t> wall = wall_column(texture, 0, 1.0 / 32), flat = flat_column(texture, 0, 1.0 / 32);
    // The last texel's middle is at row 30: four rows on either side are on the way to it, in the next tile, too.
    const std::uint32_t values[] = {96, 32, 0, 0};  // of rows 0 to 3: 3/8 and 1/8 of 255, the half up
    for (std::size_t y = 0; y < 4; ++y)
        for (const std::size_t tile : {std::size_t{0}, std::size_t{32}, std::size_t{64}}) {
            EXPECT_EQ(wall[tile + y], grey(values[y])) << tile + y;
            EXPECT_EQ(flat[tile + y], grey(values[y])) << tile + y;
        }
    EXPECT_EQ(wall[31], grey(159));  // 5/8
}

TEST(BlendedRuns, AtAWholeLevelAreBilinearInThatPicture) {
    const Texture large = picture(4, 4, std::vector<std::uint32_t>(16, 0xFF00FF80u)), small = chequer();
    const std::vector<std::uint32_t> at_large = wall_column(large, 0.3, 0.02), at_small = wall_column(small, 0.3, 0.02);
    EXPECT_EQ(wall_column(large, 0.3, 0.02, &small, 0), at_large);
    EXPECT_EQ(flat_column(large, 0.3, 0.02, &small, 0), flat_column(large, 0.3, 0.02));
    for (const std::uint32_t part : {1u, 100u, 255u}) {
        const std::vector<std::uint32_t> wall = wall_column(large, 0.3, 0.02, &small, part);
        const std::vector<std::uint32_t> flat = flat_column(large, 0.3, 0.02, &small, part);
        for (std::size_t y = 0; y < kBlendedRows; ++y) {
            ASSERT_EQ(wall[y], mixed(at_large[y], at_small[y], part)) << part << ", row " << y;
            ASSERT_EQ(flat[y], wall[y]) << part << ", row " << y;
        }
    }
}

/// Colours in a row, and what becomes of them at 32 levels: anything.
ColorTable random_blended_table(Random& random, Texture& texture) {
    Texture colors = picture(200, ColorTable::kLevels + 1, {});
    for (std::uint32_t i = 0; i < colors.width * colors.height; ++i)
        colors.pixels.push_back(kBlack | static_cast<std::uint32_t>(random.below(1 << 24)));
    ColorTable table = ColorTable::read(colors).value();
    for (std::uint32_t& texel : texture.pixels) texel = colors.at(static_cast<std::uint32_t>(random.below(200)), 0);
    texture.numbers = table.numbers_in(texture);
    return table;
}

// What inner loops do in wide registers is what blended(), mixed() and shaded() say, for any picture in any light.
TEST(BlendedRuns, AreTheDefinitionPixelByPixel) {
    Random random(2);
    for (int trial = 0; trial < 400; ++trial) {
        constexpr std::uint32_t kSides[] = {1, 2, 3, 5, 8, 63, 64, 100};
        Texture texture = picture(kSides[random.below(std::size(kSides))], kSides[random.below(std::size(kSides))], {});
        for (std::uint32_t i = 0; i < texture.width * texture.height; ++i)
            texture.pixels.push_back(static_cast<std::uint32_t>(random.bits()));
        const bool is_by_table = trial % 2 == 1;
        const ColorTable table = is_by_table ? random_blended_table(random, texture) : ColorTable();
        const Shade shade = static_cast<Shade>(random.below(257));
        const double u = random.uniform(0, 1), step = random.uniform(-0.1, 0.1);
        const auto color_at = [&](std::uint32_t x, std::uint32_t y) {
            const std::size_t i = std::size_t{x} * texture.height + y;
            return is_by_table ? darkened_colors(table, shade)[texture.numbers[i]] : texture.pixels[i];
        };
        std::vector<std::uint32_t> pixels(kBlendedRows, 0);
        const int top = static_cast<int>(random.below(kBlendedRows)), bottom = kBlendedRows;
        const TilePlace at = place(u);
        const TileSteps v = tile_steps(0.25), per_row = tile_steps(step);
        const std::uint32_t none = 0;
        fill_blended_walls({{pixels.data(), 0, 1, &top, &bottom},
                            &texture,
                            &none,
                            &v,
                            &per_row,
                            &shade,
                            is_by_table ? &table : nullptr},
                           {&at, nullptr, nullptr});
        const TexelPair across = texels_around(at, texture.width);
        for (int y = 0; y < kBlendedRows; ++y) {
            const TileSteps here = v + per_row * static_cast<TileSteps>(y) + kHalfPlace;
            const TexelPair down = texels_around(static_cast<TilePlace>(here >> 32), texture.height);
            const std::uint32_t color =
                blended({color_at(across.first, down.first), color_at(across.first, down.second),
                         color_at(across.second, down.first), color_at(across.second, down.second)},
                        across.part, down.part);
            ASSERT_EQ(pixels[static_cast<std::size_t>(y)], y < top       ? 0
                                                           : is_by_table ? color
                                                                         : shaded(color, shade))
                << "trial " << trial << ", row " << y;
        }
    }
}

}  // namespace
}  // namespace enfilade::column
