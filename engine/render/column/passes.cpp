#include "render/column/kernels.h"

#include <algorithm>

namespace enfilade::column {
namespace {

void mix_cells(const LightCell* a, const LightCell* b, std::uint32_t part, const LightRow& to) {
    for (int i = 0; i < to.count; ++i) {
        const LightCell cell = between(a[i], b[i], part);
        to.red_blue[i] = static_cast<std::uint32_t>(cell);
        to.green[i] = static_cast<std::uint32_t>(cell >> 32);
    }
}

LightCell cell_at(const LightRow& cells, std::int64_t i) { return cells.red_blue[i] | LightCell{cells.green[i]} << 32; }

/// The light at a position among the cells, which is counted on even where it is far outside them.
LightCell light_at(const WallLamplight& lamplight, std::uint64_t position) {
    const std::int64_t last = (std::int64_t{lamplight.cells.count - 1} << 32) - 1;
    const std::int64_t at = std::clamp(static_cast<std::int64_t>(position), std::int64_t{0}, last);
    const std::int64_t cell = at >> 32;
    return between(cell_at(lamplight.cells, cell), cell_at(lamplight.cells, cell + 1),
                   static_cast<std::uint32_t>(at >> 24) & 0xFF);
}

LightCell light_at(const FlatLamplight& lamplight, int row) {
    const double depth =
        lamplight.row_depths[row] < lamplight.farthest ? lamplight.row_depths[row] : lamplight.farthest;
    return light_between(*lamplight.grid,
                         grid_step(lamplight.base_u + depth * lamplight.step_u, lamplight.grid->columns),
                         grid_step(lamplight.base_v + depth * lamplight.step_v, lamplight.grid->rows));
}

void light_pixel(const LitRun& to, int i, Shade shade, LightCell light) {
    std::uint32_t& pixel = to.run.pixels[i];
    pixel = to.texels ? lit_above(pixel, to.texels[i], shade, light) : lit(pixel, shade, light);
}

void light_wall(const LitRun& to, const WallLamplight& lamplight) {
    std::uint64_t position = lamplight.at_row_0 + lamplight.per_row * static_cast<std::uint64_t>(to.run.first_row);
    for (int i = 0; i < to.run.count; ++i, position += lamplight.per_row)
        light_pixel(to, i, lamplight.shade, light_at(lamplight, position));
}

void light_flat(const LitRun& to, const FlatLamplight& lamplight) {
    for (int i = 0; i < to.run.count; ++i) {
        const int row = to.run.first_row + i;
        light_pixel(to, i, lamplight.row_shades[row], light_at(lamplight, row));
    }
}

void add_fog(const Run& run, std::uint32_t fog, const FogPart* fog_parts) {
    for (int i = 0; i < run.count; ++i) run.pixels[i] = fogged(run.pixels[i], fog, fog_parts[i]);
}

void blend(const Run& run, const std::uint32_t* above) {
    for (int i = 0; i < run.count; ++i)
        if (above[i] >> 24 != 0) run.pixels[i] = laid_over(run.pixels[i], above[i]);
}

constexpr Passes kScalar{{mix_cells, light_wall, light_flat}, add_fog, blend};

}  // namespace

const Passes& scalar_passes() { return kScalar; }

Passes passes_beside(const PlainKernels& kernels) {
    const auto eight_wide = eight_wide_kernels();
    return eight_wide && kernels.name == eight_wide->name ? eight_wide_passes().value_or(kScalar) : kScalar;
}

}  // namespace enfilade::column
