#include "render/column/kernels.h"

#include <algorithm>

#include "render/built_in.h"
#include "render/column/lamplit_walls.h"

namespace enfilade::column {
namespace {

constexpr Shade kFullBright = 256;

TileSteps first_of(const Run& run, const WallRun& wall) {
    return wall.v_at_row_0 + wall.v_per_row * static_cast<TileSteps>(run.first_row) + kHalfPlace;
}

std::uint32_t texel_row(const WallRun& wall, TileSteps v) {
    return texel_of(static_cast<TilePlace>(v >> 32), wall.height);
}

std::uint32_t texel_at(const WallRun& wall, TileSteps v) { return wall.texels[texel_row(wall, v)]; }

Run part_of(const Run& run, int first, int end) { return {run.pixels + first, run.first_row + first, end - first}; }

template <bool kLit>
void fill_wall_as(const Run& run, const WallRun& wall) {
    TileSteps v = first_of(run, wall);
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row) {
        const std::uint32_t texel = texel_at(wall, v);
        run.pixels[i] = kLit ? shaded(texel, wall.shade) : texel | 0xFF000000u;
    }
}

// What few surfaces need is kept out of line, so that the others do not save registers for it.
[[gnu::noinline]] void fill_wall_in_fog(const Run& run, const WallRun& wall) {
    TileSteps v = first_of(run, wall);
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row) {
        const std::uint32_t texel = texel_at(wall, v);
        run.pixels[i] = misted(shaded(texel, wall.shade), wall.fog, wall.mist);
    }
}

/// Where colours are looked up.
template <bool kHasFog>
void fill_wall_looked_up(const Run& run, const WallRun& wall) {
    TileSteps v = first_of(run, wall);
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row) {
        const std::uint32_t color = wall.darkened[wall.numbers[texel_row(wall, v)]];
        run.pixels[i] = kHasFog ? misted(color, wall.fog, wall.mist) : color;
    }
}

/// The light at a position among the cells, which is counted on even where it is far outside them.
LightCell glow_at(const WallGlow& glow, std::uint64_t position) {
    const std::int64_t last = (std::int64_t{glow.count - 1} << 32) - 1;
    const std::int64_t at = std::clamp(static_cast<std::int64_t>(position), std::int64_t{0}, last);
    const LightCell* cell = glow.cells + (at >> 32);
    return between(cell[0], cell[1], static_cast<std::uint32_t>(at >> 24) & 0xFF);
}

bool is_dark(const WallGlow& glow) {
    return std::all_of(glow.cells, glow.cells + glow.count, [](LightCell cell) { return enfilade::is_dark(cell); });
}

template <bool kHasFog, bool kIsOver, bool kByTable>
void paint_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow) {
    TileSteps v = first_of(run, wall);
    std::uint64_t position = glow.at_row_0 + glow.per_row * static_cast<std::uint64_t>(run.first_row);
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row, position += glow.per_row) {
        const std::uint32_t texel = texel_at(wall, v);
        if (kIsOver && texel >> 24 == 0) continue;
        const LightCell light = glow_at(glow, position);
        std::uint32_t color = kByTable
                                  ? lit_above(wall.darkened[wall.numbers[texel_row(wall, v)]], texel, wall.shade, light)
                                  : lit(texel, wall.shade, light);
        if (kHasFog) color = misted(color, wall.fog, wall.mist);
        run.pixels[i] = kIsOver ? laid_over(run.pixels[i], (color & 0x00FFFFFFu) | (texel & 0xFF000000u)) : color;
    }
}

template <bool kIsOver>
void paint_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow) {
    const int done = wall.numbers ? 0 : paint_lamplit_wall(run, wall, glow, kIsOver);
    const Run rest = part_of(run, done, run.count);
    const bool has_fog = built_in::kFog && wall.mist != 0;
    if (wall.numbers)
        has_fog ? paint_lit_wall<true, kIsOver, true>(rest, wall, glow)
                : paint_lit_wall<false, kIsOver, true>(rest, wall, glow);
    else
        has_fog ? paint_lit_wall<true, kIsOver, false>(rest, wall, glow)
                : paint_lit_wall<false, kIsOver, false>(rest, wall, glow);
}

template <bool kHasFog, bool kByTable>
void lay_wall_as(const Run& run, const WallRun& wall) {
    TileSteps v = first_of(run, wall);
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row) {
        const std::uint32_t texel = texel_at(wall, v);
        const std::uint32_t alpha = texel & 0xFF000000u;
        if (alpha == 0) continue;
        const std::uint32_t clear =
            kByTable ? wall.darkened[wall.numbers[texel_row(wall, v)]] : shaded(texel, wall.shade);
        const std::uint32_t color = kHasFog ? misted(clear, wall.fog, wall.mist) : clear;
        run.pixels[i] = laid_over(run.pixels[i], (color & 0x00FFFFFFu) | alpha);
    }
}

/// Whether no position on the flat is farther away than kNearTiles.
bool is_near(const FlatRun& flat) {
    const double most =
        std::max(flat.step_u < 0 ? -flat.step_u : flat.step_u, flat.step_v < 0 ? -flat.step_v : flat.step_v);
    return 1 + flat.farthest * most <= kNearTiles;
}

/// color_at(texel, number of the texel, row, depth): what a pixel shows, without fog.
template <bool kHasFog, bool kIsNear, class ColorAt>
void fill_flat_by(const Run& run, const FlatRun& flat, ColorAt color_at) {
    const Texture& texture = *flat.texture;
    const std::uint32_t* texels = texture.pixels.data();
    const auto place = [](double tiles) { return kIsNear ? place_on_near_tile(tiles) : place_on_tile(tiles); };
    for (int i = 0; i < run.count; ++i) {
        const int row = run.first_row + i;
        const double depth = std::min(flat.row_depths[row], flat.farthest);
        const std::uint32_t u = texel_of(place(flat.base_u + depth * flat.step_u), texture.width);
        const std::uint32_t v = texel_of(place(flat.base_v + depth * flat.step_v), texture.height);
        const std::size_t number = std::size_t{u} * texture.height + v;
        const std::uint32_t color = color_at(texels[number], number, row, depth);
        run.pixels[i] = kHasFog ? misted(color, flat.fog, flat.row_mists[row]) : color;
    }
}

// Tiles of a hand's breadth that reach to the end of the world: so few that they are kept out of line.
template <bool kHasFog, class ColorAt>
[[gnu::noinline]] void fill_far_flat(const Run& run, const FlatRun& flat, ColorAt color_at) {
    fill_flat_by<kHasFog, false>(run, flat, color_at);
}

template <bool kHasFog, class ColorAt>
void fill_flat_with(const Run& run, const FlatRun& flat, ColorAt color_at) {
    if (is_near(flat))
        fill_flat_by<kHasFog, true>(run, flat, color_at);
    else
        fill_far_flat<kHasFog>(run, flat, color_at);
}

template <bool kHasFog>
void fill_flat_as(const Run& run, const FlatRun& flat) {
    fill_flat_with<kHasFog>(run, flat, [&flat](std::uint32_t texel, std::size_t, int row, double) {
        return shaded(texel, flat.row_shades[row]);
    });
}

/// Where colours are looked up.
template <bool kHasFog>
void fill_flat_looked_up(const Run& run, const FlatRun& flat) {
    const std::uint8_t* numbers = flat.texture->numbers.data();
    fill_flat_with<kHasFog>(run, flat, [&flat, numbers](std::uint32_t, std::size_t number, int row, double) {
        return darkened_colors(*flat.color_table, flat.row_shades[row])[numbers[number]];
    });
}

template <bool kHasFog, bool kByTable>
void fill_lit_flat_as(const Run& run, const FlatRun& flat, const FlatGlow& glow) {
    const LightGrid& grid = *glow.grid;
    fill_flat_with<kHasFog>(run, flat, [&](std::uint32_t texel, std::size_t number, int row, double depth) {
        const GridStep across = grid_step(glow.base_u + depth * glow.step_u, grid.columns);
        const GridStep along = grid_step(glow.base_v + depth * glow.step_v, grid.rows);
        const Shade shade = flat.row_shades[row];
        const LightCell light = light_between(grid, across, along);
        if constexpr (!kByTable) return lit(texel, shade, light);
        const std::uint32_t* darkened = darkened_colors(*flat.color_table, shade);
        return lit_above(darkened[flat.texture->numbers[number]], texel, shade, light);
    });
}

/// Which pixels of the run, from `first` on and before `end`, may be lit: only both ends of the run are looked at.
struct LitPart {
    int first, end;
};
LitPart lit_part(const Run& run, const FlatRun& flat, const FlatGlow& glow) {
    const auto is_dark = [&](int i) {
        const double depth = std::min(flat.row_depths[run.first_row + i], flat.farthest);
        return is_beyond_light(*glow.grid, glow.base_u + depth * glow.step_u, glow.base_v + depth * glow.step_v);
    };
    LitPart part{0, run.count};
    while (part.first < part.end && is_dark(part.first)) ++part.first;
    while (part.first < part.end && is_dark(part.end - 1)) --part.end;
    return part;
}

[[gnu::noinline]] void fill_flat_in_fog(const Run& run, const FlatRun& flat) { fill_flat_as<true>(run, flat); }

}  // namespace

void fill_wall(const Run& run, const WallRun& wall) {
    if (built_in::kFog && wall.mist != 0)
        fill_wall_in_fog(run, wall);
    else if (wall.shade == kFullBright)
        fill_wall_as<false>(run, wall);
    else
        fill_wall_as<true>(run, wall);
}

void fill_wall_by_table(const Run& run, const WallRun& wall) {
    if (built_in::kFog && wall.mist != 0)
        fill_wall_looked_up<true>(run, wall);
    else
        fill_wall_looked_up<false>(run, wall);
}

void lay_wall(const Run& run, const WallRun& wall) {
    const bool has_fog = built_in::kFog && wall.mist != 0;
    if (wall.numbers)
        has_fog ? lay_wall_as<true, true>(run, wall) : lay_wall_as<false, true>(run, wall);
    else
        has_fog ? lay_wall_as<true, false>(run, wall) : lay_wall_as<false, false>(run, wall);
}

void fill_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow) {
    if (is_dark(glow)) return wall.numbers ? fill_wall_by_table(run, wall) : fill_wall(run, wall);
    paint_lit_wall<false>(run, wall, glow);
}

void lay_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow) {
    if (is_dark(glow)) return lay_wall(run, wall);
    paint_lit_wall<true>(run, wall, glow);
}

void fill_flat(const Run& run, const FlatRun& flat) {
    if (built_in::kFog && flat.row_mists)
        fill_flat_in_fog(run, flat);
    else
        fill_flat_as<false>(run, flat);
}

void fill_flat_by_table(const Run& run, const FlatRun& flat) {
    if (built_in::kFog && flat.row_mists)
        fill_flat_looked_up<true>(run, flat);
    else
        fill_flat_looked_up<false>(run, flat);
}

void fill_lit_flat(const Run& run, const FlatRun& flat, const FlatGlow& glow) {
    const auto [first, end] = lit_part(run, flat, glow);
    const Run middle = part_of(run, first, end);
    const bool has_fog = built_in::kFog && flat.row_mists;
    const auto fill_dark = flat.color_table ? fill_flat_by_table : fill_flat;
    fill_dark(part_of(run, 0, first), flat);
    if (flat.color_table)
        has_fog ? fill_lit_flat_as<true, true>(middle, flat, glow) : fill_lit_flat_as<false, true>(middle, flat, glow);
    else
        has_fog ? fill_lit_flat_as<true, false>(middle, flat, glow)
                : fill_lit_flat_as<false, false>(middle, flat, glow);
    fill_dark(part_of(run, end, run.count), flat);
}

void lay_sky(const Run& run, const SkyRun& layer) {
    for (int i = 0; i < run.count; ++i) {
        const double v = layer.v_at_horizon + layer.row_rises[run.first_row + i] * layer.v_per_rise;
        const std::uint32_t texel = layer.texels[texel_of(place_on_picture(v), layer.height)];
        if (texel >> 24 != 0) run.pixels[i] = laid_over(run.pixels[i], texel);
    }
}

void fill_color(const Run& run, std::uint32_t color) { std::fill_n(run.pixels, run.count, color); }

}  // namespace enfilade::column
