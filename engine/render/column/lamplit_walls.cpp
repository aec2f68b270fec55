// Walls in the light of lamps, four pixels at a time, in the registers that every x86-64 has: each pixel's channels lie
// in four words of 32 bits, so that one multiplication mixes two points of the light, and one lights a colour.
#include "render/column/lamplit_walls.h"

#if defined(__x86_64__)
#include <emmintrin.h>

namespace enfilade::column {
namespace {

constexpr int kWide = 4;

/// Two neighbouring points of light, channel by channel side by side. So many are made ready for a column.
constexpr int kMostPairs = 64;
using Pairs = __m128i[kMostPairs];

void pair_up(const WallGlow& glow, Pairs& pairs) {
    for (int i = 0; i + 1 < glow.count; ++i) {
        const LightCell a = glow.cells[i], b = glow.cells[i + 1];
        const auto word = [](LightCell cell, int channel) { return static_cast<short>(lane(cell, channel)); };
        pairs[i] = _mm_setr_epi16(word(a, 0), word(b, 0), word(a, 1), word(b, 1), word(a, 2), word(b, 2), 0, 0);
    }
}

/// The light at a position among the pairs, in steps of Shade: between(), divided by kLightSteps.
[[gnu::always_inline]] inline __m128i light_at(const Pairs& pairs, std::int64_t last, std::uint64_t position) {
    const auto wanted = static_cast<std::int64_t>(position);
    const std::int64_t at = wanted < 0 ? 0 : wanted < last ? wanted : last;
    const auto part = static_cast<std::uint32_t>(at >> 24) & 0xFF;
    const __m128i weights = _mm_set1_epi32(static_cast<int>(part << 16 | (256 - part)));
    constexpr int kPartBits = 8, kStepBits = 4;
    static_assert(1 << kStepBits == kLightSteps);
    return _mm_srli_epi32(_mm_madd_epi16(pairs[at >> 32], weights), kPartBits + kStepBits);
}

/// lit(), not yet cut at 255, of one pixel.
__m128i lit_wide(std::uint32_t texel, __m128i shade, __m128i light) {
    const __m128i none = _mm_setzero_si128();
    const __m128i bytes = _mm_cvtsi32_si128(static_cast<int>(texel));
    const __m128i color = _mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, none), none);
    const __m128i bright = _mm_min_epi16(_mm_add_epi32(shade, light), _mm_set1_epi32(static_cast<int>(kBrightest)));
    return _mm_srli_epi32(_mm_madd_epi16(color, bright), 8);
}

/// misted() of two pixels of sixteen bits a channel, cut at 255 before. Without fog, clear is 256 and fog 0.
__m128i misted_two(__m128i two, __m128i clear, __m128i fog) {
    const __m128i colors = _mm_min_epi16(two, _mm_set1_epi16(255));
    return _mm_srli_epi16(_mm_add_epi16(_mm_mullo_epi16(colors, clear), fog), 8);
}

/// A column of a wall and the light down it.
struct LitColumn {
    const std::uint32_t* texels;
    std::uint32_t height;
    TileSteps v, v_per_row;
    __m128i shade;
    __m128i clear, fog;  ///< how much of a colour fog leaves [1/256], and what it adds to it
    const Pairs& pairs;
    std::int64_t last;  ///< position
    std::uint64_t position, position_per_row;

    std::uint32_t texel(int i) const {
        const TileSteps at = v + v_per_row * static_cast<TileSteps>(i);
        return texels[texel_of(static_cast<TilePlace>(at >> 32), height)];
    }
    __m128i pixel(int i, std::uint32_t texel) const {
        return lit_wide(texel, shade, light_at(pairs, last, position + position_per_row * static_cast<TileSteps>(i)));
    }
};

/// Of two pixels.
__m128i fog_share(const WallRun& wall) {
    const __m128i two = _mm_set1_epi64x(static_cast<std::int64_t>(wall.fog) << 32 | wall.fog);
    const __m128i channels = _mm_unpacklo_epi8(two, _mm_setzero_si128());
    return _mm_mullo_epi16(channels, _mm_set1_epi16(static_cast<short>(wall.mist)));
}

LitColumn column_of(const Run& run, const WallRun& wall, const WallGlow& glow, const Pairs& pairs) {
    const auto row = static_cast<TileSteps>(run.first_row);
    return {wall.texels,
            wall.height,
            wall.v_at_row_0 + wall.v_per_row * row + kHalfPlace,
            wall.v_per_row,
            _mm_set1_epi32(static_cast<int>(wall.shade)),
            _mm_set1_epi16(static_cast<short>(256 - wall.mist)),
            fog_share(wall),
            pairs,
            (std::int64_t{glow.count - 1} << 32) - 1,
            glow.at_row_0 + glow.per_row * row,
            glow.per_row};
}

/// The i-th pixel of the column and the three after it; texels: theirs.
[[gnu::always_inline]] inline __m128i four_at(const LitColumn& column, int i, const std::uint32_t* texels) {
    const __m128i ab = _mm_packs_epi32(column.pixel(i, texels[0]), column.pixel(i + 1, texels[1]));
    const __m128i cd = _mm_packs_epi32(column.pixel(i + 2, texels[2]), column.pixel(i + 3, texels[3]));
    const __m128i four =
        _mm_packus_epi16(misted_two(ab, column.clear, column.fog), misted_two(cd, column.clear, column.fog));
    return _mm_or_si128(four, _mm_set1_epi32(static_cast<int>(0xFF000000u)));
}

void fill(const Run& run, const LitColumn& column) {
    for (int i = 0; i < run.count; i += kWide) {
        if (i + kWide > run.count) i = run.count - kWide;
        const std::uint32_t texels[] = {column.texel(i), column.texel(i + 1), column.texel(i + 2), column.texel(i + 3)};
        _mm_storeu_si128(reinterpret_cast<__m128i*>(run.pixels + i), four_at(column, i, texels));
    }
}

/// What is laid over must not be drawn twice: the last few pixels are left.
void lay(const Run& run, const LitColumn& column) {
    for (int i = 0; i + kWide <= run.count; i += kWide) {
        const std::uint32_t texels[] = {column.texel(i), column.texel(i + 1), column.texel(i + 2), column.texel(i + 3)};
        if ((texels[0] | texels[1] | texels[2] | texels[3]) >> 24 == 0) continue;
        std::uint32_t colors[kWide];
        _mm_storeu_si128(reinterpret_cast<__m128i*>(colors), four_at(column, i, texels));
        for (int k = 0; k < kWide; ++k)
            if (texels[k] >> 24 != 0)
                run.pixels[i + k] = laid_over(run.pixels[i + k], (colors[k] & 0x00FFFFFFu) | (texels[k] & 0xFF000000u));
    }
}

}  // namespace

int paint_lamplit_wall(const Run& run, const WallRun& wall, const WallGlow& glow, bool is_over) {
    if (run.count < kWide || glow.count > kMostPairs) return 0;
    Pairs pairs;
    pair_up(glow, pairs);
    const LitColumn column = column_of(run, wall, glow, pairs);
    is_over ? lay(run, column) : fill(run, column);
    return is_over ? run.count / kWide * kWide : run.count;
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
int paint_lamplit_wall(const Run&, const WallRun&, const WallGlow&, bool) { return 0; }
}  // namespace enfilade::column
#endif
