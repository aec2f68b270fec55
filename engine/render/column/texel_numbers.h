// What the kernels that draw several pixels at a time have in common: which texel, by a shift where a picture's side is
// a power of two, by a product elsewhere, the same numbers; and where a column of a wall begins.
#pragma once
#include <bit>
#include <cstdint>

#include "render/column/plain_kernels.h"

namespace enfilade::column {

/// size >= 1. (std::has_single_bit() counts all bits where a processor may lack the instruction.)
constexpr bool is_power_of_two(std::uint32_t size) { return (size & (size - 1)) == 0; }

/// Such that size = 2^bits_below(size), where it is a power of two.
constexpr int bits_below(std::uint32_t size) { return std::countr_zero(size); }

/// Where steps down a tile fall among the texels of a picture's column. By shifts only where height > 1.
template <bool kByShifts>
class RowNumber {
public:
    explicit RowNumber(std::uint32_t height) : height_(height), shift_(64 - bits_below(height)) {}
    std::size_t operator()(TileSteps v) const { return kByShifts ? v >> shift_ : (v >> 32) * height_ >> 32; }

private:
    std::uint64_t height_;
    int shift_;
};

/// One column of a wall.
struct WallColumn {
    std::uint32_t* pixels;  ///< the first that is drawn
    int count;
    TileSteps v;  ///< of the first, half a place on
    TileSteps step;
};

inline WallColumn column_of(const PlainWalls& w, int i) {
    const int top = w.runs.tops[i];
    return {w.runs.pixels + i * w.runs.pitch + top, w.runs.bottoms[i] - top,
            w.v_at_row_0[i] + w.v_per_row[i] * static_cast<TileSteps>(top) + kHalfPlace, w.v_per_row[i]};
}

}  // namespace enfilade::column
