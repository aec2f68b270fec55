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

/// The passes of lamps.
LampPasses eight_wide_lamps();

}  // namespace enfilade::column
#endif
