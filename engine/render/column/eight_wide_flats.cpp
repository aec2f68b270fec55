// Floors and ceilings eight pixels at a time, for processors with AVX2, and all kernels for these. Texels are loaded
// one by one: gathering them is no faster where it is fast, and much slower on processors that had to be mended.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

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

/// What becomes of a texel.
enum class DrawnAs : unsigned char { shaded, by_table, painted };

template <DrawnAs kDrawnAs>
WITH_AVX2 inline __m256i drawn_texels(const FlatPicture& p, const FlatPixels& column, int i, const EightNumbers& at) {
    const auto texel = [&](std::uint64_t n) __attribute__((always_inline)) { return static_cast<int>(p.texels[n]); };
    const __m256i eight = _mm256_setr_epi32(
        texel(at.p01 & 0xFFFFFFFFu), texel(at.p01 >> 32), texel(at.p23 & 0xFFFFFFFFu), texel(at.p23 >> 32),
        texel(at.p45 & 0xFFFFFFFFu), texel(at.p45 >> 32), texel(at.p67 & 0xFFFFFFFFu), texel(at.p67 >> 32));
    return kDrawnAs == DrawnAs::painted ? eight : shaded_eight(eight, load(column.darkness + i));
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

template <bool kByShifts, DrawnAs kDrawnAs>
WITH_AVX2 inline void fill_column(const FlatPicture& p, const FlatPixels& column) {
    const __m256d step_u = _mm256_set1_pd(column.step_u), step_v = _mm256_set1_pd(column.step_v);
    const __m256d farthest = _mm256_set1_pd(column.farthest);
    for (int i = 0; i < column.count; i += kWide) {
        if (i + kWide > column.count) i = column.count - kWide;
        const EightNumbers at = numbers_at<kByShifts>(p, column, i, step_u, step_v, farthest);
        if (kDrawnAs == DrawnAs::by_table)
            lay_looked_up(p, column, i, at);
        else
            store(column.pixels + i, drawn_texels<kDrawnAs>(p, column, i, at));
    }
}

/// Fewer than eight pixels: of eight those that are wanted.
template <bool kByShifts, DrawnAs kDrawnAs>
WITH_AVX2 [[gnu::noinline]] void fill_short_column(const FlatPicture& p, const FlatPixels& column) {
    const EightNumbers at = numbers_at<kByShifts>(p, column, 0, _mm256_set1_pd(column.step_u),
                                                  _mm256_set1_pd(column.step_v), _mm256_set1_pd(column.farthest));
    if (kDrawnAs != DrawnAs::by_table)
        return store_first(column.pixels, column.count, drawn_texels<kDrawnAs>(p, column, 0, at));
    const std::uint64_t twos[] = {at.p01, at.p23, at.p45, at.p67};
    for (int i = 0; i < column.count; ++i) {
        const auto number = static_cast<std::uint32_t>(twos[i / 2] >> i % 2 * 32);
        column.pixels[i] = p.colors[column.darkness[i] + p.numbers[number]];
    }
}

template <bool kByShifts, DrawnAs kDrawnAs>
WITH_AVX2 void fill_flats_as(const PlainFlats& f) {
    const FlatPicture picture = picture_of(f);
    for (int i = 0; i < f.runs.count; ++i) {
        const int top = f.runs.tops[i], count = f.runs.bottoms[i] - top;
        if (count <= 0) continue;
        const FlatPixels column{f.runs.pixels + i * f.runs.pitch + top,
                                count,
                                f.row_depths + top,
                                kDrawnAs == DrawnAs::painted ? nullptr : f.row_darkness + top,
                                f.step_u[i],
                                f.step_v[i],
                                f.farthest[i]};
        if (count >= kWide)
            fill_column<kByShifts, kDrawnAs>(picture, column);
        else
            fill_short_column<kByShifts, kDrawnAs>(picture, column);
    }
}

template <DrawnAs kDrawnAs>
void fill_flats_by_size(const PlainFlats& f) {
    if (is_power_of_two(f.texture->width) && is_power_of_two(f.texture->height))
        fill_flats_as<true, kDrawnAs>(f);
    else
        fill_flats_as<false, kDrawnAs>(f);
}

void fill_flats(const PlainFlats& f) {
    f.color_table ? fill_flats_by_size<DrawnAs::by_table>(f) : fill_flats_by_size<DrawnAs::shaded>(f);
}

}  // namespace

std::optional<PlainKernels> eight_wide_kernels() {
    if (!has_avx2()) return {};
    return PlainKernels{"avx2",
                        eight_wide::fill_walls,
                        fill_flats,
                        eight_wide::fill_sky,
                        eight_wide::read_walls,
                        eight_wide::lay_walls,
                        fill_flats_by_size<DrawnAs::painted>};
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
std::optional<PlainKernels> eight_wide_kernels() { return {}; }
}  // namespace enfilade::column
#endif
