// The inner loops for one, four and eight pixels at a time, drawn and as painted: the same bits, for all lengths,
// places and pictures.
#include "render/column/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "base/hash.h"

namespace enfilade::column {
namespace {

constexpr int kRows = 97, kColumns = 7;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Texture random_texture(Random& random) {
    constexpr std::uint32_t kSides[] = {1, 2, 3, 5, 8, 63, 64, 65, 100, 128};
    Texture texture;
    texture.width = kSides[random.below(std::size(kSides))];
    texture.height = kSides[random.below(std::size(kSides))];
    for (std::uint32_t i = 0; i < texture.width * texture.height; ++i)
        texture.pixels.push_back(static_cast<std::uint32_t>(random.bits()));
    return texture;
}

/// Colours in a row, and what becomes of them at 32 levels: anything.
ColorTable random_table(Random& random, Texture& texture) {
    Texture picture;
    picture.width = 200;
    picture.height = ColorTable::kLevels + 1;
    for (std::uint32_t i = 0; i < picture.width * picture.height; ++i)
        picture.pixels.push_back(0xFF000000u | static_cast<std::uint32_t>(random.below(1 << 24)));
    ColorTable table = ColorTable::read(picture).value();
    for (std::uint32_t& texel : texture.pixels) texel = picture.at(static_cast<std::uint32_t>(random.below(200)), 0);
    texture.numbers = table.numbers_in(texture);
    return table;
}

/// What runs are drawn from and into. Some columns are empty, some short; neighbours must stay as they are.
struct Bench {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(kColumns * kRows, 0x12345678u);
    std::vector<int> tops, bottoms;

    explicit Bench(Random& random) {
        for (int i = 0; i < kColumns; ++i) {
            tops.push_back(static_cast<int>(random.below(kRows)));
            const bool is_short = random.below(3) == 0;
            const int most = is_short ? std::min(tops.back() + 10, kRows) : kRows;
            bottoms.push_back(tops.back() + static_cast<int>(random.below(most - tops.back() + 1)));
        }
    }
    ColumnRuns runs() { return {pixels.data(), kRows, kColumns, tops.data(), bottoms.data()}; }
};

std::vector<PlainKernels> fast_kernels() {
    std::vector<PlainKernels> kernels;
    if (const auto four = four_wide_kernels()) kernels.push_back(*four);
    if (const auto eight = eight_wide_kernels()) kernels.push_back(*eight);
    return kernels;
}

/// Steps of whole texels but for the last places: there runs change from one way of drawing to another.
TileSteps about_whole_texels(Random& random, std::uint32_t height) {
    const TileSteps texels = ~TileSteps{0} / height * (1 + random.below(3));
    const TileSteps off = random.bits() >> (20 + random.below(44));
    return random.below(2) == 0 ? texels + off : texels - off;
}

/// Draws with the scalar kernels and with each other, and compares all pixels.
template <class Draw>
void expect_same_bits(const Bench& bench, const Draw& draw, int trial) {
    Bench scalar = bench;
    draw(scalar_kernels(), scalar.runs());
    for (const PlainKernels& kernels : fast_kernels()) {
        Bench fast = bench;
        draw(kernels, fast.runs());
        ASSERT_EQ(fast.pixels, scalar.pixels) << kernels.name << ", trial " << trial;
    }
}

// hard cases D5, I13
TEST(PlainKernels, DrawWallsAsTheScalarOnesDo) {
    Random random(1);
    for (int trial = 0; trial < 4000; ++trial) {
        Texture texture = random_texture(random);
        const bool has_table = random.below(2) == 0;
        const ColorTable table = random_table(random, texture);
        std::vector<std::uint32_t> first_texels;
        std::vector<TileSteps> v_at_row_0, v_per_row;
        std::vector<Shade> shades;
        for (int i = 0; i < kColumns; ++i) {
            first_texels.push_back(static_cast<std::uint32_t>(random.below(texture.width)) * texture.height);
            // Every second step is a round part of the tile, so that places lie on texels' very edges, or so little
            // before them that they are rounded up.
            const TileSteps before_edge = random.below(2) == 0 ? 0 : random.below(kHalfPlace);
            v_at_row_0.push_back(trial % 2 ? random.bits() : (random.below(256) << 56) - before_edge);
            v_per_row.push_back(trial % 2 ? random.bits() >> random.below(64) : random.below(256) << 54);
            if (random.below(4) == 0) {
                v_at_row_0.back() = about_whole_texels(random, texture.height) - before_edge;
                v_per_row.back() = about_whole_texels(random, texture.height);
            }
            shades.push_back(static_cast<Shade>(random.below(257)));
        }
        const Bench bench(random);
        const auto walls = [&](const ColumnRuns& runs) {
            return PlainWalls{runs,
                              &texture,
                              first_texels.data(),
                              v_at_row_0.data(),
                              v_per_row.data(),
                              shades.data(),
                              has_table ? &table : nullptr};
        };
        expect_same_bits(
            bench, [&](const PlainKernels& kernels, const ColumnRuns& runs) { kernels.fill_walls(walls(runs)); },
            trial);
        // Laid over as a fence is: most texels are there or not.
        for (std::uint32_t& texel : texture.pixels)
            if (trial % 3 != 0 && random.below(8) != 0) texel = (texel >> 31 ? 0xFF000000u : 0) | (texel & 0x00FFFFFFu);
        expect_same_bits(
            bench, [&](const PlainKernels& kernels, const ColumnRuns& runs) { kernels.lay_walls(walls(runs)); }, trial);
        std::uint32_t any = 0;
        expect_same_bits(
            bench,
            [&](const PlainKernels& kernels, const ColumnRuns& runs) {
                const std::uint32_t read = kernels.read_walls(walls(runs));
                if (kernels.name == "scalar") any = read;
                EXPECT_EQ(read, any) << kernels.name << ", trial " << trial;
            },
            trial);
    }
}

// hard cases D5, I13
TEST(PlainKernels, DrawFlatsAsTheScalarOnesDo) {
    Random random(2);
    for (int trial = 0; trial < 4000; ++trial) {
        Texture texture = random_texture(random);
        const ColorTable all_colors = random_table(random, texture);
        const ColorTable* const table = random.below(2) == 0 ? &all_colors : nullptr;
        std::vector<double> depths, step_u, step_v, farthest;
        std::vector<std::uint32_t> darkness;
        for (int row = 0; row < kRows + kRowsBeyond; ++row) {
            depths.push_back(random.below(20) == 0 ? kInfinity : random.uniform(0, 3000));
            darkness.push_back(darkness_of(table, static_cast<Shade>(random.below(257))));
        }
        for (int i = 0; i < kColumns; ++i) {
            farthest.push_back(random.below(4) == 0 ? random.uniform(0, 10) : 3000);
            const double most = random.below(2) == 0 ? 1 : (kNearTiles - 1) / 3000;
            step_u.push_back(trial % 2 ? random.uniform(-most, most) : static_cast<double>(random.below(9)) / 64);
            step_v.push_back(trial % 2 ? random.uniform(-most, most) : -static_cast<double>(random.below(9)) / 64);
        }
        const double base_u = trial % 2 ? random.uniform(0, 1) : 0.25, base_v = trial % 2 ? random.uniform(0, 1) : 0;
        if (trial % 2 == 0)
            for (double& depth : depths) depth = depth == kInfinity ? depth : std::floor(depth);
        const Bench bench(random);
        const auto flats = [&](const ColumnRuns& runs) {
            return PlainFlats{runs,          &texture,        base_u,        base_v,          step_u.data(),
                              step_v.data(), farthest.data(), depths.data(), darkness.data(), table};
        };
        expect_same_bits(
            bench, [&](const PlainKernels& kernels, const ColumnRuns& runs) { kernels.fill_flats(flats(runs)); },
            trial);
        expect_same_bits(
            bench, [&](const PlainKernels& kernels, const ColumnRuns& runs) { kernels.read_flats(flats(runs)); },
            trial);
    }
}

// hard case D5
TEST(PlainKernels, DrawSkiesAsTheScalarOneDoes) {
    Random random(4);
    for (int trial = 0; trial < 4000; ++trial) {
        const Texture texture = random_texture(random);
        std::vector<double> rises;
        const double horizon = trial % 2 ? random.uniform(-50, 150) : static_cast<double>(random.below(100));
        for (int row = 0; row < kRows; ++row) rises.push_back(horizon - row);
        // Round parts of the picture lie on texels' very edges; its ends are mostly in view.
        const double texel = -std::ldexp(static_cast<double>(about_whole_texels(random, texture.height)), -64);
        const double per_rise = trial % 5 == 0 ? texel : trial % 2 ? random.uniform(-0.1, 0.1) : -1.0 / 64;
        const SkyRun sky{texture.pixels.data(),
                         texture.height,
                         trial % 2 ? random.uniform(0, 1) : 1,
                         trial % 3 ? kLastPlace : kNearTiles,
                         per_rise,
                         rises.data()};
        const Bench bench(random);
        expect_same_bits(
            bench,
            [&](const PlainKernels& kernels, const ColumnRuns& runs) {
                for (int i = 0; i < runs.count; ++i)
                    kernels.fill_sky(
                        {runs.pixels + i * runs.pitch + runs.tops[i], runs.tops[i], runs.bottoms[i] - runs.tops[i]},
                        sky);
            },
            trial);
    }
}

TEST(NearTileSteps, AreThoseOfAnyNumberToWithinTwo) {
    Random random(3);
    for (int trial = 0; trial < 100000; ++trial) {
        const double most = std::ldexp(1.0, static_cast<int>(random.below(60)) - 40);
        const double tiles = random.uniform(-most, most);
        const auto off = static_cast<std::int64_t>(near_tile_steps(tiles) - tile_steps(tiles));
        // tile_steps() takes the part of a tile below 0 from 1, which rounds it to 2^-53.
        ASSERT_LE(std::abs(off), tiles < 0 ? 1 << 11 : 2) << tiles;
    }
    for (const double tiles : {0.0, 0.5, -0.5, 17.25, kNearTiles, -kNearTiles})
        EXPECT_EQ(near_tile_steps(tiles), tile_steps(tiles)) << tiles;
}

/// Every x86-64 has SSE2; whatever else there is can be named.
TEST(KernelsNamed, AreThoseThisProcessorCanRun) {
    EXPECT_EQ(kernels_named("scalar").value().fill_flats, scalar_kernels().fill_flats);
    EXPECT_FALSE(kernels_named("mmx"));
    for (const PlainKernels& kernels : fast_kernels())
        EXPECT_EQ(kernels_named(kernels.name).value().fill_flats, kernels.fill_flats);
}

TEST(ChosenKernels, AreThoseTheEnvironmentNames) {
    ASSERT_EQ(setenv("ENFILADE_KERNELS", "scalar", 1), 0);
    EXPECT_EQ(chosen_kernels().name, "scalar");
    EXPECT_TRUE(check_kernels().ok());
    ASSERT_EQ(setenv("ENFILADE_KERNELS", "mmx", 1), 0);
    const Result<void> result = check_kernels();
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("scalar), found mmx"), std::string::npos) << result.error().text();
    ASSERT_EQ(setenv("ENFILADE_KERNELS", "", 1), 0);
    EXPECT_TRUE(check_kernels().ok());
    ASSERT_EQ(unsetenv("ENFILADE_KERNELS"), 0);
    EXPECT_TRUE(check_kernels().ok());
}

}  // namespace
}  // namespace enfilade::column
