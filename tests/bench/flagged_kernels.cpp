// The inner loops as many engines have them: one for everything, which asks for each pixel what the surface is like.
// Linked instead of render/column/plain_kernels.cpp to count what that would cost (effect_cost.sh). Same pixels.
#include <algorithm>

#include "render/column/kernels.h"

namespace enfilade::column {
namespace {

constexpr std::uint32_t kHasHoles = 1, kIsLit = 2, kIsInFog = 4, kIsSky = 8, kScrolls = 16;

/// What every surface has, used or not.
struct Look {
    std::uint32_t flags;
    Shade shade;
    FogPart fog_part;
    std::uint32_t fog;
    TilePlace scrolled_by;
};

/// Light, fog and holes of one pixel.
void put(std::uint32_t& pixel, std::uint32_t texel, const Look& look) {
    std::uint32_t color = texel | 0xFF000000u;
    if (look.flags & kIsLit) color = shaded(color, look.shade);
    if (look.flags & kIsInFog) color = fogged(color, look.fog, look.fog_part);
    if (look.flags & kHasHoles) color = laid_over(pixel, (color & 0x00FFFFFFu) | (texel & 0xFF000000u));
    pixel = color;
}

/// One texel coordinate.
std::uint32_t texel_at(TilePlace place, std::uint32_t size, const Look& look) {
    if (look.flags & kScrolls) place += look.scrolled_by;
    if (look.flags & kIsSky) place = std::min(place, 0xFFFFFFFEu);
    return texel_of(place, size);
}

void fill_walls(const PlainWalls& w) {
    for (int i = 0; i < w.runs.count; ++i) {
        const Look look{kIsLit, w.shades[i], 0, 0, 0};
        const std::uint32_t* const texels = &w.texture->pixels[w.first_texels[i]];
        TileSteps v = w.v_at_row_0[i] + w.v_per_row[i] * static_cast<TileSteps>(w.runs.tops[i]) + kHalfPlace;
        for (int y = w.runs.tops[i]; y < w.runs.bottoms[i]; ++y, v += w.v_per_row[i])
            put(w.runs.pixels[i * w.runs.pitch + y],
                texels[texel_at(static_cast<TilePlace>(v >> 32), w.texture->height, look)], look);
    }
}

void fill_flats(const PlainFlats& f) {
    Look look{kIsLit, 0, 0, 0, 0};
    for (int i = 0; i < f.runs.count; ++i)
        for (int y = f.runs.tops[i]; y < f.runs.bottoms[i]; ++y) {
            const double depth = std::min(f.row_depths[y], f.farthest[i]);
            const TilePlace u = place_on_near_tile(f.base_u + depth * f.step_u[i]);
            const TilePlace v = place_on_near_tile(f.base_v + depth * f.step_v[i]);
            const std::size_t column = texel_at(u, f.texture->width, look);
            if (look.flags & kIsLit) look.shade = f.row_darkness[y] & 0xFFFF;
            put(f.runs.pixels[i * f.runs.pitch + y],
                f.texture->pixels[column * f.texture->height + texel_at(v, f.texture->height, look)], look);
        }
}

void fill_sky(const Run& run, const SkyRun& sky) {
    const Look look{kIsSky, 0, 0, 0, 0};
    for (int i = 0; i < run.count; ++i) {
        const double v = sky.v_at_horizon + sky.row_rises[run.first_row + i] * sky.v_per_rise;
        put(run.pixels[i], sky.texels[texel_at(place_on_sky(v, sky.last), sky.height, look)], look);
    }
}

constexpr PlainKernels kFlagged{"flagged", fill_walls, fill_flats, fill_sky, read_walls, lay_walls, read_far_flats};

}  // namespace

TileSteps tile_steps(double tiles) { return static_cast<TileSteps>(fraction(tiles) * 0x1p64); }
const PlainKernels& scalar_kernels() { return kFlagged; }
std::optional<PlainKernels> kernels_named(std::string_view) { return kFlagged; }
PlainKernels chosen_kernels() { return kFlagged; }
Result<void> check_kernels() { return {}; }

}  // namespace enfilade::column
