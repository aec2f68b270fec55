#include "render/column/kernels.h"

#include <algorithm>

namespace enfilade::column {
namespace {

template <bool kByShifts>
std::uint32_t read_wall_as(const PlainWalls& walls) {
    const WallColumn to = column_of(walls, 0);
    const RowNumber<kByShifts> row_at(walls.texture->height);
    const std::uint32_t* const texels = &walls.texture->pixels[walls.first_texels[0]];
    std::uint32_t any = 0;
    TileSteps v = to.v;
    for (int i = 0; i < to.count; ++i, v += to.step) any |= to.pixels[i] = texels[row_at(v)];
    return any;
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

void read_flats(const PlainFlats& f) {
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const std::size_t texel = texel_at(f, i, y);
            f.runs.pixels[i * f.runs.pitch + y] = f.texture->pixels[texel];
        }
}

std::uint32_t read_wall(const PlainWalls& walls) {
    const std::uint32_t height = walls.texture->height;
    return height > 1 && is_power_of_two(height) ? read_wall_as<true>(walls) : read_wall_as<false>(walls);
}

void lay_sky(const Run& run, const SkyRun& layer) {
    for (int i = 0; i < run.count; ++i) {
        const double v = layer.v_at_horizon + layer.row_rises[run.first_row + i] * layer.v_per_rise;
        const std::uint32_t texel = layer.texels[texel_of(place_on_sky(v, layer.last), layer.height)];
        if (texel >> 24 != 0) run.pixels[i] = laid_over(run.pixels[i], texel);
    }
}

void fill_color(const Run& run, std::uint32_t color) { std::fill_n(run.pixels, run.count, color); }

}  // namespace enfilade::column
