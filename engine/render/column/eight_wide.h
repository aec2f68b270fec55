// What the kernels and passes for processors with AVX2 have in common.
#pragma once
#if defined(__x86_64__)
#include <immintrin.h>

#include "render/column/kernels.h"

#define WITH_AVX2 [[gnu::target("avx2,bmi2")]]  // bmi2: shifts by any register

namespace enfilade::column {

/// Pixels at a time.
inline constexpr int kEightWide = 8;

inline bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"); }

WITH_AVX2 inline __m256i load(const std::uint32_t* words) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(words));
}
WITH_AVX2 inline void store(std::uint32_t* words, __m256i eight) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(words), eight);
}

/// The same 16 bits in both halves of each word.
WITH_AVX2 inline __m256i in_both_halves(__m256i words) { return _mm256_or_si256(words, _mm256_slli_epi32(words, 16)); }

/// Low words of eight numbers of 64 bits, or their high ones. a: those numbered 0 1 4 5, b: 2 3 6 7.
WITH_AVX2 inline __m256i low_words(__m256i a, __m256i b) {
    return _mm256_castps_si256(
        _mm256_shuffle_ps(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b), _MM_SHUFFLE(2, 0, 2, 0)));
}
WITH_AVX2 inline __m256i high_words(__m256i a, __m256i b) {
    return _mm256_castps_si256(
        _mm256_shuffle_ps(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b), _MM_SHUFFLE(3, 1, 3, 1)));
}

/// Which of eight words are there, if `count` are.
WITH_AVX2 inline __m256i first_words(int count) {
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}

/// The first `count` of eight, no more.
WITH_AVX2 inline void store_first(std::uint32_t* words, int count, __m256i eight) {
    _mm256_maskstore_epi32(reinterpret_cast<int*>(words), first_words(count), eight);
}

/// Does `eight_at(pixels, texels, i)` to eight pixels after the other, `texels` being eight of a lit run's, if it has
/// any. What else it reads at i may be read up to kRowsBeyond after the run.
template <bool kHasTexels, class EightAt>
WITH_AVX2 inline void by_eight(const LitRun& to, const EightAt& eight_at) {
    std::uint32_t* const pixels = to.run.pixels;
    const int count = to.run.count;
    int i = 0;
    for (; i + kEightWide <= count; i += kEightWide)
        store(pixels + i, eight_at(load(pixels + i), kHasTexels ? load(to.texels + i) : _mm256_setzero_si256(), i));
    if (i == count) return;
    const __m256i is_there = first_words(count - i);
    const auto rest = [&](const std::uint32_t* words) __attribute__((always_inline, target("avx2"))) {
        return _mm256_maskload_epi32(reinterpret_cast<const int*>(words), is_there);
    };
    _mm256_maskstore_epi32(reinterpret_cast<int*>(pixels + i), is_there,
                           eight_at(rest(pixels + i), kHasTexels ? rest(to.texels + i) : _mm256_setzero_si256(), i));
}

/// shaded() of eight colours. shades: in both halves.
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

/// Of eight sums with kStepShift, or with kGridShift, the places, numbered 0 1 4 5 2 3 6 7.
WITH_AVX2 inline __m256i places_of(__m256d a, __m256d b) {
    return low_words(_mm256_castpd_si256(a), _mm256_castpd_si256(b));
}

/// The same places, in order.
WITH_AVX2 inline __m256i in_order(__m256i mixed_up) {
    return _mm256_permute4x64_epi64(mixed_up, _MM_SHUFFLE(3, 1, 2, 0));
}

// The light of lamps: a pixel's channels lie in two words of 32 bits, red and blue, two halves of 16 bits each, in one,
// green in the other. So one multiplication of halves serves eight pixels, and their upper halves are all that is
// wanted of the products.

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
    const __m256i red_green_blue = _mm256_setr_epi8(0, 8, 1, -1, 2, 10, 3, -1, 4, 12, 5, -1, 6, 14, 7, -1,  //
                                                    0, 8, 1, -1, 2, 10, 3, -1, 4, 12, 5, -1, 6, 14, 7, -1);
    const __m256i colors = _mm256_shuffle_epi8(_mm256_packus_epi16(c.red_blue, c.green), red_green_blue);
    return _mm256_or_si256(colors, _mm256_set1_epi32(static_cast<int>(0xFF000000u)));
}

/// between(), where `part` is in each half.
WITH_AVX2 inline __m256i mixed(__m256i a, __m256i b, __m256i part) {
    static_assert(kLightPartBits == 15);  // of which this multiplication takes the upper bits, rounded
    return _mm256_add_epi16(a, _mm256_mulhrs_epi16(_mm256_sub_epi16(b, a), part));
}
WITH_AVX2 inline Channels mixed(const Channels& a, const Channels& b, __m256i part) {
    return {mixed(a.red_blue, b.red_blue, part), mixed(a.green, b.green, part)};
}

inline constexpr int kLightStepBits = 4;
static_assert(1 << kLightStepBits == kLightSteps);

/// lit(), or lit_above() where a table has darkened the pixels. shades: in both halves.
template <bool kIsAbove>
WITH_AVX2 inline __m256i lit_eight(__m256i pixels, __m256i texels, __m256i shades, const Channels& light) {
    const __m256i most = _mm256_set1_epi16(static_cast<short>(kBrightest));
    const Channels colors = channels_of(kIsAbove ? texels : pixels);
    const auto bright = [&](__m256i lanes) __attribute__((always_inline, target("avx2"))) {
        const __m256i more = _mm256_srli_epi16(lanes, kLightStepBits);
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

// What one file of these kernels and passes has for another one.

namespace eight_wide {

// Of the plain kernels those that go down columns of pictures.
void fill_walls(const PlainWalls& walls);
std::uint32_t read_walls(const PlainWalls& walls);
void lay_walls(const PlainWalls& walls);
void fill_sky(const Run& run, const SkyRun& sky);

// Of the passes that which lays over.
void blend(const Run& run, const std::uint32_t* colors, const std::uint32_t* texels);

// Of lamps those that light walls.
void mix_cells(const LightCell* a, const LightCell* b, LightPart part, const LightRow& to);
void light_wall(const LitRun& to, const WallLamplight& lamplight);

}  // namespace eight_wide

/// The passes of lamps.
LampPasses eight_wide_lamps();

}  // namespace enfilade::column
#endif
