// Light of lamps, fog and holes on runs that are drawn: by their definition, and the same bits eight pixels at a time.
#include "render/column/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "base/hash.h"

namespace enfilade::column {
namespace {

constexpr int kPassRows = 300;  ///< more than passes keep places of at a time
constexpr std::uint32_t kUntouched = 0x12345678u;

std::uint32_t any_color(Random& random) { return static_cast<std::uint32_t>(random.bits()); }

LightCell any_light(Random& random) {
    const auto channel = [&] { return static_cast<std::uint32_t>(random.below(kMostLight + 1)); };
    return light_cell(channel(), channel(), channel());
}

/// A column of pixels, the run in it, and the same pixels as they were painted before a table darkened them.
struct Column {
    std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(kPassRows, kUntouched);
    std::vector<std::uint32_t> texels;
    int first = 0, count = 0;
    bool is_darkened = false;

    explicit Column(Random& random) {
        first = static_cast<int>(random.below(kPassRows));
        count = static_cast<int>(random.below(static_cast<std::uint64_t>(kPassRows - first) + 1));
        is_darkened = random.below(2) == 0;
        for (int i = 0; i < count; ++i) {
            pixels[static_cast<std::size_t>(first + i)] = any_color(random);
            texels.push_back(any_color(random));
        }
    }
    Run run() { return {pixels.data() + first, first, count}; }
    LitRun lit() { return {run(), is_darkened ? texels.data() : nullptr}; }
};

/// What becomes of each pixel of the run, in its row; all others stay.
void expect_each(Column column, const Passes& passes, const std::function<void(const Passes&, Column&)>& pass,
                 const std::function<std::uint32_t(int row, std::uint32_t pixel)>& wanted) {
    const Column before = column;
    pass(passes, column);
    for (int row = 0; row < kPassRows; ++row) {
        const std::uint32_t pixel = before.pixels[static_cast<std::size_t>(row)];
        const bool is_in = row >= before.first && row < before.first + before.count;
        ASSERT_EQ(column.pixels[static_cast<std::size_t>(row)], is_in ? wanted(row, pixel) : pixel) << "row " << row;
    }
}

class EachPasses : public testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        if (!GetParam()) return;
        if (!eight_wide_passes()) GTEST_SKIP() << "this processor has no AVX2";
        passes_ = *eight_wide_passes();
    }
    Passes passes_ = scalar_passes();
};
INSTANTIATE_TEST_SUITE_P(ScalarAndEightWide, EachPasses, testing::Bool());

/// As lit() and lit_above() have it.
std::uint32_t in_light(const Column& column, int row, std::uint32_t pixel, Shade shade, LightCell light) {
    const std::uint32_t texel = column.texels[static_cast<std::size_t>(row - column.first)];
    return column.is_darkened ? lit_above(pixel, texel, shade, light) : lit(pixel, shade, light);
}

TEST_P(EachPasses, MixTwoColumnsOfLight) {
    Random random(21);
    for (int trial = 0; trial < 500; ++trial) {
        const int count = 2 + static_cast<int>(random.below(30));
        std::vector<LightCell> a, b;
        for (int i = 0; i < count; ++i) {
            a.push_back(any_light(random));
            b.push_back(any_light(random));
        }
        const auto part = static_cast<LightPart>(random.below(1u << kLightPartBits));
        std::vector<std::uint32_t> red_blue(static_cast<std::size_t>(count + kCellsBeyond)), green = red_blue;
        passes_.lamps.mix_cells(a.data(), b.data(), part, {red_blue.data(), green.data(), count});
        for (std::size_t i = 0; i < a.size(); ++i)
            ASSERT_EQ(red_blue[i] | LightCell{green[i]} << 32, between(a[i], b[i], part)) << trial << " " << i;
    }
}

/// Points of light with room around them, which is not theirs.
struct Row {
    std::vector<LightCell> cells;
    std::vector<std::uint32_t> red_blue, green;

    explicit Row(Random& random, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) cells.push_back(any_light(random));
        for (std::size_t i = 0; i < count + 2 * kCellsBeyond; ++i) {
            const bool is_cell = i >= kCellsBeyond && i < count + kCellsBeyond;
            const LightCell cell = is_cell ? cells[i - kCellsBeyond] : random.bits();
            red_blue.push_back(static_cast<std::uint32_t>(cell));
            green.push_back(static_cast<std::uint32_t>(cell >> 32));
        }
    }
    LightRow row() {
        return {red_blue.data() + kCellsBeyond, green.data() + kCellsBeyond, static_cast<int>(cells.size())};
    }
    /// By the definition: beyond both ends as at them.
    LightCell at(std::uint64_t position) const {
        const std::int64_t last = (static_cast<std::int64_t>(cells.size() - 1) << 32) - 1;
        const std::int64_t at = std::clamp(static_cast<std::int64_t>(position), std::int64_t{0}, last);
        const auto cell = static_cast<std::size_t>(at >> 32);
        return between(cells[cell], cells[cell + 1], static_cast<std::uint32_t>(at) >> (32 - kLightPartBits));
    }
};

/// How far down the points a row is: mostly less than one, as near walls have it; also none, far walls, and upwards.
std::uint64_t any_way(Random& random) {
    const double steps[] = {0,
                            -random.uniform(0, 0.01),
                            -random.uniform(0, 0.2),
                            -random.uniform(0, 1),
                            -random.uniform(1, 40),
                            random.uniform(0, 2),
                            -1};
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(steps[random.below(std::size(steps))] * 0x1p32));
}

TEST_P(EachPasses, LightWallsByTheirPlaceAmongThePoints) {
    Random random(22);
    for (int trial = 0; trial < 4000; ++trial) {
        Row row(random, 2 + random.below(12));
        const auto shade = static_cast<Shade>(random.below(257));
        const auto from = static_cast<std::int64_t>(random.uniform(-6, 20) * 0x1p32);  // often beyond the ends
        const WallLamplight lamplight{shade, row.row(), static_cast<std::uint64_t>(from), any_way(random)};
        const Column column(random);
        expect_each(
            column, passes_, [&](const Passes& passes, Column& c) { passes.lamps.light_wall(c.lit(), lamplight); },
            [&](int y, std::uint32_t pixel) {
                const LightCell light = row.at(lamplight.at_row_0 + lamplight.per_row * static_cast<std::uint64_t>(y));
                return in_light(column, y, pixel, shade, light);
            });
    }
}

TEST_P(EachPasses, LightFlatsByTheirPlaceInTheGrid) {
    Random random(23);
    for (int trial = 0; trial < 3000; ++trial) {
        LightGrid grid{
            0, 0, kUsualLightPoints, 2 + static_cast<int>(random.below(6)), 2 + static_cast<int>(random.below(6)), {}};
        for (int i = 0; i < grid.columns * grid.rows; ++i) grid.cells.push_back(any_light(random));
        std::vector<double> depths;
        std::vector<std::uint32_t> shades;
        for (int y = 0; y < kPassRows + kRowsBeyond; ++y) {
            depths.push_back(y < trial % 20 ? std::numeric_limits<double>::infinity() : 40.0 / (y + 1));
            shades.push_back(darkness_of(nullptr, static_cast<Shade>(random.below(257))));
        }
        // Round numbers, so that some places are points.
        const auto number = [&] { return static_cast<double>(random.below(64)) / 8 - 4; };
        const double farthest = random.uniform(0, 30);
        // Sometimes about as far away as eight places at a time can be counted, or farther.
        const double away = random.below(8) == 0 ? (random.below(2) == 0 ? 1 : -1) * random.uniform(32750, 32800) : 0;
        const FlatLamplight lamplight{&grid,
                                      number() + away + kGridShift,
                                      number() + kGridShift,
                                      number() / 8,
                                      number() / 8,
                                      farthest,
                                      depths.data(),
                                      shades.data()};
        const Column column(random);
        expect_each(
            column, passes_, [&](const Passes& passes, Column& c) { passes.lamps.light_flat(c.lit(), lamplight); },
            [&](int y, std::uint32_t pixel) {
                const double depth = std::min(depths[static_cast<std::size_t>(y)], farthest);
                const GridStep across = grid_step_of_shifted(lamplight.base_u + depth * lamplight.step_u, grid.columns);
                const GridStep along = grid_step_of_shifted(lamplight.base_v + depth * lamplight.step_v, grid.rows);
                return in_light(column, y, pixel, shades[static_cast<std::size_t>(y)] & 0xFFFF,
                                light_between(grid, across, along));
            });
    }
}

TEST_P(EachPasses, HidePixelsInFog) {
    Random random(24);
    for (int trial = 0; trial < 500; ++trial) {
        const std::uint32_t fog = any_color(random);
        std::vector<FogPart> fog_parts;
        for (int y = 0; y < kPassRows + kRowsBeyond; ++y) fog_parts.push_back(static_cast<FogPart>(random.below(257)));
        const Column column(random);
        expect_each(
            column, passes_,
            [&](const Passes& passes, Column& c) { passes.add_fog(c.run(), fog, fog_parts.data() + c.first); },
            [&](int y, std::uint32_t pixel) { return fogged(pixel, fog, fog_parts[static_cast<std::size_t>(y)]); });
    }
}

TEST_P(EachPasses, LayPicturesWithHolesOverWhatIsThere) {
    Random random(25);
    for (int trial = 0; trial < 1000; ++trial) {
        const bool is_soft = random.below(2) == 0;
        constexpr std::uint32_t kAlphas[] = {0, 0, 254, 255, 255};
        Column column(random);
        std::vector<std::uint32_t> colors;
        for (std::uint32_t& texel : column.texels) {
            colors.push_back(any_color(random));
            if (!is_soft) texel = (texel & 0x00FFFFFFu) | kAlphas[random.below(std::size(kAlphas))] << 24;
        }
        expect_each(
            column, passes_,
            [&](const Passes& passes, Column& c) { passes.blend(c.run(), colors.data(), c.texels.data()); },
            [&](int y, std::uint32_t pixel) {
                const auto i = static_cast<std::size_t>(y - column.first);
                const std::uint32_t alpha = column.texels[i] & 0xFF000000u;
                return alpha == 0 ? pixel : laid_over(pixel, (colors[i] & 0x00FFFFFFu) | alpha);
            });
    }
}

TEST(PassesBesideKernels, AreAsWideAsThey) {
    EXPECT_EQ(passes_beside(scalar_kernels()).blend, scalar_passes().blend);
    if (const auto eight = eight_wide_kernels()) {
        EXPECT_EQ(passes_beside(*eight).blend, eight_wide_passes()->blend);
    }
}

}  // namespace
}  // namespace enfilade::column
