// What the dials of texels do to the positions that kernels draw from (formats/dials.h). The kernels stay what they
// are: a position between two exact ones is another position, a smaller picture is another picture, and columns that
// are drawn alike are drawn once and copied.
//
// Everything is a function of the column or row alone, never of where a run or a strip begins, so that the picture does
// not depend on how it was cut.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>

#include "formats/dials.h"
#include "math/angle.h"
#include "math/vec.h"
#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/column/viewport.h"
#include "render/frame.h"
#include "render/sampling.h"

namespace enfilade::column {

// Columns that are drawn alike.

/// Most neighbouring columns that are drawn alike. Groups of 2, 4, 8 ... of them begin at multiples of their size.
inline constexpr int kMostHeld = 32;

/// Columns [first, last] of the picture.
struct ColumnGroup {
    int first = 0;
    int last = 0;
};

/// The group of `size` columns, a power of two, that x is in, as far as it lies within `limits`.
inline ColumnGroup group_of(int x, int size, ColumnGroup limits) {
    return {std::max(x & ~(size - 1), limits.first), std::min(x | (size - 1), limits.last)};
}

/// Draws the rows of each column by fill(ColumnRuns): those that column like[i] has, too, only there, to be copied; the
/// rest above and below them in the same way. like[i]: a column of the same run of columns, itself where it is alone or
/// the one that others are like. What `fill` draws from is the same for columns that are alike.
template <class Fill>
void fill_alike(const ColumnRuns& runs, const int* like, const Fill& fill) {
    int tops[WallLooks::kMost], bottoms[WallLooks::kMost];
    const auto fill_rows = [&](auto top_of, auto bottom_of) {
        bool is_any = false;
        for (int i = 0; i < runs.count; ++i) {
            tops[i] = top_of(i);
            bottoms[i] = bottom_of(i);
            is_any |= tops[i] < bottoms[i];
        }
        if (is_any) fill(ColumnRuns{runs.pixels, runs.pitch, runs.count, tops, bottoms});
    };
    const auto top = [&](int i) { return runs.tops[i]; };
    const auto bottom = [&](int i) { return runs.bottoms[i]; };
    fill_rows(top, [&](int i) { return like[i] == i ? bottom(i) : top(i); });
    for (int i = 0; i < runs.count; ++i) {
        const int from = std::max(top(i), top(like[i])), end = std::min(bottom(i), bottom(like[i]));
        if (like[i] != i && from < end)
            std::copy_n(runs.pixels + like[i] * runs.pitch + from, end - from, runs.pixels + i * runs.pitch + from);
    }
    fill_rows(top, [&](int i) { return like[i] == i ? top(i) : std::min(bottom(i), top(like[i])); });
    fill_rows([&](int i) { return like[i] == i ? bottom(i) : std::max(top(i), bottom(like[i])); }, bottom);
}

/// How far the first and the last of columns that are drawn alike may be apart on a picture with a side of so many
/// texels: twice the promise, for they show what is between them, less what is lost where texels are read from the
/// nearest of 2^32 places (render/shade.h) [texels]. Not above 0 where nothing is promised.
constexpr double most_apart(const Dials& dials, std::uint32_t size) {
    constexpr double kTwoPlaces = 0x1p-31;  // half a place for each of truth and picture, twice [tiles]
    return 2 * dials.texel_error - size * kTwoPlaces;
}

/// Whether all that is asked is a promise: where nothing can be drawn alike, texels are then exact.
constexpr bool is_only_promise(const Dials& dials) {
    return dials.span == 1 && dials.number == NumberKind::real64 && dials.sampling == Sampling::nearest;
}

/// Along either side of the picture of any surface of the map [texels/m]; infinite where there are none.
double least_texels_per_m(const Map& map, const TextureSet& textures);

/// Whether a promise is all that is asked, and so narrow that nothing that is likely to be seen may be drawn alike:
/// looking for it would cost more than it gains.
bool is_promise_too_narrow(const TexelDials& dials, const RayTables& screen);

// Spans.

/// Between the exact positions of places `first` and `last`: at `place`, on a straight line. first <= place <= last.
inline double on_line(double at_first, double at_last, int first, int last, int place) {
    return first == last ? at_first : at_first + (at_last - at_first) * (place - first) / (last - first);
}

// Numbers.

/// To the nearest of 1/65536. |number| <= 2^35.
double in_16_16(double number);

/// Where on a flat a row of a column is [tiles], in these numbers. size: of the picture along this side [px].
template <NumberKind kNumber>
double flat_position(double base, double depth, double step, std::uint32_t size) {
    if constexpr (kNumber == NumberKind::real32)
        return static_cast<double>(static_cast<float>(base) + static_cast<float>(depth) * static_cast<float>(step));
    if constexpr (kNumber == NumberKind::fixed16)
        return (in_16_16(base * size) + in_16_16(in_16_16(depth) * in_16_16(step * size))) / size;
    return base + depth * step;
}

/// Not by vanilla's.
double flat_position(NumberKind number, double base, double depth, double step, std::uint32_t size);

/// As PlainKernels::fill_flats, pixel by pixel and however far, where places on the picture are position(i, y) of the
/// i-th column and row y: a TexelPosition.
template <class Position>
void fill_flats_at(const PlainFlats& flats, const Position& position) {
    const Texture& picture = *flats.texture;
    for (int i = 0; i < flats.runs.count; ++i)
        for (int y = flats.runs.tops[i]; y < flats.runs.bottoms[i]; ++y) {
            const TexelPosition at = position(i, y);
            const std::uint32_t u = texel_of(place_on_tile(at.u), picture.width);
            const std::uint32_t v = texel_of(place_on_tile(at.v), picture.height);
            flats.runs.pixels[i * flats.runs.pitch + y] =
                darkened(flats.color_table, picture, std::size_t{u} * picture.height + v, flats.row_darkness[y]);
        }
}

/// The same in these numbers, which are neither real64 nor vanilla's.
void fill_flats_in(NumberKind number, const PlainFlats& flats);

// The inner loops where a pixel shows several texels (render/sampling.h): what stands in for fill_walls and
// fill_flats of kernels.h then, pixel by pixel, and as far away as one likes.

/// Two neighbouring columns or rows of texels of a picture that repeats.
struct TexelPair {
    std::uint32_t first, second;  ///< below the picture's side
    std::uint32_t part;           ///< of kBlendParts from the first's middle to the second's, less than that
};

/// Those whose middles a place lies between. size_px: of the picture along this side, < 2^31.
inline TexelPair texels_around(TilePlace place, std::uint32_t size_px) {
    constexpr int kPlaceBits = 32;
    constexpr std::uint64_t kHalfTexel = std::uint64_t{1} << (kPlaceBits - 1), kHalfPart = kHalfTexel >> kBlendBits;
    const std::uint64_t whole = std::uint64_t{size_px} << kPlaceBits;
    std::uint64_t at = std::uint64_t{place} * size_px + whole - kHalfTexel + kHalfPart;
    at -= at >= whole ? whole : 0;
    const auto first = static_cast<std::uint32_t>(at >> kPlaceBits);
    return {first, first + 1 == size_px ? 0 : first + 1,
            static_cast<std::uint32_t>(at >> (kPlaceBits - kBlendBits)) & (kBlendParts - 1)};
}

/// Four texels 0xAABBGGRR, two down the first column and two down the second; only their colours count.
struct FourTexels {
    std::uint32_t upper_left, lower_left, upper_right, lower_right;
};

/// Their mean by how near they are. across, down: of kBlendParts. Opaque.
std::uint32_t blended(const FourTexels& texels, std::uint32_t across, std::uint32_t down);

/// Between two colours, `part` of kBlendParts of the way. Opaque.
std::uint32_t mixed(std::uint32_t color, std::uint32_t next, std::uint32_t part);

/// How texels of some columns of a wall are blended.
struct WallBlend {
    const TilePlace* u;          ///< of each column [count]
    const Texture* smaller;      ///< the next smaller picture; null: there is none to mix with
    const std::uint32_t* parts;  ///< of the way to it, of each column [count]; where there is one
};

/// As PlainKernels::fill_walls; first_texels do not count.
void fill_blended_walls(const PlainWalls& walls, const WallBlend& blend);

/// How texels of a flat are blended.
struct FlatBlend {
    const Texture* smaller;          ///< as of walls
    const std::uint32_t* row_parts;  ///< by row
};

/// As PlainKernels::fill_flats, with positions in these numbers, which are not vanilla's, and however far.
void fill_blended_flats(NumberKind number, const PlainFlats& flats, const FlatBlend& blend);

/// The same where places on the picture are position(i, y) of the i-th column and row y.
void fill_blended_flats_at(const PlainFlats& flats, const FlatBlend& blend,
                           const std::function<TexelPosition(int i, int y)>& position);

// Texel positions by the tables and the 16.16 numbers that Doom's renderer had (id Software, "Doom source code", 1997:
// r_main, r_segs, r_plane, r_draw): angles are cut to 8192 a turn, slopes to 2048 an eighth, a wall's scale is stepped
// from one end of it to the other. For comparison only: which surface a pixel shows stays exact.
//
// Lengths are in texels along the width of the surface's picture, as they were on Doom's maps.

/// 1/65536.
using Fixed = std::int32_t;

/// The screen as those formulas know it.
class VanillaScreen {
public:
    /// columns_per_slope: half the width, where the field of view is 90 degrees.
    VanillaScreen(int width, double columns_per_slope);

    int width() const { return width_; }
    double columns_per_slope() const { return columns_per_slope_; }
    /// Where the left edge of column x looks, left of ahead: the first fine angle that the tables put there or farther.
    Angle column_angle(int x) const;

private:
    int first_column(Angle fine) const;

    int width_;  ///< [px]
    double columns_per_slope_;
    std::int64_t columns_per_tangent_;  ///< the same by the table of tangents [1/65536]
};

/// A wall that faces the eye.
class VanillaWall {
public:
    /// left, right: its ends in view space, x right, y ahead.
    VanillaWall(const VanillaScreen& screen, Vec2 left, Vec2 right);

    /// From the left end, of what column x shows.
    double along_at(int x) const;
    /// From a row of column x to the next.
    double per_row_at(int x) const;

private:
    Fixed scale_at(int x) const;

    VanillaScreen screen_;
    Angle normal_;  ///< from the eye to the wall, left of ahead
    Fixed distance_ = 0, offset_ = 0;
    int first_ = 0;  ///< of its columns
    Fixed scale_ = 0, scale_step_ = 0;
};

/// A floor or ceiling.
class VanillaFlat {
public:
    /// height: above or below the eye. forward: of the view. flip: -1 in a mirror.
    VanillaFlat(const VanillaScreen& screen, double height, Vec2 forward, double flip);

    /// From the place under the eye, of what column x shows. rows_per_rise: how many rows the flat is farther from the
    /// horizon for each texel of height, at a depth of one texel; rows: from the horizon, > 0.
    Vec2 at(int x, double rows, double rows_per_rise) const;

private:
    Fixed height_ = 0;
    Fixed start_cos_ = 0, start_sin_ = 0, start_length_ = 0;  ///< of column 0, per unit of distance
    Fixed step_x_ = 0, step_y_ = 0;                           ///< from a column to the next, per unit of distance
};

}  // namespace enfilade::column
