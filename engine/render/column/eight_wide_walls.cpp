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

// What becomes of texels.

/// They are drawn in their light, whatever the pixels were before.
struct TexelsInLight {
    __m256i shades;  ///< in both halves

    static constexpr bool kIsLaid = false;
    WITH_AVX2 __m256i operator()(__m256i texels) const { return shaded_eight(texels, shades); }
};

/// They are drawn as they are painted.
struct TexelsAsPainted {
    __m256i counts;  ///< all bits of those of eight that count: where a run is shorter, others are beyond it
    __m256i* any;    ///< all that were read, or-ed

    static constexpr bool kIsLaid = false;
    WITH_AVX2 __m256i operator()(__m256i texels) const {
        *any = _mm256_or_si256(*any, _mm256_and_si256(texels, counts));
        return texels;
    }
};

/// They are laid over the pixels in their light. Most of what has holes is either there or not; what is in between is
/// mixed one by one.
struct TexelsLaidOver {
    __m256i shades;  ///< in both halves

    static constexpr bool kIsLaid = true;
    /// The first `count` of eight pixels, if there are fewer.
    WITH_AVX2 void operator()(std::uint32_t* pixels, int count, __m256i texels) const {
        const __m256i opaque = _mm256_set1_epi32(static_cast<int>(0xFF000000u));
        const __m256i alphas = _mm256_and_si256(texels, opaque);
        if (_mm256_testz_si256(alphas, alphas)) return;
        const __m256i is_none = _mm256_cmpeq_epi32(alphas, _mm256_setzero_si256());
        const __m256i is_full = _mm256_cmpeq_epi32(alphas, opaque);
        const __m256i colors = shaded_eight(texels, shades);
        if (_mm256_movemask_epi8(_mm256_or_si256(is_none, is_full)) != -1)
            lay_each(pixels, count, colors, texels);
        else if (count < kWide)
            _mm256_maskstore_epi32(reinterpret_cast<int*>(pixels), _mm256_and_si256(is_full, first_words(count)),
                                   colors);
        else
            store(pixels, _mm256_blendv_epi8(load(pixels), colors, is_full));
    }
    WITH_AVX2 static void lay_each(std::uint32_t* pixels, int count, __m256i colors, __m256i texels) {
        alignas(32) std::uint32_t each_color[kWide], each_texel[kWide];
        store(each_color, colors);
        store(each_texel, texels);
        scalar_passes().blend({pixels, 0, count < kWide ? count : kWide}, each_color, each_texel);
    }
};

/// Draws a column eight rows at a time. texels_at: (position of the first).
template <class Drawing, class TexelsAt>
WITH_AVX2 inline void draw_wall(const WallColumn& to, const Drawing& drawing, const TexelsAt& texels_at) {
    const auto position = [&](int i) { return to.v + to.step * static_cast<TileSteps>(i); };
    if constexpr (Drawing::kIsLaid) {
        for (int i = 0; i < to.count; i += kWide) drawing(to.pixels + i, to.count - i, texels_at(position(i)));
    } else {
        const int last = to.count - kWide;
        if (last < 0) return store_first(to.pixels, to.count, drawing(texels_at(to.v)));
        for (int i = 0; i < to.count; i += kWide) {
            if (i > last) i = last;
            store(to.pixels + i, drawing(texels_at(position(i))));
        }
    }
}

/// The same, where rows are at most kTexels texels apart.
template <int kTexels, bool kByShifts, class Drawing>
WITH_AVX2 inline void draw_near(const WallColumn& to, const Texels<kByShifts>& from, const Drawing& drawing) {
    const auto steps = [&](TileSteps n) { return static_cast<long long>(n * to.step); };
    const __m256i even = _mm256_setr_epi64x(0, steps(1), steps(4), steps(5));
    const __m256i odd = _mm256_setr_epi64x(steps(2), steps(3), steps(6), steps(7));
    draw_wall(to, drawing, [&](TileSteps v) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256i first = _mm256_set1_epi64x(static_cast<long long>(v));
        const __m256i places = high_words(_mm256_add_epi64(first, even), _mm256_add_epi64(first, odd));
        return from.template near<kTexels>(places, v, to.step);
    });
}

/// The same, however far they are apart. Places are cut to 32 bits, so that seven steps may come out as one place more:
/// steps of very nearly a texel may reach an eighth one.
template <bool kByShifts, class Drawing>
WITH_AVX2 inline void draw_from(const WallColumn& to, const Texels<kByShifts>& from, TileSteps one_texel,
                                const Drawing& drawing) {
    constexpr TileSteps kPlace = TileSteps{1} << 32;
    if (to.step < one_texel - kPlace) return draw_near<1>(to, from, drawing);
    if (to.step / 2 < one_texel) return draw_near<2>(to, from, drawing);
    draw_wall(to, drawing,
              [&](TileSteps v) __attribute__((always_inline, target("avx2,bmi2"))) { return from.far(v, to.step); });
}

/// Draws all columns. drawing_of: (i, how many rows) of each.
template <bool kByShifts, class DrawingOf>
WITH_AVX2 inline void draw_columns(const PlainWalls& w, const DrawingOf& drawing_of) {
    const std::uint32_t height = w.texture->height;
    const RowNumber<kByShifts> row_at(height);
    const TileSteps one_texel = ~TileSteps{0} / height;
    for (int i = 0; i < w.runs.count; ++i) {
        const WallColumn to = column_of(w, i);
        if (to.count <= 0) continue;
        const Texels<kByShifts> from{&w.texture->pixels[w.first_texels[i]], static_cast<int>(height), row_at};
        draw_from(to, from, one_texel, drawing_of(i, to.count));
    }
}

/// Drawing: TexelsInLight or TexelsLaidOver.
template <class Drawing, bool kByShifts>
WITH_AVX2 void draw_walls_as(const PlainWalls& w) {
    draw_columns<kByShifts>(w, [&](int i, int) __attribute__((always_inline, target("avx2,bmi2"))) {
        return Drawing{_mm256_set1_epi16(static_cast<short>(w.shades[i]))};
    });
}

template <bool kByShifts>
WITH_AVX2 std::uint32_t read_walls_as(const PlainWalls& w) {
    __m256i any = _mm256_setzero_si256();
    draw_columns<kByShifts>(w, [&](int, int count) __attribute__((always_inline, target("avx2,bmi2"))) {
        return TexelsAsPainted{count < kWide ? first_words(count) : _mm256_set1_epi32(-1), &any};
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

/// By a table. Stretches of rows of which something is seen are filled aside, then laid over.
void lay_by_table(const PlainWalls& w) {
    static constexpr int kMostRows = 128, kFromFirst = 0;
    std::uint32_t texels[kMostRows], colors[kMostRows];
    for (int i = 0; i < w.runs.count; ++i)
        for (int row = w.runs.tops[i]; row < w.runs.bottoms[i]; row += kMostRows) {
            const int count = w.runs.bottoms[i] - row < kMostRows ? w.runs.bottoms[i] - row : kMostRows;
            const TileSteps v = w.v_at_row_0[i] + w.v_per_row[i] * static_cast<TileSteps>(row);
            PlainWalls part{{texels, 0, 1, &kFromFirst, &count},
                            w.texture,
                            w.first_texels + i,
                            &v,
                            w.v_per_row + i,
                            w.shades + i,
                            w.color_table};
            if (eight_wide::read_walls(part) >> 24 == 0) continue;
            part.runs.pixels = colors;
            eight_wide::fill_walls(part);
            eight_wide::blend({w.runs.pixels + i * w.runs.pitch + row, row, count}, colors, texels);
        }
}

}  // namespace

// Colours that are looked up in a table gain nothing from eight at a time.

void eight_wide::fill_walls(const PlainWalls& w) {
    if (w.color_table)
        four_wide_kernels()->fill_walls(w);
    else
        goes_by_shifts(*w.texture) ? draw_walls_as<TexelsInLight, true>(w) : draw_walls_as<TexelsInLight, false>(w);
}

void eight_wide::lay_walls(const PlainWalls& w) {
    if (w.color_table)
        lay_by_table(w);
    else
        goes_by_shifts(*w.texture) ? draw_walls_as<TexelsLaidOver, true>(w) : draw_walls_as<TexelsLaidOver, false>(w);
}

std::uint32_t eight_wide::read_walls(const PlainWalls& w) {
    return goes_by_shifts(*w.texture) ? read_walls_as<true>(w) : read_walls_as<false>(w);
}

void eight_wide::fill_sky(const Run& run, const SkyRun& sky) {
    run.count < kWide ? scalar_kernels().fill_sky(run, sky) : fill_long_sky(run, sky);
}

}  // namespace enfilade::column
#endif
