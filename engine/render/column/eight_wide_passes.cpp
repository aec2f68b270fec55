// Fog, and laying over, for processors with AVX2.
#include "render/column/eight_wide.h"

#if defined(__x86_64__)

namespace enfilade::column {
namespace {

constexpr int kWide = kEightWide;

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

/// Most of what has holes is either there or not; what is in between is mixed one by one.
WITH_AVX2 void blend(const Run& run, const std::uint32_t* above) {
    int i = 0;
    for (; i + kWide <= run.count; i += kWide) {
        const __m256i colors = load(above + i), alphas = _mm256_srli_epi32(colors, 24);
        const __m256i is_none = _mm256_cmpeq_epi32(alphas, _mm256_setzero_si256());
        const __m256i is_full = _mm256_cmpeq_epi32(alphas, _mm256_set1_epi32(255));
        if (_mm256_movemask_epi8(_mm256_or_si256(is_none, is_full)) == -1)
            _mm256_maskstore_epi32(reinterpret_cast<int*>(run.pixels + i), is_full, colors);
        else
            scalar_passes().blend({run.pixels + i, run.first_row + i, kWide}, above + i);
    }
    scalar_passes().blend({run.pixels + i, run.first_row + i, run.count - i}, above + i);
}

}  // namespace

std::optional<Passes> eight_wide_passes() {
    if (!has_avx2()) return {};
    return Passes{eight_wide_lamps(), add_fog, blend};
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
std::optional<Passes> eight_wide_passes() { return {}; }
}  // namespace enfilade::column
#endif
