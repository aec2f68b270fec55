// Which texel: by a shift where a picture's side is a power of two, by a product elsewhere; the same numbers. For the
// kernels that draw several pixels at a time.
#pragma once
#include <bit>
#include <cstdint>

#include "render/column/plain_kernels.h"

namespace enfilade::column {

constexpr bool is_power_of_two(std::uint32_t size) { return std::has_single_bit(size); }

/// Such that size = 2^bits_below(size), where it is a power of two.
constexpr int bits_below(std::uint32_t size) { return std::countr_zero(size); }

/// Where steps down a tile fall among the texels of a picture's column.
template <bool kByShifts>
class RowNumber {
public:
    explicit RowNumber(std::uint32_t height) : height_(height), shift_(32 - bits_below(height)) {}
    /// Two shifts, for a picture of one row is shifted by all 64 bits.
    std::size_t operator()(TileSteps v) const { return kByShifts ? (v >> 32) >> shift_ : (v >> 32) * height_ >> 32; }

private:
    std::uint64_t height_;
    int shift_;
};

}  // namespace enfilade::column
