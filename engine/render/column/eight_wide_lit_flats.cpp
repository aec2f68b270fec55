// The light of lamps on floors and ceilings, for processors with AVX2.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)
#include <algorithm>
#include <cmath>
#include <cstring>

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

/// Of each half of the register its bytes `low` and low + 1, in all its 16-bit lanes.
WITH_AVX2 inline __m256i everywhere(__m256i halves, int low) {
    return _mm256_shuffle_epi8(halves, _mm256_set1_epi16(static_cast<short>(low | (low + 1) << 8)));
}

/// Two cells side by side, and two others.
WITH_AVX2 inline __m256i two_and_two(const LightCell* cells, std::uint32_t number, std::uint32_t other) {
    const auto two = [&](std::uint32_t n) __attribute__((always_inline, target("avx2"))) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells + n));
    };
    return _mm256_inserti128_si256(_mm256_castsi128_si256(two(number)), two(other), 1);
}

/// light_between() of eight places, by the numbers of their cells [8]: across between the points of two columns while
/// each place has both of its rows side by side, then along.
WITH_AVX2 inline Channels light_of_each(const LightCell* first, const LightCell* second, const std::uint32_t* n,
                                        __m256i across, __m256i along) {
    const auto two_rows = [&](int i) __attribute__((always_inline, target("avx2"))) {
        return mixed(two_and_two(first, n[i], n[i + 4]), two_and_two(second, n[i], n[i + 4]),
                     everywhere(across, 4 * i));
    };
    const __m256i a = two_rows(0), b = two_rows(1), c = two_rows(2), d = two_rows(3);
    const __m256i even = _mm256_unpacklo_epi64(a, b), odd = _mm256_unpacklo_epi64(c, d);
    const __m256i next_even = _mm256_unpackhi_epi64(a, b), next_odd = _mm256_unpackhi_epi64(c, d);
    return mixed({low_words(even, odd), high_words(even, odd)},
                 {low_words(next_even, next_odd), high_words(next_even, next_odd)}, along);
}

/// A word of some cells, eight times. number: of words of 32 bits, of which a cell has two.
WITH_AVX2 inline __m256i eight_words(const LightCell* cells, int number) {
    int word;  // copied, so that one instruction loads it into all lanes
    std::memcpy(&word, reinterpret_cast<const char*>(cells) + 4 * number, sizeof word);
    return _mm256_set1_epi32(word);
}

/// The same of eight places in one cell. across: in both halves.
WITH_AVX2 inline Channels light_of_one(const LightCell* first, const LightCell* second, __m256i across, __m256i along) {
    const __m256i red_blue = mixed(eight_words(first, 0), eight_words(second, 0), across);
    const __m256i green = mixed(eight_words(first, 1), eight_words(second, 1), across);
    const __m256i next_red_blue = mixed(eight_words(first, 2), eight_words(second, 2), across);
    const __m256i next_green = mixed(eight_words(first, 3), eight_words(second, 3), across);
    return {mixed(red_blue, next_red_blue, along), mixed(green, next_green, along)};
}

/// One direction of a grid, made ready for grid_step_of_shifted().
struct GridAxis {
    __m256d from, per_metre;
    __m256i last;

    /// The places of eight depths. kIsInside: none is beyond the ends.
    template <bool kIsInside>
    WITH_AVX2 __m256i places(__m256d a, __m256d b) const {
        const __m256i places = in_order(places_of(shifted(a), shifted(b)));
        return kIsInside ? places : _mm256_min_epi32(_mm256_max_epi32(places, _mm256_setzero_si256()), last);
    }
    WITH_AVX2 __m256d shifted(__m256d depths) const { return _mm256_add_pd(from, _mm256_mul_pd(depths, per_metre)); }
};

/// count: of points.
WITH_AVX2 inline GridAxis axis_of(double shifted_base, double step, int count) {
    return {_mm256_set1_pd(shifted_base), _mm256_set1_pd(step),
            _mm256_set1_epi32(static_cast<int>(last_grid_place(count)))};
}

/// Of eight places the numbers of their cells. per_column: cells in a column in the upper half, 1 in the lower.
WITH_AVX2 inline __m256i cell_numbers(__m256i across, __m256i along, __m256i per_column) {
    const __m256i columns_and_rows = _mm256_blend_epi16(_mm256_srli_epi32(along, kGridPlaceBits), across, 0b10101010);
    return _mm256_madd_epi16(columns_and_rows, per_column);
}

/// The lower half of each word in both halves.
WITH_AVX2 inline __m256i in_low_halves(__m256i words) {
    return _mm256_shuffle_epi8(words, _mm256_setr_epi8(0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13,  //
                                                       0, 1, 0, 1, 4, 5, 4, 5, 8, 9, 8, 9, 12, 13, 12, 13));
}

/// Where rows of a flat are in its grid. Worked out for many rows before their light is: so the processor can go on to
/// the next eight while it waits for the cells of others.
struct GridPlaces {
    static constexpr int kMost = 128;                  ///< rows; a multiple of eight
    alignas(32) std::uint32_t numbers[kMost + kWide];  ///< of their cells; of eight more the last one's
    alignas(32) std::uint32_t across[kMost];           ///< parts, in the lower half of each
    alignas(32) std::uint32_t along[kMost];            ///< in both halves
};

/// count: of rows; the parts of as many as there are to the next multiple of eight are written. kIsInside: no row is
/// beyond an end of the grid, or cut off.
template <bool kIsInside>
WITH_AVX2 inline void find_places(const FlatLamplight& lamplight, int row, int count, GridPlaces& to) {
    const LightGrid& grid = *lamplight.grid;
    const GridAxis u = axis_of(lamplight.base_u, lamplight.step_u, grid.columns);
    const GridAxis v = axis_of(lamplight.base_v, lamplight.step_v, grid.rows);
    const __m256d farthest = _mm256_set1_pd(lamplight.farthest);
    const __m256i per_column = _mm256_set1_epi32(grid.rows << 16 | 1);
    const double* const depths = lamplight.row_depths + row;
    for (int i = 0; i < count; i += kWide) {
        const __m256d near = _mm256_loadu_pd(depths + i), next = _mm256_loadu_pd(depths + i + 4);
        const __m256d a = kIsInside ? near : _mm256_min_pd(near, farthest);
        const __m256d b = kIsInside ? next : _mm256_min_pd(next, farthest);
        const __m256i across = u.places<kIsInside>(a, b), along = v.places<kIsInside>(a, b);
        store(to.numbers + i, cell_numbers(across, along, per_column));
        store(to.across + i, _mm256_srli_epi16(across, kGridPlaceBits - kLightPartBits));
        store(to.along + i, in_low_halves(_mm256_srli_epi16(along, kGridPlaceBits - kLightPartBits)));
    }
    store(to.numbers + count, _mm256_set1_epi32(static_cast<int>(to.numbers[count - 1])));
}

template <bool kIsAbove>
WITH_AVX2 inline void light_rows_as(const LitRun& to, const LightGrid& grid, const GridPlaces& places,
                                    const std::uint32_t* shades) {
    const LightCell* const first = grid.cells.data();
    const LightCell* const second = first + grid.rows;
    by_eight<kIsAbove>(
        to, [&](__m256i pixels, __m256i texels, int i) __attribute__((always_inline, target("avx2,bmi2"))) {
            const std::uint32_t* const numbers = places.numbers + i;
            const __m256i across = load(places.across + i), along = load(places.along + i);
            const bool is_one = numbers[0] == numbers[kWide - 1];  // rows go one way
            const Channels light =
                is_one ? light_of_one(first + numbers[0], second + numbers[0], in_low_halves(across), along)
                       : light_of_each(first, second, numbers, across, along);
            return lit_eight<kIsAbove>(pixels, texels, load(shades + i), light);
        });
}

template <bool kIsAbove, bool kIsInside>
WITH_AVX2 void light_flat_as(const LitRun& to, const FlatLamplight& lamplight) {
    GridPlaces places;
    for (int i = 0; i < to.run.count; i += GridPlaces::kMost) {
        const int row = to.run.first_row + i, count = std::min(GridPlaces::kMost, to.run.count - i);
        find_places<kIsInside>(lamplight, row, count, places);
        const LitRun part{{to.run.pixels + i, row, count}, kIsAbove ? to.texels + i : nullptr};
        light_rows_as<kIsAbove>(part, *lamplight.grid, places, lamplight.row_shades + row);
    }
}

// Down a column places go one way: only the first row and the last are looked at.

/// Whether holds(position across, position along) of both: cells, and kGridShift more.
template <class Holds>
bool holds_at_both_ends(const LitRun& to, const FlatLamplight& lamplight, const Holds& holds) {
    const auto holds_in = [&](int row) {
        const double depth = std::min(lamplight.row_depths[row], lamplight.farthest);
        return holds(lamplight.base_u + depth * lamplight.step_u, lamplight.base_v + depth * lamplight.step_v);
    };
    return holds_in(to.run.first_row) && holds_in(to.run.first_row + to.run.count - 1);
}

/// Points, and cells before the first one or after the last: so many can be counted in 16 bits.
constexpr int kMostCells = (1 << 15) - 1;

bool is_small(const LightGrid& grid) { return grid.columns <= kMostCells && grid.rows <= kMostCells; }

/// Whether all places, in 2^-16 of a cell, are numbers of 32 bits.
bool is_near(const LitRun& to, const FlatLamplight& lamplight) {
    const auto is_in = [](double shifted) { return std::fabs(shifted - kGridShift) < kMostCells; };
    return holds_at_both_ends(to, lamplight, [&](double u, double v) { return is_in(u) && is_in(v); });
}

/// Whether no row is beyond an end of the grid, or cut off.
bool is_inside(const LitRun& to, const FlatLamplight& lamplight) {
    const double *const first = lamplight.row_depths + to.run.first_row, *const last = first + to.run.count - 1;
    if (std::max(*first, *last) > lamplight.farthest) return false;
    const auto is_in = [](double shifted, int count) {
        return shifted >= kGridShift && shifted < kGridShift + (count - 1);
    };
    const LightGrid& grid = *lamplight.grid;
    return holds_at_both_ends(to, lamplight,
                              [&](double u, double v) { return is_in(u, grid.columns) && is_in(v, grid.rows); });
}

void light_flat(const LitRun& to, const FlatLamplight& lamplight) {
    if (to.run.count == 0) return;
    if (is_small(*lamplight.grid) && is_inside(to, lamplight))
        to.texels ? light_flat_as<true, true>(to, lamplight) : light_flat_as<false, true>(to, lamplight);
    else if (is_small(*lamplight.grid) && is_near(to, lamplight))
        to.texels ? light_flat_as<true, false>(to, lamplight) : light_flat_as<false, false>(to, lamplight);
    else
        scalar_passes().lamps.light_flat(to, lamplight);
}

}  // namespace

LampPasses eight_wide_lamps() { return {eight_wide::mix_cells, eight_wide::light_wall, light_flat}; }

}  // namespace enfilade::column
#endif
