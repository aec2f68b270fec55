// Walls and skies eight pixels at a time, for processors with AVX2: what goes down columns of pictures, where eight
// texels side by side mostly hold those of eight rows.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

/// A texture column.
template <bool kByShifts>
struct Texels {
    const std::uint32_t* texels;
    int height;
    RowNumber<kByShifts> row_at;

    /// Of eight rows, one by one.
    WITH_AVX2 __m256i far(TileSteps v, TileSteps step) const {
        const TileSteps w = v + 4 * step;
        const auto texel = [&](TileSteps from)
                               __attribute__((always_inline)) { return static_cast<int>(texels[row_at(from)]); };
        return _mm256_setr_epi32(texel(v), texel(v + step), texel(v + 2 * step), texel(v + 3 * step), texel(w),
                                 texel(w + step), texel(w + 2 * step), texel(w + 3 * step));
    }

    /// Of eight rows, none of which is more than kTexels texels below the one before: eight texels side by side, or
    /// sixteen, hold theirs. places: TilePlace of each.
    template <int kTexels>
    WITH_AVX2 __m256i near(__m256i places, TileSteps v, TileSteps step) const {
        static_assert(kTexels == 1 || kTexels == 2);
        const auto first = static_cast<int>(row_at(v));
        if (first + kTexels * kWide > height) return far(v, step);  // the picture ends, and begins again
        const __m256i rows =
            kByShifts ? _mm256_srl_epi32(places, _mm_cvtsi32_si128(32 - bits_below(static_cast<std::uint32_t>(height))))
                      : scaled(places, _mm256_set1_epi32(height));
        const __m256i numbers = _mm256_sub_epi32(rows, _mm256_set1_epi32(first));
        const __m256i of_first_eight = _mm256_permutevar8x32_epi32(load(texels + first), numbers);
        if (kTexels == 1) return of_first_eight;
        const __m256i of_others = _mm256_permutevar8x32_epi32(load(texels + first + kWide), numbers);
        const __m256i is_other = _mm256_slli_epi32(numbers, 28);  // from 8 on: the bit that is looked at
        return _mm256_castps_si256(_mm256_blendv_ps(_mm256_castsi256_ps(of_first_eight), _mm256_castsi256_ps(of_others),
                                                    _mm256_castsi256_ps(is_other)));
    }
};

/// What is drawn of a column eight rows at a time: eight_at(position of the first).
template <class EightAt>
WITH_AVX2 inline void fill_wall(const WallColumn& to, const EightAt& eight_at) {
    const int last = to.count - kWide;
    if (last < 0) return store_first(to.pixels, to.count, eight_at(to.v));
    for (int i = 0; i < to.count; i += kWide) {
        if (i > last) i = last;
        store(to.pixels + i, eight_at(to.v + to.step * static_cast<TileSteps>(i)));
    }
}

/// Draws what drawn_as(eight texels) makes of the texels of a column, whose rows are at most kTexels texels apart.
template <int kTexels, bool kByShifts, class DrawnAs>
WITH_AVX2 inline void fill_near(const WallColumn& to, const Texels<kByShifts>& from, const DrawnAs& drawn_as) {
    const auto steps = [&](TileSteps n) { return static_cast<long long>(n * to.step); };
    const __m256i even = _mm256_setr_epi64x(0, steps(1), steps(4), steps(5));
    const __m256i odd = _mm256_setr_epi64x(steps(2), steps(3), steps(6), steps(7));
    fill_wall(to, [&](TileSteps v) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256i first = _mm256_set1_epi64x(static_cast<long long>(v));
        const __m256i places = high_words(_mm256_add_epi64(first, even), _mm256_add_epi64(first, odd));
        return drawn_as(from.template near<kTexels>(places, v, to.step));
    });
}

/// The same, however far they are apart. Places are cut to 32 bits, so that seven steps may come out as one place more:
/// steps of very nearly a texel may reach an eighth one.
template <bool kByShifts, class DrawnAs>
WITH_AVX2 inline void fill_from(const WallColumn& to, const Texels<kByShifts>& from, TileSteps one_texel,
                                const DrawnAs& drawn_as) {
    constexpr TileSteps kPlace = TileSteps{1} << 32;
    if (to.step < one_texel - kPlace) return fill_near<1>(to, from, drawn_as);
    if (to.step / 2 < one_texel) return fill_near<2>(to, from, drawn_as);
    fill_wall(to, [&](TileSteps v)
                      __attribute__((always_inline, target("avx2,bmi2"))) { return drawn_as(from.far(v, to.step)); });
}

/// Calls draw(i, column, its texels, steps of one texel) for each column that has rows.
template <bool kByShifts, class Draw>
WITH_AVX2 inline void each_column(const PlainWalls& w, const Draw& draw) {
    const std::uint32_t height = w.texture->height;
    const RowNumber<kByShifts> row_at(height);
    const TileSteps one_texel = ~TileSteps{0} / height;
    for (int i = 0; i < w.runs.count; ++i) {
        const WallColumn to = column_of(w, i);
        if (to.count <= 0) continue;
        const Texels<kByShifts> from{&w.texture->pixels[w.first_texels[i]], static_cast<int>(height), row_at};
        draw(i, to, from, one_texel);
    }
}

template <bool kByShifts>
WITH_AVX2 void fill_walls_as(const PlainWalls& w) {
    each_column<kByShifts>(w, [&](int i, const WallColumn& to, const Texels<kByShifts>& from,
                                  TileSteps one_texel) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256i shades = _mm256_set1_epi16(static_cast<short>(w.shades[i]));
        fill_from(to, from, one_texel, [&](__m256i texels) __attribute__((always_inline, target("avx2,bmi2"))) {
            return shaded_eight(texels, shades);
        });
    });
}

template <bool kByShifts>
WITH_AVX2 std::uint32_t read_walls_as(const PlainWalls& w) {
    __m256i any = _mm256_setzero_si256();
    each_column<kByShifts>(w, [&](int, const WallColumn& to, const Texels<kByShifts>& from,
                                  TileSteps one_texel) __attribute__((always_inline, target("avx2,bmi2"))) {
        // Eight rows of which some are beyond the run would count, too.
        const __m256i counts = to.count < kWide ? first_words(to.count) : _mm256_set1_epi32(-1);
        fill_from(to, from, one_texel, [&](__m256i texels) __attribute__((always_inline, target("avx2,bmi2"))) {
            any = _mm256_or_si256(any, _mm256_and_si256(texels, counts));
            return texels;
        });
    });
    const __m128i four = _mm_or_si128(_mm256_castsi256_si128(any), _mm256_extracti128_si256(any, 1));
    const __m128i two = _mm_or_si128(four, _mm_unpackhi_epi64(four, four));
    return static_cast<std::uint32_t>(_mm_cvtsi128_si32(two) | _mm_extract_epi32(two, 1));
}

/// Eight rows of a sky. is_near: each is at most a texel below the one before.
WITH_AVX2 inline __m256i sky_texels(const SkyRun& sky, int row, bool is_near) {
    const __m256d at_horizon = _mm256_set1_pd(sky.v_at_horizon), per_rise = _mm256_set1_pd(sky.v_per_rise);
    const auto shown = [&](const double* rises) __attribute__((always_inline, target("avx2"))) {
        const __m256d v = _mm256_add_pd(at_horizon, _mm256_mul_pd(_mm256_loadu_pd(rises), per_rise));
        const __m256d inside = _mm256_min_pd(_mm256_max_pd(v, _mm256_setzero_pd()), _mm256_set1_pd(sky.last));
        return _mm256_add_pd(inside, _mm256_set1_pd(kStepShift));
    };
    const double* const rises = sky.row_rises + row;
    const auto height = static_cast<int>(sky.height);
    const __m256i rows = scaled(in_order(places_of(shown(rises), shown(rises + 4))), _mm256_set1_epi32(height));
    const int first = _mm256_cvtsi256_si32(rows), last = _mm256_extract_epi32(rows, kWide - 1);
    if (is_near && first <= last && first + kWide <= height)  // else the picture ends, and begins again
        return _mm256_permutevar8x32_epi32(load(sky.texels + first), _mm256_sub_epi32(rows, _mm256_set1_epi32(first)));
    alignas(32) std::uint32_t each[kWide];
    store(each, rows);
    const auto texel = [&](int i) { return static_cast<int>(sky.texels[each[i]]); };
    return _mm256_setr_epi32(texel(0), texel(1), texel(2), texel(3), texel(4), texel(5), texel(6), texel(7));
}

WITH_AVX2 void fill_long_sky(const Run& run, const SkyRun& sky) {
    const __m256i opaque = _mm256_set1_epi32(static_cast<int>(0xFF000000u));
    constexpr double kLessThanATexel = 1 - 0x1p-16;  // rounded to places, rows may be farther apart than they are
    const bool is_near = sky.v_per_rise <= 0 && -sky.v_per_rise * sky.height < kLessThanATexel;
    for (int i = 0; i < run.count; i += kWide) {
        if (i + kWide > run.count) i = run.count - kWide;
        store(run.pixels + i, _mm256_or_si256(sky_texels(sky, run.first_row + i, is_near), opaque));
    }
}

bool goes_by_shifts(const Texture& texture) { return texture.height > 1 && is_power_of_two(texture.height); }

}  // namespace

/// Looking up gains nothing from eight at a time.
void eight_wide::fill_walls(const PlainWalls& w) {
    if (w.color_table)
        four_wide_kernels()->fill_walls(w);
    else
        goes_by_shifts(*w.texture) ? fill_walls_as<true>(w) : fill_walls_as<false>(w);
}

std::uint32_t eight_wide::read_walls(const PlainWalls& w) {
    return goes_by_shifts(*w.texture) ? read_walls_as<true>(w) : read_walls_as<false>(w);
}

void eight_wide::fill_sky(const Run& run, const SkyRun& sky) {
    run.count < kWide ? scalar_kernels().fill_sky(run, sky) : fill_long_sky(run, sky);
}

}  // namespace enfilade::column
#endif
