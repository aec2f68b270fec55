// What the dials of texels do to the positions that kernels draw from (formats/dials.h). The kernels stay what they
// are: a position between two exact ones is another position, a smaller picture is another picture, and columns that
// are drawn alike are drawn once and copied.
//
// Everything is a function of the column or row alone, never of where a run or a strip begins, so that the picture does
// not depend on how it was cut.
#pragma once
#include <algorithm>

#include "formats/dials.h"
#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/column/viewport.h"

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

}  // namespace enfilade::column
