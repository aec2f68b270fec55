// The scalar kernels, which say what is drawn, and the choice among all that this processor can run. Whoever links
// other ones of these names draws by them (tests/bench/flagged_kernels.cpp): nothing else may be defined here.
#include "render/column/kernels.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace enfilade::column {
namespace {

void fill_walls(const PlainWalls& w) {
    for (int i = 0; i < w.runs.count; ++i) {
        const std::uint32_t darkness = darkness_of(w.color_table, w.shades[i]);
        for (int y = w.runs.tops[i]; y < w.runs.bottoms[i]; ++y) {
            const TileSteps v = w.v_at_row_0[i] + w.v_per_row[i] * static_cast<TileSteps>(y) + kHalfPlace;
            const std::uint32_t row = texel_of(static_cast<TilePlace>(v >> 32), w.texture->height);
            w.runs.pixels[i * w.runs.pitch + y] =
                darkened(w.color_table, *w.texture, w.first_texels[i] + row, darkness);
        }
    }
}

void fill_flats(const PlainFlats& f) {
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const double depth = f.row_depths[y] < f.farthest[i] ? f.row_depths[y] : f.farthest[i];
            const std::uint32_t u = texel_of(place_on_near_tile(f.base_u + depth * f.step_u[i]), f.texture->width);
            const std::uint32_t v = texel_of(place_on_near_tile(f.base_v + depth * f.step_v[i]), f.texture->height);
            f.runs.pixels[i * f.runs.pitch + y] =
                darkened(f.color_table, *f.texture, std::size_t{u} * f.texture->height + v, f.row_darkness[y]);
        }
}

void fill_sky(const Run& run, const SkyRun& sky) {
    for (int i = 0; i < run.count; ++i) {
        const double v = sky.v_at_horizon + sky.row_rises[run.first_row + i] * sky.v_per_rise;
        run.pixels[i] = sky.texels[texel_of(place_on_sky(v, sky.last), sky.height)] | 0xFF000000u;
    }
}

constexpr PlainKernels kScalar{"scalar", fill_walls, fill_flats, fill_sky, read_walls, lay_walls, read_far_flats};

}  // namespace

TileSteps tile_steps(double tiles) { return static_cast<TileSteps>(fraction(tiles) * 0x1p64); }

const PlainKernels& scalar_kernels() { return kScalar; }

// Which kernels draw.

namespace {

constexpr const char* kVariable = "ENFILADE_KERNELS";

/// Fastest first.
std::vector<PlainKernels> available_kernels() {
    std::vector<PlainKernels> kernels;
    if (const auto eight = eight_wide_kernels()) kernels.push_back(*eight);
    if (const auto four = four_wide_kernels()) kernels.push_back(*four);
    kernels.push_back(kScalar);
    return kernels;
}

/// What the environment variable names; empty where it is empty or not set.
std::string_view wanted_name() {
    const char* const name = std::getenv(kVariable);
    return name ? name : "";
}

}  // namespace

std::optional<PlainKernels> kernels_named(std::string_view name) {
    for (const PlainKernels& kernels : available_kernels())
        if (kernels.name == name) return kernels;
    return {};
}

PlainKernels chosen_kernels() { return kernels_named(wanted_name()).value_or(available_kernels().front()); }

Result<void> check_kernels() {
    const std::string_view name = wanted_name();
    if (name.empty() || kernels_named(name)) return {};
    std::string known;
    for (const PlainKernels& kernels : available_kernels())
        known += (known.empty() ? "" : ", ") + std::string(kernels.name);
    return Error{kVariable, "expected kernels that this processor can run (" + known + "), found " + std::string(name)};
}

}  // namespace enfilade::column
