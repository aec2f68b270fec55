// Eight pixels at a time, for processors with AVX2. Texels are loaded one by one: gathering them is no faster where it
// is fast, and much slower on processors that had to be mended.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)
#include "render/column/kernels.h"

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

/// Four columns of eight lanes each that are numbered 0 1 4 5 2 3 6 7, as two sums of four doubles leave them.
WITH_AVX2 inline __m256i places_of(__m256d a, __m256d b) {
    return _mm256_castps_si256(_mm256_shuffle_ps(_mm256_castpd_ps(a), _mm256_castpd_ps(b), _MM_SHUFFLE(2, 0, 2, 0)));
}

WITH_AVX2 inline __m256i shaded_eight(__m256i colors, __m256i shades) {
    const __m256i even = _mm256_and_si256(colors, _mm256_set1_epi32(0x00FF00FF));
    const __m256i green = _mm256_and_si256(colors, _mm256_set1_epi32(0x0000FF00));
    const __m256i red_blue = _mm256_srli_epi16(_mm256_mullo_epi16(even, shades), 8);
    const __m256i dark_green = _mm256_slli_epi32(_mm256_mulhi_epu16(green, shades), 8);
    return _mm256_or_si256(_mm256_or_si256(red_blue, dark_green), _mm256_set1_epi32(static_cast<int>(0xFF000000u)));
}

/// Of eight places the whole part of place * size / 2^32.
WITH_AVX2 inline __m256i scaled(__m256i places, __m256i size) {
    const __m256i even = _mm256_srli_epi64(_mm256_mul_epu32(places, size), 32);
    const __m256i odd = _mm256_mul_epu32(_mm256_srli_epi64(places, 32), size);
    return _mm256_blend_epi32(even, odd, 0b10101010);
}

/// A texture column of a wall under one light.
template <bool kByShifts>
struct Texels {
    const std::uint32_t* texels;
    int height;
    RowNumber<kByShifts> row_at;
    __m256i shades;

    /// Of eight rows, one by one.
    WITH_AVX2 __m256i far(TileSteps v, TileSteps step) const {
        const TileSteps w = v + 4 * step;
        const auto texel = [&](TileSteps from)
                               __attribute__((always_inline)) { return static_cast<int>(texels[row_at(from)]); };
        return _mm256_setr_epi32(texel(v), texel(v + step), texel(v + 2 * step), texel(v + 3 * step), texel(w),
                                 texel(w + step), texel(w + 2 * step), texel(w + 3 * step));
    }

    /// Of eight rows, none of which is more than a texel below the one before: eight texels side by side hold theirs.
    /// places: TilePlace of each.
    WITH_AVX2 __m256i near(__m256i places, TileSteps v, TileSteps step) const {
        const auto first = static_cast<int>(row_at(v));
        if (first + kWide > height) return far(v, step);  // the picture ends, and begins again
        const __m256i rows =
            kByShifts ? _mm256_srl_epi32(places, _mm_cvtsi32_si128(32 - bits_below(static_cast<std::uint32_t>(height))))
                      : scaled(places, _mm256_set1_epi32(height));
        return _mm256_permutevar8x32_epi32(load(texels + first), _mm256_sub_epi32(rows, _mm256_set1_epi32(first)));
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

template <bool kByShifts>
WITH_AVX2 inline void fill_far_wall(const WallColumn& to, const Texels<kByShifts>& from) {
    fill_wall(to, [&](TileSteps v) __attribute__((always_inline, target("avx2,bmi2"))) {
        return shaded_eight(from.far(v, to.step), from.shades);
    });
}

/// Where a row is at most a texel below the one before.
template <bool kByShifts>
WITH_AVX2 inline void fill_near_wall(const WallColumn& to, const Texels<kByShifts>& from) {
    const auto steps = [&](TileSteps n) { return static_cast<long long>(n * to.step); };
    const __m256i even = _mm256_setr_epi64x(0, steps(1), steps(4), steps(5));
    const __m256i odd = _mm256_setr_epi64x(steps(2), steps(3), steps(6), steps(7));
    fill_wall(to, [&](TileSteps v) __attribute__((always_inline, target("avx2,bmi2"))) {
        const __m256i first = _mm256_set1_epi64x(static_cast<long long>(v));
        const __m256i places = high_words(_mm256_add_epi64(first, even), _mm256_add_epi64(first, odd));
        return shaded_eight(from.near(places, v, to.step), from.shades);
    });
}

template <bool kByShifts>
WITH_AVX2 void fill_walls_as(const PlainWalls& w) {
    const std::uint32_t height = w.texture->height;
    const RowNumber<kByShifts> row_at(height);
    const TileSteps one_texel = ~TileSteps{0} / height;
    for (int i = 0; i < w.runs.count; ++i) {
        const WallColumn to = column_of(w, i);
        if (to.count <= 0) continue;
        const Texels<kByShifts> from{&w.texture->pixels[w.first_texels[i]], static_cast<int>(height), row_at,
                                     _mm256_set1_epi16(static_cast<short>(w.shades[i]))};
        to.step <= one_texel ? fill_near_wall(to, from) : fill_far_wall(to, from);
    }
}

/// Looking up gains nothing from eight at a time.
void fill_walls(const PlainWalls& w) {
    const std::uint32_t height = w.texture->height;
    if (w.color_table)
        four_wide_kernels()->fill_walls(w);
    else
        height > 1 && is_power_of_two(height) ? fill_walls_as<true>(w) : fill_walls_as<false>(w);
}

/// What all columns of a flat have in common.
struct FlatPicture {
    __m256i width, height;
    __m128i to_column, to_row, row_bits;
    __m256d base_u, base_v;
    const std::uint32_t* texels;
    const std::uint8_t* numbers;
    const std::uint32_t* colors;
};

WITH_AVX2 inline FlatPicture picture_of(const PlainFlats& f) {
    const Texture& t = *f.texture;
    return {_mm256_set1_epi32(static_cast<int>(t.width)),
            _mm256_set1_epi32(static_cast<int>(t.height)),
            _mm_cvtsi32_si128(32 - bits_below(t.width)),
            _mm_cvtsi32_si128(32 - bits_below(t.height)),
            _mm_cvtsi32_si128(bits_below(t.height)),
            _mm256_set1_pd(f.base_u),
            _mm256_set1_pd(f.base_v),
            t.pixels.data(),
            t.numbers.data(),
            f.color_table ? f.color_table->at_level(0) : nullptr};
}

template <bool kByShifts>
WITH_AVX2 inline __m256i texel_numbers(const FlatPicture& p, __m256i u, __m256i v) {
    if (kByShifts)
        return _mm256_or_si256(_mm256_sll_epi32(_mm256_srl_epi32(u, p.to_column), p.row_bits),
                               _mm256_srl_epi32(v, p.to_row));
    return _mm256_add_epi32(_mm256_mullo_epi32(scaled(u, p.width), p.height), scaled(v, p.height));
}

/// One column of a flat.
struct FlatPixels {
    std::uint32_t* pixels;  ///< the first that is drawn
    int count;
    const double* depths;
    const std::uint32_t* darkness;
    double step_u, step_v, farthest;
};

/// The numbers of eight texels, by pixel.
struct EightNumbers {
    std::uint64_t p01, p23, p45, p67;
};

template <bool kByShifts>
WITH_AVX2 inline EightNumbers numbers_at(const FlatPicture& p, const FlatPixels& column, int i, __m256d step_u,
                                         __m256d step_v, __m256d farthest) {
    const __m256d shift = _mm256_set1_pd(kStepShift);
    const __m256d a = _mm256_min_pd(_mm256_loadu_pd(column.depths + i), farthest);
    const __m256d b = _mm256_min_pd(_mm256_loadu_pd(column.depths + i + 4), farthest);
    const __m256i u = places_of(_mm256_add_pd(_mm256_add_pd(p.base_u, _mm256_mul_pd(a, step_u)), shift),
                                _mm256_add_pd(_mm256_add_pd(p.base_u, _mm256_mul_pd(b, step_u)), shift));
    const __m256i v = places_of(_mm256_add_pd(_mm256_add_pd(p.base_v, _mm256_mul_pd(a, step_v)), shift),
                                _mm256_add_pd(_mm256_add_pd(p.base_v, _mm256_mul_pd(b, step_v)), shift));
    const __m256i at = texel_numbers<kByShifts>(p, u, v);
    const __m128i first = _mm256_castsi256_si128(at), second = _mm256_extracti128_si256(at, 1);
    return {static_cast<std::uint64_t>(_mm_cvtsi128_si64(first)), static_cast<std::uint64_t>(_mm_cvtsi128_si64(second)),
            static_cast<std::uint64_t>(_mm_extract_epi64(first, 1)),
            static_cast<std::uint64_t>(_mm_extract_epi64(second, 1))};
}

WITH_AVX2 inline __m256i shaded_texels(const FlatPicture& p, const FlatPixels& column, int i, const EightNumbers& at) {
    const auto texel = [&](std::uint64_t n) __attribute__((always_inline)) { return static_cast<int>(p.texels[n]); };
    const __m256i eight = _mm256_setr_epi32(
        texel(at.p01 & 0xFFFFFFFFu), texel(at.p01 >> 32), texel(at.p23 & 0xFFFFFFFFu), texel(at.p23 >> 32),
        texel(at.p45 & 0xFFFFFFFFu), texel(at.p45 >> 32), texel(at.p67 & 0xFFFFFFFFu), texel(at.p67 >> 32));
    return shaded_eight(eight, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(column.darkness + i)));
}

inline void lay_looked_up(const FlatPicture& p, const FlatPixels& column, int i, const EightNumbers& at) {
    const std::uint32_t* const darkness = column.darkness + i;
    std::uint32_t* const pixels = column.pixels + i;
    const auto lay_two = [&](int k, std::uint64_t two) __attribute__((always_inline)) {
        const std::uint32_t a = p.colors[darkness[k] + p.numbers[static_cast<std::uint32_t>(two)]];
        const std::uint32_t b = p.colors[darkness[k + 1] + p.numbers[two >> 32]];
        pixels[k] = a;
        pixels[k + 1] = b;
    };
    lay_two(0, at.p01);
    lay_two(2, at.p23);
    lay_two(4, at.p45);
    lay_two(6, at.p67);
}

template <bool kByShifts, bool kByTable>
WITH_AVX2 inline void fill_column(const FlatPicture& p, const FlatPixels& column) {
    const __m256d step_u = _mm256_set1_pd(column.step_u), step_v = _mm256_set1_pd(column.step_v);
    const __m256d farthest = _mm256_set1_pd(column.farthest);
    for (int i = 0; i < column.count; i += kWide) {
        if (i + kWide > column.count) i = column.count - kWide;
        const EightNumbers at = numbers_at<kByShifts>(p, column, i, step_u, step_v, farthest);
        if (kByTable)
            lay_looked_up(p, column, i, at);
        else
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(column.pixels + i), shaded_texels(p, column, i, at));
    }
}

/// Fewer than eight pixels: of eight those that are wanted.
template <bool kByShifts, bool kByTable>
WITH_AVX2 [[gnu::noinline]] void fill_short_column(const FlatPicture& p, const FlatPixels& column) {
    const EightNumbers at = numbers_at<kByShifts>(p, column, 0, _mm256_set1_pd(column.step_u),
                                                  _mm256_set1_pd(column.step_v), _mm256_set1_pd(column.farthest));
    if (!kByTable) {
        store_first(column.pixels, column.count, shaded_texels(p, column, 0, at));
        return;
    }
    const std::uint64_t twos[] = {at.p01, at.p23, at.p45, at.p67};
    for (int i = 0; i < column.count; ++i) {
        const auto number = static_cast<std::uint32_t>(twos[i / 2] >> i % 2 * 32);
        column.pixels[i] = p.colors[column.darkness[i] + p.numbers[number]];
    }
}

template <bool kByShifts, bool kByTable>
WITH_AVX2 void fill_flats_as(const PlainFlats& f) {
    const FlatPicture picture = picture_of(f);
    for (int i = 0; i < f.runs.count; ++i) {
        const int top = f.runs.tops[i], count = f.runs.bottoms[i] - top;
        if (count <= 0) continue;
        const FlatPixels column{f.runs.pixels + i * f.runs.pitch + top,
                                count,
                                f.row_depths + top,
                                f.row_darkness + top,
                                f.step_u[i],
                                f.step_v[i],
                                f.farthest[i]};
        if (count >= kWide)
            fill_column<kByShifts, kByTable>(picture, column);
        else
            fill_short_column<kByShifts, kByTable>(picture, column);
    }
}

void fill_flats(const PlainFlats& f) {
    const bool by_shifts = is_power_of_two(f.texture->width) && is_power_of_two(f.texture->height);
    if (f.color_table)
        by_shifts ? fill_flats_as<true, true>(f) : fill_flats_as<false, true>(f);
    else
        by_shifts ? fill_flats_as<true, false>(f) : fill_flats_as<false, false>(f);
}

}  // namespace

std::optional<PlainKernels> eight_wide_kernels() {
    if (!has_avx2()) return {};
    return PlainKernels{"avx2", fill_walls, fill_flats, four_wide_kernels()->fill_sky};
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
std::optional<PlainKernels> eight_wide_kernels() { return {}; }
}  // namespace enfilade::column
#endif
