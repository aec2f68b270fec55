// Four pixels at a time, in the registers that every x86-64 has. A run's last four pixels may overlap the four before
// them: a pixel is a function of its place, so that drawing it twice does no harm. Shorter runs are drawn one by one.
#include "render/column/kernels.h"

#if defined(__x86_64__)
#include <emmintrin.h>

namespace enfilade::column {
namespace {

constexpr int kWide = 4;

/// shaded() of four pixels: no channel's product leaves its 16 bits, since 255 * 256 < 2^16.
/// shades: of each pixel, in both halves of its word.
__m128i shaded_four(__m128i colors, __m128i shades) {
    const __m128i even = _mm_and_si128(colors, _mm_set1_epi32(0x00FF00FF));
    const __m128i green = _mm_and_si128(colors, _mm_set1_epi32(0x0000FF00));
    const __m128i red_blue = _mm_srli_epi16(_mm_mullo_epi16(even, shades), 8);
    const __m128i dark_green = _mm_slli_epi32(_mm_mulhi_epu16(green, shades), 8);
    return _mm_or_si128(_mm_or_si128(red_blue, dark_green), _mm_set1_epi32(static_cast<int>(0xFF000000u)));
}

__m128i four_of(const std::uint32_t* a, const std::uint32_t* b, const std::uint32_t* c, const std::uint32_t* d) {
    const auto load = [](const std::uint32_t* p) { return _mm_cvtsi32_si128(static_cast<int>(*p)); };
    return _mm_unpacklo_epi64(_mm_unpacklo_epi32(load(a), load(b)), _mm_unpacklo_epi32(load(c), load(d)));
}

void store(std::uint32_t* to, __m128i four) { _mm_storeu_si128(reinterpret_cast<__m128i*>(to), four); }

/// fill_at(i): four pixels from the i-th of `count` on. count >= 4.
template <class FillAt>
void by_four(int count, FillAt fill_at) {
    int i = 0;
    for (; i + kWide < count; i += kWide) fill_at(i);
    fill_at(count - kWide);
}

template <bool kByShifts>
void fill_wall(const WallColumn& to, RowNumber<kByShifts> row_at, const std::uint32_t* texels, Shade shade) {
    const auto at = [=](TileSteps v) { return &texels[row_at(v)]; };
    if (to.count < kWide) {
        for (int i = 0; i < to.count; ++i)
            to.pixels[i] = shaded(*at(to.v + static_cast<TileSteps>(i) * to.step), shade);
        return;
    }
    const __m128i shades = _mm_set1_epi16(static_cast<short>(shade));
    const TileSteps step = to.step;
    std::uint32_t* const pixels = to.pixels;
    TileSteps v = to.v;
    const auto four_from = [=](TileSteps from) {
        return shaded_four(four_of(at(from), at(from + step), at(from + 2 * step), at(from + 3 * step)), shades);
    };
    const int last = to.count - kWide;
    for (int i = 0; i < last; i += kWide, v += kWide * step) store(pixels + i, four_from(v));
    store(pixels + last, four_from(to.v + step * static_cast<TileSteps>(last)));
}

template <bool kByShifts>
void fill_wall_by_table(const WallColumn& to, RowNumber<kByShifts> row_at, const std::uint8_t* numbers,
                        const std::uint32_t* colors) {
    const TileSteps step = to.step;
    std::uint32_t* const pixels = to.pixels;
    TileSteps v = to.v;
    const auto color_at = [=](TileSteps from) { return colors[numbers[row_at(from)]]; };
    int i = 0;
    for (; i + kWide <= to.count; i += kWide, v += kWide * step) {
        pixels[i] = color_at(v);
        pixels[i + 1] = color_at(v + step);
        pixels[i + 2] = color_at(v + 2 * step);
        pixels[i + 3] = color_at(v + 3 * step);
    }
    for (; i < to.count; ++i, v += step) pixels[i] = color_at(v);
}

template <bool kByShifts>
void fill_walls_as(const PlainWalls& w) {
    const RowNumber<kByShifts> row_at(w.texture->height);
    for (int i = 0; i < w.runs.count; ++i) {
        if (w.runs.tops[i] >= w.runs.bottoms[i]) continue;
        if (w.color_table)
            fill_wall_by_table(column_of(w, i), row_at, &w.texture->numbers[w.first_texels[i]],
                               darkened_colors(*w.color_table, w.shades[i]));
        else
            fill_wall(column_of(w, i), row_at, &w.texture->pixels[w.first_texels[i]], w.shades[i]);
    }
}

void fill_walls(const PlainWalls& w) { goes_by_shifts(*w.texture) ? fill_walls_as<true>(w) : fill_walls_as<false>(w); }

/// Of four places the whole part of place * size / 2^32.
__m128i scaled(__m128i places, __m128i size) {
    const __m128i even = _mm_srli_epi64(_mm_mul_epu32(places, size), 32);
    const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(places, 32), size);
    return _mm_or_si128(even, _mm_and_si128(odd, _mm_set1_epi64x(static_cast<std::int64_t>(0xFFFFFFFF00000000u))));
}

/// Of four numbers below 2^16 the products with another.
__m128i times(__m128i numbers, __m128i factor) {
    return _mm_or_si128(_mm_mul_epu32(numbers, factor),
                        _mm_slli_epi64(_mm_mul_epu32(_mm_srli_epi64(numbers, 32), factor), 32));
}

/// The place on the picture's texels of four pixels, from their two coordinates' places on the tile.
template <bool kByShifts>
class TexelNumbers {
public:
    explicit TexelNumbers(const Texture& texture)
        : width_(_mm_set1_epi32(static_cast<int>(texture.width))),
          height_(_mm_set1_epi32(static_cast<int>(texture.height))),
          to_column_(_mm_cvtsi32_si128(32 - bits_below(texture.width))),
          to_row_(_mm_cvtsi32_si128(32 - bits_below(texture.height))),
          row_bits_(_mm_cvtsi32_si128(bits_below(texture.height))) {}

    __m128i operator()(__m128i u, __m128i v) const {
        if (kByShifts)
            return _mm_or_si128(_mm_sll_epi32(_mm_srl_epi32(u, to_column_), row_bits_), _mm_srl_epi32(v, to_row_));
        return _mm_add_epi32(times(scaled(u, width_), height_), scaled(v, height_));
    }

private:
    __m128i width_, height_, to_column_, to_row_, row_bits_;
};

/// Two sums of a number near a tile and kStepShift twice over: their low words are the places.
__m128i places_of(__m128d a, __m128d b) {
    return _mm_castps_si128(_mm_shuffle_ps(_mm_castpd_ps(a), _mm_castpd_ps(b), _MM_SHUFFLE(2, 0, 2, 0)));
}

/// The numbers of four texels, one by one.
struct FourNumbers {
    std::uint32_t a, b, c, d;

    explicit FourNumbers(__m128i four) {
        const auto low = static_cast<std::uint64_t>(_mm_cvtsi128_si64(four));
        const auto high = static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(four, four)));
        a = static_cast<std::uint32_t>(low);
        b = static_cast<std::uint32_t>(low >> 32);
        c = static_cast<std::uint32_t>(high);
        d = static_cast<std::uint32_t>(high >> 32);
    }
};

template <bool kByShifts, bool kByTable>
void fill_flats_as(const PlainFlats& f) {
    const TexelNumbers<kByShifts> numbers_of(*f.texture);
    const std::uint32_t* const texels = f.texture->pixels.data();
    const std::uint8_t* const numbers = f.texture->numbers.data();
    const std::uint32_t* const colors = kByTable ? f.color_table->at_level(0) : nullptr;
    const __m128d shift = _mm_set1_pd(kStepShift), base_u = _mm_set1_pd(f.base_u), base_v = _mm_set1_pd(f.base_v);
    for (int column = 0; column < f.runs.count; ++column) {
        const int top = f.runs.tops[column], count = f.runs.bottoms[column] - top;
        std::uint32_t* const pixels = f.runs.pixels + column * f.runs.pitch + top;
        if (count < kWide) {
            PlainFlats rest = f;
            rest.runs = {f.runs.pixels + column * f.runs.pitch, f.runs.pitch, 1, f.runs.tops + column,
                         f.runs.bottoms + column};
            rest.step_u += column;
            rest.step_v += column;
            rest.farthest += column;
            scalar_kernels().fill_flats(rest);
            continue;
        }
        const double* const depths = f.row_depths + top;
        const std::uint32_t* const darkness = f.row_darkness + top;
        const __m128d step_u = _mm_set1_pd(f.step_u[column]), step_v = _mm_set1_pd(f.step_v[column]);
        const __m128d farthest = _mm_set1_pd(f.farthest[column]);
        const auto sum = [shift](__m128d depth, __m128d step, __m128d base) {
            return _mm_add_pd(_mm_add_pd(base, _mm_mul_pd(depth, step)), shift);
        };
        by_four(count, [&](int i) {
            const __m128d a = _mm_min_pd(_mm_loadu_pd(depths + i), farthest);
            const __m128d b = _mm_min_pd(_mm_loadu_pd(depths + i + 2), farthest);
            const __m128i u = places_of(sum(a, step_u, base_u), sum(b, step_u, base_u));
            const __m128i v = places_of(sum(a, step_v, base_v), sum(b, step_v, base_v));
            const FourNumbers at(numbers_of(u, v));
            if (kByTable) {
                pixels[i] = colors[darkness[i] + numbers[at.a]];
                pixels[i + 1] = colors[darkness[i + 1] + numbers[at.b]];
                pixels[i + 2] = colors[darkness[i + 2] + numbers[at.c]];
                pixels[i + 3] = colors[darkness[i + 3] + numbers[at.d]];
                return;
            }
            const __m128i four = four_of(texels + at.a, texels + at.b, texels + at.c, texels + at.d);
            store(pixels + i, shaded_four(four, _mm_loadu_si128(reinterpret_cast<const __m128i*>(darkness + i))));
        });
    }
}

void fill_flats(const PlainFlats& f) {
    const bool by_shifts = is_power_of_two(f.texture->width) && is_power_of_two(f.texture->height);
    if (f.color_table)
        by_shifts ? fill_flats_as<true, true>(f) : fill_flats_as<false, true>(f);
    else
        by_shifts ? fill_flats_as<true, false>(f) : fill_flats_as<false, false>(f);
}

/// Which row of the picture four rows of the screen show: place_on_sky() and texel_of() of each.
__m128i sky_rows(const SkyRun& sky, int row) {
    const __m128d at_horizon = _mm_set1_pd(sky.v_at_horizon), per_rise = _mm_set1_pd(sky.v_per_rise);
    const auto shown = [&](const double* rises) {
        const __m128d v = _mm_add_pd(at_horizon, _mm_mul_pd(_mm_loadu_pd(rises), per_rise));
        const __m128d inside = _mm_min_pd(_mm_max_pd(v, _mm_setzero_pd()), _mm_set1_pd(sky.last));
        return _mm_add_pd(inside, _mm_set1_pd(kStepShift));
    };
    const double* const rises = sky.row_rises + row;
    return scaled(places_of(shown(rises), shown(rises + 2)), _mm_set1_epi32(static_cast<int>(sky.height)));
}

void fill_sky(const Run& run, const SkyRun& sky) {
    if (run.count < kWide) return scalar_kernels().fill_sky(run, sky);
    const __m128i opaque = _mm_set1_epi32(static_cast<int>(0xFF000000u));
    by_four(run.count, [&](int i) {
        const FourNumbers at(sky_rows(sky, run.first_row + i));
        const std::uint32_t* const t = sky.texels;
        store(run.pixels + i, _mm_or_si128(four_of(t + at.a, t + at.b, t + at.c, t + at.d), opaque));
    });
}

}  // namespace

std::optional<PlainKernels> four_wide_kernels() {
    return PlainKernels{"sse2", fill_walls, fill_flats, fill_sky, read_walls, lay_walls, read_far_flats};
}

}  // namespace enfilade::column
#else
namespace enfilade::column {
std::optional<PlainKernels> four_wide_kernels() { return {}; }
}  // namespace enfilade::column
#endif
