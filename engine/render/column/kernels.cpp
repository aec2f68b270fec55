// What is drawn one pixel at a time by all kernels: what few pixels need, and the scalar passes, which say what further
// passes do.
#include "render/column/kernels.h"

#include <algorithm>

namespace enfilade::column {

// What fewer pixels need: flats that are far away, walls with holes, and skies over skies.

namespace {

constexpr std::uint32_t kOpaque = 0xFF000000u;  // of a pixel, the bits of its alpha

template <bool kByShifts>
std::uint32_t read_walls_as(const PlainWalls& walls) {
    const RowNumber<kByShifts> row_at(walls.texture->height);
    std::uint32_t any = 0;
    for (int column = 0; column < walls.runs.count; ++column) {
        const WallColumn to = column_of(walls, column);
        const std::uint32_t* const texels = &walls.texture->pixels[walls.first_texels[column]];
        TileSteps v = to.v;
        for (int i = 0; i < to.count; ++i, v += to.step) any |= to.pixels[i] = texels[row_at(v)];
    }
    return any;
}

template <bool kByShifts>
void lay_walls_as(const PlainWalls& walls) {
    const RowNumber<kByShifts> row_at(walls.texture->height);
    for (int column = 0; column < walls.runs.count; ++column) {
        const WallColumn to = column_of(walls, column);
        const std::uint32_t darkness = darkness_of(walls.color_table, walls.shades[column]);
        TileSteps v = to.v;
        for (int i = 0; i < to.count; ++i, v += to.step) {
            const std::size_t texel = walls.first_texels[column] + row_at(v);
            const std::uint32_t alpha = walls.texture->pixels[texel] & kOpaque;
            if (alpha == 0) continue;
            const std::uint32_t color = darkened(walls.color_table, *walls.texture, texel, darkness);
            to.pixels[i] = alpha == kOpaque ? color | kOpaque : laid_over(to.pixels[i], (color & ~kOpaque) | alpha);
        }
    }
}

/// Which of its picture's texels a flat shows in row y of the i-th column, however far that is.
std::size_t texel_at(const PlainFlats& f, int i, int y) {
    const double depth = std::min(f.row_depths[y], f.farthest[i]);
    const std::uint32_t u = texel_of(place_on_tile(f.base_u + depth * f.step_u[i]), f.texture->width);
    const std::uint32_t v = texel_of(place_on_tile(f.base_v + depth * f.step_v[i]), f.texture->height);
    return std::size_t{u} * f.texture->height + v;
}

}  // namespace

void fill_far_flats(const PlainFlats& f) {
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const std::size_t texel = texel_at(f, i, y);
            f.runs.pixels[i * f.runs.pitch + y] = darkened(f.color_table, *f.texture, texel, f.row_darkness[y]);
        }
}

void read_far_flats(const PlainFlats& f) {
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const std::size_t texel = texel_at(f, i, y);
            f.runs.pixels[i * f.runs.pitch + y] = f.texture->pixels[texel];
        }
}

std::uint32_t read_walls(const PlainWalls& walls) {
    return goes_by_shifts(*walls.texture) ? read_walls_as<true>(walls) : read_walls_as<false>(walls);
}

void lay_walls(const PlainWalls& walls) {
    goes_by_shifts(*walls.texture) ? lay_walls_as<true>(walls) : lay_walls_as<false>(walls);
}

void lay_sky(const Run& run, const SkyRun& layer) {
    for (int i = 0; i < run.count; ++i) {
        const double v = layer.v_at_horizon + layer.row_rises[run.first_row + i] * layer.v_per_rise;
        const std::uint32_t texel = layer.texels[texel_of(place_on_sky(v, layer.last), layer.height)];
        if (texel >> 24 != 0) run.pixels[i] = laid_over(run.pixels[i], texel);
    }
}

void fill_color(const Run& run, std::uint32_t color) { std::fill_n(run.pixels, run.count, color); }

// Passes.

namespace {

void mix_cells(const LightCell* a, const LightCell* b, LightPart part, const LightRow& to) {
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
                   static_cast<std::uint32_t>(at) >> (32 - kLightPartBits));
}

LightCell light_at(const FlatLamplight& lamplight, int row) {
    const double depth =
        lamplight.row_depths[row] < lamplight.farthest ? lamplight.row_depths[row] : lamplight.farthest;
    return light_between(*lamplight.grid,
                         grid_step_of_shifted(lamplight.base_u + depth * lamplight.step_u, lamplight.grid->columns),
                         grid_step_of_shifted(lamplight.base_v + depth * lamplight.step_v, lamplight.grid->rows));
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
        light_pixel(to, i, lamplight.row_shades[row] & 0xFFFF, light_at(lamplight, row));
    }
}

void add_fog(const Run& run, std::uint32_t fog, const FogPart* fog_parts) {
    for (int i = 0; i < run.count; ++i) run.pixels[i] = fogged(run.pixels[i], fog, fog_parts[i]);
}

void blend(const Run& run, const std::uint32_t* colors, const std::uint32_t* texels) {
    for (int i = 0; i < run.count; ++i) {
        const std::uint32_t alpha = texels[i] & kOpaque;
        if (alpha != 0) run.pixels[i] = laid_over(run.pixels[i], (colors[i] & ~kOpaque) | alpha);
    }
}

constexpr Passes kScalar{{mix_cells, light_wall, light_flat}, add_fog, blend};

}  // namespace

const Passes& scalar_passes() { return kScalar; }

Passes passes_beside(const PlainKernels& kernels) {
    const auto eight_wide = eight_wide_kernels();
    return eight_wide && kernels.name == eight_wide->name ? eight_wide_passes().value_or(kScalar) : kScalar;
}

}  // namespace enfilade::column
