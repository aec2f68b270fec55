// The light of lamps for processors with AVX2. A pixel's channels lie in two words of 32 bits: red and blue, two halves
// of 16 bits each, in one, green in the other. So one multiplication of halves serves eight pixels, and their upper
// halves are all that is wanted of the products.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;
constexpr int kPartBits = 8;  ///< of the way between two points of light
constexpr int kStepBits = 4;
static_assert(1 << kStepBits == kLightSteps);

/// Of eight pixels.
struct Channels {
    __m256i red_blue, green;
};

/// 0xAABBGGRR, each channel times 256.
WITH_AVX2 inline Channels channels_of(__m256i pixels) {
    return {_mm256_slli_epi16(pixels, 8), _mm256_and_si256(pixels, _mm256_set1_epi32(0x0000FF00))};
}

/// Channels of at most 511 as opaque pixels, cut at 255.
WITH_AVX2 inline __m256i pixels_of(const Channels& c) {
    const __m256i full = _mm256_set1_epi16(255);
    const __m256i colors =
        _mm256_or_si256(_mm256_min_epi16(c.red_blue, full), _mm256_slli_epi32(_mm256_min_epi16(c.green, full), 8));
    return _mm256_or_si256(colors, _mm256_set1_epi32(static_cast<int>(0xFF000000u)));
}

/// between(): a + (b - a) * part / 256, where `part` is in both halves, times 64.
WITH_AVX2 inline __m256i mixed(__m256i a, __m256i b, __m256i part) {
    return _mm256_add_epi16(a, _mm256_mulhi_epi16(_mm256_slli_epi16(_mm256_sub_epi16(b, a), 2), part));
}
WITH_AVX2 inline Channels mixed(const Channels& a, const Channels& b, __m256i part) {
    return {mixed(a.red_blue, b.red_blue, part), mixed(a.green, b.green, part)};
}

/// The parts of eight positions that count 256 to a cell, as mixed() wants them.
WITH_AVX2 inline __m256i parts_of(__m256i positions, __m256i cells) {
    return in_both_halves(_mm256_slli_epi32(_mm256_sub_epi32(positions, _mm256_slli_epi32(cells, kPartBits)), 6));
}

/// Two cells side by side, and two others.
WITH_AVX2 inline __m256i two_and_two(const LightCell* cells, std::uint32_t number, std::uint32_t other) {
    const auto two = [&](std::uint32_t n) __attribute__((always_inline, target("avx2"))) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(cells + n));
    };
    return _mm256_inserti128_si256(_mm256_castsi128_si256(two(number)), two(other), 1);
}

/// Eight points of light, and of each the next one.
struct CellPairs {
    Channels points, next;
};

/// Those of these numbers [8].
WITH_AVX2 inline CellPairs eight_cells(const LightCell* cells, const std::uint32_t* n) {
    const __m256i a = two_and_two(cells, n[0], n[4]), b = two_and_two(cells, n[1], n[5]);
    const __m256i c = two_and_two(cells, n[2], n[6]), d = two_and_two(cells, n[3], n[7]);
    const __m256i even = _mm256_unpacklo_epi64(a, b), odd = _mm256_unpacklo_epi64(c, d);
    const __m256i next_even = _mm256_unpackhi_epi64(a, b), next_odd = _mm256_unpackhi_epi64(c, d);
    return {{low_words(even, odd), high_words(even, odd)},
            {low_words(next_even, next_odd), high_words(next_even, next_odd)}};
}

/// Eight times the same.
WITH_AVX2 inline CellPairs one_cell(const LightCell* cell) {
    const auto words = [&](std::uint64_t word) __attribute__((always_inline, target("avx2"))) {
        return _mm256_set1_epi32(static_cast<int>(word));
    };
    return {{words(cell[0]), words(cell[0] >> 32)}, {words(cell[1]), words(cell[1] >> 32)}};
}

/// light_between().
WITH_AVX2 inline Channels mixed(const CellPairs& first, const CellPairs& second, __m256i across, __m256i along) {
    return mixed(mixed(first.points, second.points, across), mixed(first.next, second.next, across), along);
}

/// lit(), or lit_above() where a table has darkened the pixels. shades: in both halves.
template <bool kIsAbove>
WITH_AVX2 inline __m256i lit_eight(__m256i pixels, __m256i texels, __m256i shades, const Channels& light) {
    const __m256i most = _mm256_set1_epi16(static_cast<short>(kBrightest));
    const Channels colors = channels_of(kIsAbove ? texels : pixels);
    const auto bright = [&](__m256i lanes) __attribute__((always_inline, target("avx2"))) {
        const __m256i more = _mm256_srli_epi16(lanes, kStepBits);
        return kIsAbove ? _mm256_min_epi16(more, _mm256_sub_epi16(most, shades))
                        : _mm256_min_epi16(_mm256_add_epi16(more, shades), most);
    };
    Channels sum{_mm256_mulhi_epu16(colors.red_blue, bright(light.red_blue)),
                 _mm256_mulhi_epu16(colors.green, bright(light.green))};
    if (kIsAbove) {
        sum.red_blue = _mm256_add_epi16(sum.red_blue, _mm256_and_si256(pixels, _mm256_set1_epi32(0x00FF00FF)));
        sum.green =
            _mm256_add_epi16(sum.green, _mm256_and_si256(_mm256_srli_epi32(pixels, 8), _mm256_set1_epi32(0xFF)));
    }
    return pixels_of(sum);
}

WITH_AVX2 void mix_cells(const LightCell* a, const LightCell* b, std::uint32_t part, const LightRow& to) {
    const __m256i parts = in_both_halves(_mm256_set1_epi32(static_cast<int>(part << 6)));
    const auto four = [&](int from, __m128i is_there) __attribute__((always_inline, target("avx2"))) {
        const __m256i mask = _mm256_cvtepi32_epi64(is_there);
        return mixed(_mm256_maskload_epi64(reinterpret_cast<const long long*>(a + from), mask),
                     _mm256_maskload_epi64(reinterpret_cast<const long long*>(b + from), mask), parts);
    };
    for (int i = 0; i < to.count; i += kWide) {
        const __m256i is_there = first_words(to.count - i);
        const __m256i first = four(i, _mm256_castsi256_si128(is_there));
        const __m256i second = four(i + 4, _mm256_extracti128_si256(is_there, 1));
        const __m256i even = _mm256_permute2x128_si256(first, second, 0x20);
        const __m256i odd = _mm256_permute2x128_si256(first, second, 0x31);
        store(to.red_blue + i, low_words(even, odd));
        store(to.green + i, high_words(even, odd));
    }
}

/// Positions down a wall, eight at a time, and the cells they are in.
template <bool kIsInside>
struct WallPositions {
    __m256i even, odd;  ///< of rows 0 1 4 5 and 2 3 6 7 of the eight
    __m256i way;        ///< to the next eight
    __m256i last_cell;

    WITH_AVX2 void advance() {
        even = _mm256_add_epi64(even, way);
        odd = _mm256_add_epi64(odd, way);
    }
    WITH_AVX2 __m256i cells() const {
        const __m256i cells = high_words(even, odd);
        if (kIsInside) return cells;
        return _mm256_max_epi32(_mm256_min_epi32(cells, last_cell), _mm256_setzero_si256());
    }
    /// As mixed() wants them.
    WITH_AVX2 __m256i parts() const {
        const __m256i top_bytes = _mm256_setr_epi8(-1, 3, -1, 3, -1, 7, -1, 7, -1, 11, -1, 11, -1, 15, -1, 15,  //
                                                   -1, 3, -1, 3, -1, 7, -1, 7, -1, 11, -1, 11, -1, 15, -1, 15);
        const __m256i parts = _mm256_srli_epi16(_mm256_shuffle_epi8(low_words(even, odd), top_bytes), 2);
        if (kIsInside) return parts;
        const __m256i cells = high_words(even, odd);
        const __m256i is_after = _mm256_cmpgt_epi32(cells, last_cell), is_before = _mm256_srai_epi32(cells, 31);
        const __m256i at_end = _mm256_and_si256(is_after, _mm256_set1_epi16(255 << 6));
        return _mm256_andnot_si256(is_before, _mm256_or_si256(parts, at_end));
    }
};

template <bool kIsInside>
WITH_AVX2 inline WallPositions<kIsInside> positions_of(const Run& run, const WallLamplight& lamplight) {
    const auto row = [&](std::uint64_t i) {
        return static_cast<long long>(lamplight.at_row_0 +
                                      lamplight.per_row * (static_cast<std::uint64_t>(run.first_row) + i));
    };
    return {_mm256_setr_epi64x(row(0), row(1), row(4), row(5)), _mm256_setr_epi64x(row(2), row(3), row(6), row(7)),
            _mm256_set1_epi64x(static_cast<long long>(lamplight.per_row * kWide)),
            _mm256_set1_epi32(lamplight.cells.count - 2)};
}

/// The light of these cells, none of which is more than seven after the last of them.
WITH_AVX2 inline Channels near_cells(const LightRow& row, int first, __m256i numbers) {
    return {_mm256_permutevar8x32_epi32(load(row.red_blue + first), numbers),
            _mm256_permutevar8x32_epi32(load(row.green + first), numbers)};
}

template <bool kIsAbove, bool kIsInside>
WITH_AVX2 void light_wall_as(const LitRun& to, const WallLamplight& lamplight) {
    WallPositions<kIsInside> positions = positions_of<kIsInside>(to.run, lamplight);
    const __m256i shades = _mm256_set1_epi16(static_cast<short>(lamplight.shade));
    const LightRow row = lamplight.cells;
    by_eight<kIsAbove>(
        to, [&](__m256i pixels, __m256i texels, int) __attribute__((always_inline, target("avx2,bmi2"))) {
            const __m256i cells = positions.cells();
            const int first = _mm256_extract_epi32(cells, kWide - 1);  // positions fall
            const __m256i numbers = _mm256_sub_epi32(cells, _mm256_set1_epi32(first));
            const Channels light =
                mixed(near_cells(row, first, numbers), near_cells(row, first + 1, numbers), positions.parts());
            positions.advance();
            return lit_eight<kIsAbove>(pixels, texels, shades, light);
        });
}

/// One direction of a grid, made ready for grid_step(): positions count 256 to a cell.
struct GridAxis {
    __m256d from, per_metre, last;
    __m256i last_cell;

    /// Of eight depths.
    WITH_AVX2 __m256i positions(__m256d a, __m256d b) const {
        return _mm256_inserti128_si256(_mm256_castsi128_si256(whole(a)), whole(b), 1);
    }
    WITH_AVX2 __m128i whole(__m256d depths) const {
        const __m256d at = _mm256_add_pd(from, _mm256_mul_pd(depths, per_metre));
        return _mm256_cvttpd_epi32(_mm256_min_pd(_mm256_max_pd(at, _mm256_setzero_pd()), last));
    }
    WITH_AVX2 __m256i cells(__m256i positions) const {
        return _mm256_min_epi32(_mm256_srli_epi32(positions, kPartBits), last_cell);
    }
};

/// count: of points, of which there is one more than cells.
WITH_AVX2 inline GridAxis axis_of(double base, double step, int count) {
    constexpr double kParts = 1 << kPartBits;
    return {_mm256_set1_pd(base * kParts), _mm256_set1_pd(step * kParts), _mm256_set1_pd((count - 1) * kParts),
            _mm256_set1_epi32(count - 2)};
}

/// The light of these cells [8]. Near the eye eight rows are mostly within one.
WITH_AVX2 inline Channels light_of_cells(const LightCell* first, const LightCell* second, __m256i numbers,
                                         __m256i across, __m256i along) {
    const __m256i is_same = _mm256_cmpeq_epi32(numbers, _mm256_broadcastd_epi32(_mm256_castsi256_si128(numbers)));
    if (_mm256_movemask_epi8(is_same) == -1) {
        const auto number = static_cast<std::uint32_t>(_mm256_cvtsi256_si32(numbers));
        return mixed(one_cell(first + number), one_cell(second + number), across, along);
    }
    alignas(32) std::uint32_t each[kWide];
    _mm256_store_si256(reinterpret_cast<__m256i*>(each), numbers);
    return mixed(eight_cells(first, each), eight_cells(second, each), across, along);
}

template <bool kIsAbove>
WITH_AVX2 void light_flat_as(const LitRun& to, const FlatLamplight& lamplight) {
    const LightGrid& grid = *lamplight.grid;
    const GridAxis u = axis_of(lamplight.base_u, lamplight.step_u, grid.columns);
    const GridAxis v = axis_of(lamplight.base_v, lamplight.step_v, grid.rows);
    const __m256d farthest = _mm256_set1_pd(lamplight.farthest);
    const __m256i column_length = _mm256_set1_epi32(grid.rows);
    const LightCell* const first = grid.cells.data();
    const LightCell* const second = first + grid.rows;
    const double* const depths = lamplight.row_depths + to.run.first_row;
    const Shade* const shades = lamplight.row_shades + to.run.first_row;
    by_eight<kIsAbove>(to, [&](__m256i pixels, __m256i texels,
                               int i) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256d a = _mm256_min_pd(_mm256_loadu_pd(depths + i), farthest);
        const __m256d b = _mm256_min_pd(_mm256_loadu_pd(depths + i + 4), farthest);
        const __m256i across = u.positions(a, b), along = v.positions(a, b);
        const __m256i columns = u.cells(across), rows = v.cells(along);
        const __m256i numbers = _mm256_add_epi32(_mm256_mullo_epi32(columns, column_length), rows);
        const Channels light = light_of_cells(first, second, numbers, parts_of(across, columns), parts_of(along, rows));
        return lit_eight<kIsAbove>(pixels, texels, in_both_halves(load(shades + i)), light);
    });
}

/// Whether eight rows are within eight cells.
bool is_near(const WallLamplight& lamplight) {
    constexpr std::int64_t kCell = std::int64_t{1} << 32;
    const auto per_row = static_cast<std::int64_t>(lamplight.per_row);
    return -kCell <= per_row && per_row <= 0;
}

/// Whether all rows are at places between the points. The seven that may be looked at after them need not be.
bool is_inside(const LitRun& to, const WallLamplight& lamplight) {
    const auto position = [&](int row) {
        return lamplight.at_row_0 + lamplight.per_row * static_cast<std::uint64_t>(row);
    };
    const std::uint64_t end = static_cast<std::uint64_t>(lamplight.cells.count - 1) << 32;
    return position(to.run.first_row) < end && position(to.run.first_row + to.run.count - 1) < end;
}

void light_wall(const LitRun& to, const WallLamplight& lamplight) {
    if (!is_near(lamplight)) return scalar_passes().lamps.light_wall(to, lamplight);
    if (is_inside(to, lamplight))
        to.texels ? light_wall_as<true, true>(to, lamplight) : light_wall_as<false, true>(to, lamplight);
    else
        to.texels ? light_wall_as<true, false>(to, lamplight) : light_wall_as<false, false>(to, lamplight);
}

void light_flat(const LitRun& to, const FlatLamplight& lamplight) {
    constexpr int kMostPoints = 1 << 22;  // so that 256 of them to a point are a number of 32 bits
    if (lamplight.grid->columns > kMostPoints || lamplight.grid->rows > kMostPoints)
        return scalar_passes().lamps.light_flat(to, lamplight);
    to.texels ? light_flat_as<true>(to, lamplight) : light_flat_as<false>(to, lamplight);
}

}  // namespace

LampPasses eight_wide_lamps() { return {mix_cells, light_wall, light_flat}; }

}  // namespace enfilade::column
#endif
