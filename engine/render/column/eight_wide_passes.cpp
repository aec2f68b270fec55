// The light of lamps on walls, fog, and laying over, for processors with AVX2.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

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
        const __m256i top_bytes = _mm256_setr_epi8(2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15,  //
                                                   2, 3, 2, 3, 6, 7, 6, 7, 10, 11, 10, 11, 14, 15, 14, 15);
        const __m256i parts =
            _mm256_srli_epi16(_mm256_shuffle_epi8(low_words(even, odd), top_bytes), 16 - kLightPartBits);
        if (kIsInside) return parts;
        const __m256i cells = high_words(even, odd);
        const __m256i is_after = _mm256_cmpgt_epi32(cells, last_cell), is_before = _mm256_srai_epi32(cells, 31);
        const __m256i at_end = _mm256_and_si256(is_after, _mm256_set1_epi16((1 << kLightPartBits) - 1));
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

WITH_AVX2 inline __m256i eight_times(std::uint32_t word) { return _mm256_set1_epi32(static_cast<int>(word)); }
WITH_AVX2 inline Channels no_light() { return {_mm256_setzero_si256(), _mm256_setzero_si256()}; }

/// One of the cells of a wall, eight times: the light of its first point, and the way to that of its second.
struct WallCell {
    int number = -1;  ///< none
    Channels from = no_light(), way = no_light();

    WITH_AVX2 WallCell() {}
    WITH_AVX2 void look_at(const LightRow& row, int cell) {
        if (cell == number) return;
        from = {eight_times(row.red_blue[cell]), eight_times(row.green[cell])};
        way = {_mm256_sub_epi16(eight_times(row.red_blue[cell + 1]), from.red_blue),
               _mm256_sub_epi16(eight_times(row.green[cell + 1]), from.green)};
        number = cell;
    }
    /// mixed(), where the difference is known.
    WITH_AVX2 Channels at(__m256i parts) const {
        return {_mm256_add_epi16(from.red_blue, _mm256_mulhrs_epi16(way.red_blue, parts)),
                _mm256_add_epi16(from.green, _mm256_mulhrs_epi16(way.green, parts))};
    }
};

template <bool kIsAbove, bool kIsInside>
WITH_AVX2 void light_wall_as(const LitRun& to, const WallLamplight& lamplight) {
    WallPositions<kIsInside> positions = positions_of<kIsInside>(to.run, lamplight);
    const __m256i shades = _mm256_set1_epi16(static_cast<short>(lamplight.shade));
    const LightRow row = lamplight.cells;
    WallCell known;
    std::uint64_t at = lamplight.at_row_0 + lamplight.per_row * static_cast<std::uint64_t>(to.run.first_row);
    by_eight<kIsAbove>(
        to, [&](__m256i pixels, __m256i texels, int) __attribute__((always_inline, target("avx2,bmi2"))) {
            const auto above = static_cast<int>(at >> 32);
            const auto below = static_cast<int>((at + (kWide - 1) * lamplight.per_row) >> 32);  // positions fall
            Channels light;
            if (kIsInside && above == below) {
                known.look_at(row, below);
                light = known.at(positions.parts());
            } else {
                const __m256i cells = positions.cells();
                const int first = kIsInside ? below : _mm256_extract_epi32(cells, kWide - 1);
                const __m256i numbers = _mm256_sub_epi32(cells, _mm256_set1_epi32(first));
                light = mixed(near_cells(row, first, numbers), near_cells(row, first + 1, numbers), positions.parts());
            }
            at += kWide * lamplight.per_row;
            positions.advance();
            return lit_eight<kIsAbove>(pixels, texels, shades, light);
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

/// fogged(): each channel times what the fog leaves of it, and the fog's times the rest.
WITH_AVX2 void add_fog(const Run& run, std::uint32_t fog, const FogPart* fog_parts) {
    const __m256i even = _mm256_set1_epi32(0x00FF00FF), whole = _mm256_set1_epi16(256);
    const __m256i fogs = _mm256_set1_epi32(static_cast<int>(fog));
    const __m256i fog_red_blue = _mm256_and_si256(fogs, even);
    const __m256i fog_green = _mm256_and_si256(_mm256_srli_epi32(fogs, 8), _mm256_set1_epi32(0xFF));
    by_eight<false>({run}, [&](__m256i pixels, __m256i, int i) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256i hidden = in_both_halves(load(fog_parts + i)), clear = _mm256_sub_epi16(whole, hidden);
        const auto sum = [&](__m256i colors, __m256i fog_colors) __attribute__((always_inline, target("avx2"))) {
            return _mm256_add_epi16(_mm256_mullo_epi16(colors, clear), _mm256_mullo_epi16(fog_colors, hidden));
        };
        const __m256i red_blue = _mm256_srli_epi16(sum(_mm256_and_si256(pixels, even), fog_red_blue), 8);
        const __m256i green = _mm256_andnot_si256(
            even, sum(_mm256_and_si256(_mm256_srli_epi32(pixels, 8), _mm256_set1_epi32(0xFF)), fog_green));
        const __m256i alpha = _mm256_and_si256(pixels, _mm256_set1_epi32(static_cast<int>(0xFF000000u)));
        return _mm256_or_si256(_mm256_or_si256(red_blue, green), alpha);
    });
}

}  // namespace

/// Most of what has holes is either there or not; what is in between is mixed one by one.
WITH_AVX2 void eight_wide::blend(const Run& run, const std::uint32_t* colors, const std::uint32_t* texels) {
    const __m256i opaque = _mm256_set1_epi32(static_cast<int>(0xFF000000u));
    int i = 0;
    for (; i + kWide <= run.count; i += kWide) {
        const __m256i alphas = _mm256_and_si256(load(texels + i), opaque);
        const __m256i is_none = _mm256_cmpeq_epi32(alphas, _mm256_setzero_si256());
        const __m256i is_full = _mm256_cmpeq_epi32(alphas, opaque);
        if (_mm256_movemask_epi8(_mm256_or_si256(is_none, is_full)) == -1)
            store(run.pixels + i,
                  _mm256_blendv_epi8(load(run.pixels + i), _mm256_or_si256(load(colors + i), opaque), is_full));
        else
            scalar_passes().blend({run.pixels + i, run.first_row + i, kWide}, colors + i, texels + i);
    }
    scalar_passes().blend({run.pixels + i, run.first_row + i, run.count - i}, colors + i, texels + i);
}

WITH_AVX2 void eight_wide::mix_cells(const LightCell* a, const LightCell* b, LightPart part, const LightRow& to) {
    const __m256i parts = _mm256_set1_epi16(static_cast<short>(part));
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

void eight_wide::light_wall(const LitRun& to, const WallLamplight& lamplight) {
    if (!is_near(lamplight)) return scalar_passes().lamps.light_wall(to, lamplight);
    if (is_inside(to, lamplight))
        to.texels ? light_wall_as<true, true>(to, lamplight) : light_wall_as<false, true>(to, lamplight);
    else
        to.texels ? light_wall_as<true, false>(to, lamplight) : light_wall_as<false, false>(to, lamplight);
}

std::optional<Passes> eight_wide_passes() {
    if (!has_avx2()) return {};
    return Passes{eight_wide_lamps(), add_fog, eight_wide::blend};
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
std::optional<Passes> eight_wide_passes() { return {}; }
}  // namespace enfilade::column
#endif
