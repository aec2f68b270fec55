// The shading rules shared by all renderers: how bright a surface is, which texel it shows, what a sky looks like.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "formats/map_file.h"
#include "map/textures.h"
#include "math/vec.h"

namespace enfilade {

/// Brightness of a surface as a factor in 1/256: 0 black, 256 as painted.
using Shade = std::uint32_t;
inline constexpr Shade kFullBright = 256;

/// How light falls off. Both models start from the sector's light and darken with depth, dark sectors sooner:
///   classic: Doom's 32 levels, level = 60 - 2 [32 light] - min([40 / depth], 23), each 1/32 darker, [] cutting to
///   whole
///            numbers (id Software, r_main.c 1993, formulas only; twice its steps of light, as later engines have
///            them); contrast below or above 1 moves light by one sixteenth, Doom's "fake contrast". Round heights
///            and looks put whole rows on the very edge between two levels: 40 / depth is rounded as texels are
///   smooth:  light * contrast / (1 + (depth / reach)^2), reach growing without bound as light goes to 1
///
/// light: 0..1, clamped. contrast: Wall::contrast, 1 for flats. depth: >= 0 [m], infinity allowed.
/// Grows with light, never grows with depth.
Shade shade_at(LightModel model, double light, double contrast, double depth);

/// The colour 0xAABBGGRR made darker. Alpha becomes opaque.
constexpr std::uint32_t shaded(std::uint32_t color, Shade shade) {
    const std::uint32_t red_blue = ((color & 0x00FF00FFu) * shade >> 8) & 0x00FF00FFu;
    const std::uint32_t green = ((color & 0x0000FF00u) * shade >> 8) & 0x0000FF00u;
    return 0xFF000000u | red_blue | green;
}

/// The colours of a color table in this shade, by their numbers: its 32 levels stand for 256, 248 to 8, and a shade
/// between two of them has the brighter one's.
inline const std::uint32_t* darkened_colors(const ColorTable& table, Shade shade) {
    constexpr Shade kPerLevel = kFullBright / ColorTable::kLevels;
    const Shade missing = shade < kFullBright ? kFullBright - shade : 0;
    return table.at_level(std::min<std::size_t>(missing / kPerLevel, ColorTable::kLevels - 1));
}

/// How much of a colour fog hides, in 1/256: 0 nothing, 256 all.
using FogPart = std::uint32_t;

/// Fog that hides half of everything at the depth `reach` [m], more beyond: depth^2 / (depth^2 + reach^2).
/// reach: 0 is no fog. depth: >= 0 [m], infinity allowed.
FogPart fog_part_at(double reach, double depth);

/// The colour 0xAABBGGRR with fog of the colour `fog` before it. Alpha is kept.
constexpr std::uint32_t fogged(std::uint32_t color, std::uint32_t fog, FogPart fog_part) {
    const std::uint32_t clear = 256 - fog_part;
    const std::uint32_t red_blue = ((color & 0x00FF00FFu) * clear + (fog & 0x00FF00FFu) * fog_part) >> 8 & 0x00FF00FFu;
    const std::uint32_t green = ((color & 0x0000FF00u) * clear + (fog & 0x0000FF00u) * fog_part) >> 8 & 0x0000FF00u;
    return (color & 0xFF000000u) | red_blue | green;
}

/// 0xRRGGBB, as maps write colours, as a pixel 0xAABBGGRR.
constexpr std::uint32_t pixel_of(std::uint32_t rgb) {
    return 0xFF000000u | (rgb & 0xFF) << 16 | (rgb & 0xFF00) | (rgb >> 16 & 0xFF);
}

/// The colour `above` lying over `below`: its alpha says how much of `below` is hidden, 0 nothing, 255 all.
/// The result is opaque; each channel is rounded to the nearest.
constexpr std::uint32_t laid_over(std::uint32_t below, std::uint32_t above) {
    const std::uint32_t alpha = above >> 24;
    std::uint32_t mixed = 0xFF000000u;
    for (int shift : {0, 8, 16}) {
        const std::uint32_t sum = (above >> shift & 0xFF) * alpha + (below >> shift & 0xFF) * (255 - alpha);
        mixed |= (sum + 127) / 255 << shift;
    }
    return mixed;
}

/// From this alpha on a masked picture's pixel counts as its own surface; below it what is seen through it does.
inline constexpr std::uint32_t kSolidAlpha = 128;

/// The part of a tile coordinate after the point, in [0, 1).
double fraction(double tiles);

/// Where on its tile a surface is looked at: the part of a tile coordinate after the point [2^-32 of a tile].
///
/// The tie rule for texels: before a texel is read its position is rounded to the nearest such step. Round coordinates
/// and looks along an axis put whole rows of pixels on the very edge between two texels, where renderers that compute
/// the same position in different ways would fall to either side of it. All round off by less than a hundredth of a
/// step, so that they then stand on the same one.
using TilePlace = std::uint32_t;

/// Up to here numbers have all their steps, and adding kStepShift, whose last bit is one step, rounds to them [tiles].
inline constexpr double kNearTiles = 0x1p19;
inline constexpr double kStepShift = 0x1.8p20;

/// The nearest whole number of steps, half to even. |tiles| <= kNearTiles.
constexpr std::int64_t nearest_steps(double tiles) {
    return std::bit_cast<std::int64_t>(tiles + kStepShift) - std::bit_cast<std::int64_t>(kStepShift);
}

/// The same as a number again.
constexpr double on_nearest_step(double x) { return x + kStepShift - kStepShift; }

/// A surface that repeats its picture. |tiles| <= kNearTiles: an addition.
constexpr TilePlace place_on_near_tile(double tiles) { return static_cast<TilePlace>(nearest_steps(tiles)); }

/// The same for any finite number; what is far away is brought near by whole tiles, exactly.
inline TilePlace place_on_tile(double tiles) {
    const bool is_near = tiles >= -kNearTiles && tiles <= kNearTiles;
    return place_on_near_tile(is_near ? tiles : tiles - std::floor(tiles / kNearTiles) * kNearTiles);
}

/// The last place of a picture that is shown once: half a step on, and it would begin again [1].
inline constexpr double kLastPlace = 1 - 0x1p-32;

/// Such a picture, whose end is its last texel's. part: where on it, 0..1; below and above that its ends go on.
constexpr TilePlace place_on_picture(double part) {
    return static_cast<TilePlace>(nearest_steps(std::clamp(part, 0.0, kLastPlace)));
}

/// The texel there, below size_px. Nearest, as painted: no filter.
constexpr std::uint32_t texel_of(TilePlace place, std::uint32_t size_px) {
    return static_cast<std::uint32_t>(std::uint64_t{place} * size_px >> 32);
}

/// How the rows of the sky lie in a picture. Straight ones go by what a ray climbs per metre of depth, so that a row of
/// the screen is a row of the sky, as in Doom; round ones by what it climbs per metre along the ground. A tilted
/// picture has no rows of one climb: its sky is round.
constexpr SkyRows sky_rows(const RenderRecord& render, bool is_tilted) {
    return is_tilted ? SkyRows::round : render.sky;
}

/// How far down a sky goes that begins at 0, where its picture's first row goes on above it: to the end of its picture,
/// whose last row goes on, or where rows are straight on and on, its picture beginning again, as in Doom [tiles].
constexpr double last_of_sky(SkyRows rows) { return rows == SkyRows::straight ? kNearTiles : kLastPlace; }

/// So far down, in rows of the picture. last: last_of_sky().
constexpr TilePlace place_on_sky(double v, double last) { return place_on_near_tile(std::clamp(v, 0.0, last)); }

/// Where on the sky picture a ray looks, around which it is repeated. turns: turn_of(direction in the plane).
/// elevation: tangent of the angle above the horizon, or where rows are straight what the ray climbs per depth. The
/// picture's foot is at the horizon.
struct SkyTexel {
    double u;  ///< [0, 1)
    double v;  ///< [0, 1]; where rows are straight [0, 1)
};
SkyTexel sky_texel(Vec2 tile, Vec2 offset_tiles, double turns, double elevation, SkyRows rows);

}  // namespace enfilade
