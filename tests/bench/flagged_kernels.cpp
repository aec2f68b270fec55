// The inner loops as many engines have them: one for everything, which asks for each pixel what the surface is like.
// Linked instead of render/column/kernels.cpp to count what that would cost (effect_cost.sh). Same pixels.
#include <algorithm>

#include "render/column/kernels.h"

namespace enfilade::column {
namespace {

constexpr std::uint32_t kHasHoles = 1, kIsLit = 2, kIsInFog = 4, kIsSky = 8, kScrolls = 16;

constexpr TileSteps kHalfPlace = TileSteps{1} << 31;  ///< as in render/column/kernels.cpp

/// What every surface has, used or not.
struct Look {
    std::uint32_t flags;
    Shade shade;
    Mist mist;
    std::uint32_t fog;
    TileSteps scrolled_by;
};

/// Light, fog and holes of one pixel.
void put(std::uint32_t& pixel, std::uint32_t texel, const Look& look) {
    std::uint32_t color = texel | 0xFF000000u;
    if (look.flags & kIsLit) color = shaded(color, look.shade);
    if (look.flags & kIsInFog) color = misted(color, look.fog, look.mist);
    if (look.flags & kHasHoles) color = laid_over(pixel, (color & 0x00FFFFFFu) | (texel & 0xFF000000u));
    pixel = color;
}

/// The texel row of a wall, a fence or a sky.
std::uint32_t row_of(TileSteps v, std::uint32_t height, const Look& look) {
    if (look.flags & kScrolls) v += look.scrolled_by;
    const auto fraction = static_cast<std::uint32_t>(v >> 32);
    if (look.flags & kIsSky) return std::min(texel_of(fraction, height), height - 1);
    return texel_of(fraction, height);
}

void fill(const Run& run, const WallRun& wall, const Look& look) {
    TileSteps v = wall.v_at_row_0 + wall.v_per_row * static_cast<TileSteps>(run.first_row) + kHalfPlace;
    for (int i = 0; i < run.count; ++i, v += wall.v_per_row)
        put(run.pixels[i], wall.texels[row_of(v, wall.height, look)], look);
}

Look look_of(const WallRun& wall) {
    const std::uint32_t in_fog = wall.mist != 0 ? kIsInFog : 0;
    return {kIsLit | in_fog, wall.shade, wall.mist, wall.fog, 0};
}

/// The two texel coordinates of a floor.
std::size_t texel_index_of(const Texture& texture, double u, double v, const Look& look) {
    auto across = place_on_near_tile(u), down = place_on_near_tile(v);
    if (look.flags & kScrolls) across += static_cast<std::uint32_t>(look.scrolled_by);
    if (look.flags & kIsSky) down = std::min(down, 0xFFFFFFFEu);
    return std::size_t{texel_of(across, texture.width)} * texture.height + texel_of(down, texture.height);
}

}  // namespace

TileSteps tile_steps(double tiles) { return static_cast<TileSteps>(fraction(tiles) * 0x1p64); }

void fill_wall(const Run& run, const WallRun& wall) { fill(run, wall, look_of(wall)); }

void lay_wall(const Run& run, const WallRun& wall) {
    Look look = look_of(wall);
    look.flags |= kHasHoles;
    fill(run, wall, look);
}

void fill_flat(const Run& run, const FlatRun& flat) {
    const double most =
        std::max(flat.step_u < 0 ? -flat.step_u : flat.step_u, flat.step_v < 0 ? -flat.step_v : flat.step_v);
    const double farthest = std::min(flat.farthest, (kNearTiles - 1) / most);
    Look look{kIsLit | (flat.row_mists ? kIsInFog : 0u), 0, 0, flat.fog, 0};
    for (int i = 0; i < run.count; ++i) {
        const int row = run.first_row + i;
        const double depth = std::min(flat.row_depths[row], farthest);
        const std::size_t texel =
            texel_index_of(*flat.texture, flat.base_u + depth * flat.step_u, flat.base_v + depth * flat.step_v, look);
        if (look.flags & kIsLit) look.shade = flat.row_shades[row];
        if (look.flags & kIsInFog) look.mist = flat.row_mists[row];
        put(run.pixels[i], flat.texture->pixels[texel], look);
    }
}

void fill_sky(const Run& run, const SkyRun& sky) {
    for (int i = 0; i < run.count; ++i) {
        const double v = std::clamp(sky.v_at_horizon + sky.row_rises[run.first_row + i] * sky.v_per_rise, 0.0, 1.0);
        run.pixels[i] = sky.texels[texel_of(place_on_picture(v), sky.height)] | 0xFF000000u;
    }
}

// The rooms that are drawn have neither point lights nor clouds.
void fill_lit_wall(const Run& run, const WallRun& wall, const WallGlow&) { fill_wall(run, wall); }
void lay_lit_wall(const Run& run, const WallRun& wall, const WallGlow&) { lay_wall(run, wall); }
void fill_lit_flat(const Run& run, const FlatRun& flat, const FlatGlow&) { fill_flat(run, flat); }
void lay_sky(const Run& run, const SkyRun& layer) { fill_sky(run, layer); }

void fill_color(const Run& run, std::uint32_t color) { std::fill_n(run.pixels, run.count, color); }

}  // namespace enfilade::column
