// The shading rules shared by all renderers: how bright a surface is, also where lamps light it, which texel it shows,
// what a sky looks like.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "formats/dials.h"
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
/// reach: 0 is no fog. depth: >= 0 [m], infinity allowed. step: 1..256, a power of two: the part is the multiple of it
/// that is nearest.
FogPart fog_part_at(double reach, double depth, FogPart step = 1);

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

// What point lights throw onto a surface: values at evenly spaced points, fixed to the surface, and the
// rules by which a place between them is lit. Shared by all renderers.

/// Red, green and blue light that is added to a surface's shade, each 0..kMostLight, in steps of kLightSteps to one of
/// Shade. Lanes of kLaneBits: red, blue and green from the lowest on, for red and blue lie side by side where every
/// second byte of a pixel is taken.
using LightCell = std::uint64_t;

inline constexpr int kLaneBits = 16;
inline constexpr std::uint32_t kLightSteps = 16;

/// What a lane holds at most: 13 bits, so that four times a difference still fits it. Almost twice as bright as
/// painted.
inline constexpr std::uint32_t kMostLight = (1u << 13) - 1;

/// Brighter than this nothing gets: twice as painted.
inline constexpr Shade kBrightest = 512;

constexpr LightCell light_cell(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return LightCell{red} | LightCell{blue} << kLaneBits | LightCell{green} << 2 * kLaneBits;
}

/// channel: 0 red, 1 green, 2 blue.
constexpr std::uint32_t lane(LightCell cell, int channel) {
    constexpr int kLaneOf[] = {0, 2, 1};
    return static_cast<std::uint32_t>(cell >> kLaneOf[channel] * kLaneBits) & kMostLight;
}

/// Whether it makes no surface brighter; then neither does anything between two such cells.
constexpr bool is_dark(LightCell cell) {
    constexpr std::uint32_t kSeen = kMostLight & ~(kLightSteps - 1);
    return (cell & light_cell(kSeen, kSeen, kSeen)) == 0;
}

/// How much of the way from one point of light to the next, in 2^-kLightPartBits: less than all of it.
using LightPart = std::uint32_t;
inline constexpr int kLightPartBits = 15;

/// Between two cells, this much of the way from a to b, each channel rounded to the nearest.
constexpr LightCell between(LightCell a, LightCell b, LightPart part) {
    const auto channel = [&](int i) {
        const auto from = static_cast<std::int32_t>(lane(a, i)), way = static_cast<std::int32_t>(lane(b, i)) - from;
        constexpr std::int32_t kHalf = 1 << (kLightPartBits - 1);
        return static_cast<std::uint32_t>(from + ((way * static_cast<std::int32_t>(part) + kHalf) >> kLightPartBits));
    };
    return light_cell(channel(0), channel(1), channel(2));
}

/// The colour 0xAABBGGRR in this shade and this light. Alpha becomes opaque.
constexpr std::uint32_t lit(std::uint32_t color, Shade shade, LightCell light) {
    std::uint32_t result = 0xFF000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t sum = shade + lane(light, channel) / kLightSteps;
        const std::uint32_t bright = (color >> 8 * channel & 0xFF) * (sum < kBrightest ? sum : kBrightest) >> 8;
        result |= (bright < 255 ? bright : 255) << 8 * channel;
    }
    return result;
}

/// The colour in a light that comes on top of what it has without, which is `darkened`: as much is added as lit() would
/// add to the shade. Alpha becomes opaque.
constexpr std::uint32_t lit_above(std::uint32_t darkened, std::uint32_t color, Shade shade, LightCell light) {
    std::uint32_t result = 0xFF000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t more = lane(light, channel) / kLightSteps, most = kBrightest - shade;
        const std::uint32_t added = (color >> 8 * channel & 0xFF) * (more < most ? more : most) >> 8;
        const std::uint32_t bright = (darkened >> 8 * channel & 0xFF) + added;
        result |= (bright < 255 ? bright : 255) << 8 * channel;
    }
    return result;
}

/// What the grid of a surface covers at most as densely as is asked for [m^2]: 362 m each way. Where lamps on one
/// surface lie farther apart, the points of its grid do, too.
inline constexpr double kMostGridArea = 0x1p17;

/// The light on a rectangle of a surface. A place is (u, v) on it: walls and panels (metres along from a, height z),
/// flats (x, y), all in the space of the surface's own sector.
struct LightGrid {
    double u = 0, v = 0;                                     ///< of the first point [m]
    double per_m = kUsualLightPoints;                        ///< points along a metre
    int columns = 0, rows = 0;                               ///< points along u and along v, each >= 2
    std::vector<LightCell> cells;                            ///< by column: cells[column * rows + row]
    bool is_dark_before_u = false, is_dark_after_u = false;  ///< all points of the first, or last, column are dark
    bool is_dark_before_v = false, is_dark_after_v = false;  ///< the same of rows
};

/// Where a place is between the points of one direction.
struct GridStep {
    int cell = 0;        ///< 0..count - 2: the point before it
    LightPart part = 0;  ///< of the way to the next
};

/// Places among points of light are rounded to the nearest such part of a cell, 2^-16, which is the last bit of sums
/// with kGridShift [cells].
inline constexpr int kGridPlaceBits = 16;
inline constexpr double kGridShift = 0x1.8p36;

/// The last place before the last point. count: of points, >= 2.
constexpr std::int64_t last_grid_place(int count) { return (std::int64_t{count - 1} << kGridPlaceBits) - 1; }

/// shifted_cells: position counted in points from the first, and kGridShift more; |position| < 2^34. Beyond the ends
/// counts as at them.
constexpr GridStep grid_step_of_shifted(double shifted_cells, int count) {
    const std::int64_t place = std::bit_cast<std::int64_t>(shifted_cells) - std::bit_cast<std::int64_t>(kGridShift);
    const std::int64_t inside = std::clamp(place, std::int64_t{0}, last_grid_place(count));
    constexpr std::int64_t kParts = (1 << kGridPlaceBits) - 1;
    return {static_cast<int>(inside >> kGridPlaceBits),
            static_cast<LightPart>((inside & kParts) >> (kGridPlaceBits - kLightPartBits))};
}

/// cells: position counted in points from the first, any number; beyond the ends counts as at them. count >= 2.
constexpr GridStep grid_step(double cells, int count) {
    const double last = count - 1;
    const double inside = cells > 0 ? (cells < last ? cells : last) : 0;
    return grid_step_of_shifted(inside + kGridShift, count);
}

/// Even between four points.
inline LightCell light_between(const LightGrid& grid, GridStep across, GridStep along) {
    const LightCell* first = &grid.cells[static_cast<std::size_t>(across.cell) * static_cast<std::size_t>(grid.rows) +
                                         static_cast<std::size_t>(along.cell)];
    const LightCell* second = first + grid.rows;
    return between(between(first[0], second[0], across.part), between(first[1], second[1], across.part), along.part);
}

/// The light at a place: even between the four points around it; beyond the grid that of its edge.
inline LightCell light_on(const LightGrid& grid, double u, double v) {
    return light_between(grid, grid_step((u - grid.u) * grid.per_m, grid.columns),
                         grid_step((v - grid.v) * grid.per_m, grid.rows));
}

}  // namespace enfilade
