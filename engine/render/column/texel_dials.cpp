#include "render/column/texel_dials.h"

#include <algorithm>
#include <limits>

#include "base/result.h"
#include "render/sampling.h"

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

namespace enfilade::column {
namespace {

template <NumberKind kNumber>
void fill_flats(const PlainFlats& f) {
    fill_flats_at(f, [&](int i, int y) {
        const double depth = std::min(f.row_depths[y], f.farthest[i]);
        return TexelPosition{flat_position<kNumber>(f.base_u, depth, f.step_u[i], f.texture->width),
                             flat_position<kNumber>(f.base_v, depth, f.step_v[i], f.texture->height)};
    });
}

}  // namespace

double least_texels_per_m(const Map& map, const TextureSet& textures) {
    double least = std::numeric_limits<double>::infinity();
    for (const Surface& surface : map.surfaces) {
        const Texture& picture = textures[surface.texture];
        least = std::min({least, picture.width / surface.tile_m.x, picture.height / surface.tile_m.y});
    }
    return least;
}

bool is_promise_too_narrow(const TexelDials& dials, const RayTables& screen) {
    constexpr double kNear = 1;  // the floor under an eye 1.7 m high is nowhere nearer, unless one looks down [m]
    const double texels_apart = kNear / screen.column_scale * dials.least_texels_per_m;  // of neighbouring columns
    return is_only_promise(dials.dials) && texels_apart > 2 * dials.dials.texel_error;
}

double in_16_16(double number) {
    constexpr double kShift = 0x1.8p36;  // whose last bit is one step
    return number + kShift - kShift;
}

double flat_position(NumberKind number, double base, double depth, double step, std::uint32_t size) {
    switch (number) {
        case NumberKind::real64: return flat_position<NumberKind::real64>(base, depth, step, size);
        case NumberKind::real32: return flat_position<NumberKind::real32>(base, depth, step, size);
        case NumberKind::fixed16: return flat_position<NumberKind::fixed16>(base, depth, step, size);
        case NumberKind::vanilla: break;
    }
    return base;
}

void fill_flats_in(NumberKind number, const PlainFlats& flats) {
    ENFILADE_CHECK(number == NumberKind::real32 || number == NumberKind::fixed16);
    number == NumberKind::real32 ? fill_flats<NumberKind::real32>(flats) : fill_flats<NumberKind::fixed16>(flats);
}

// Blended texels.

namespace {

// Red and blue in the two halves of a word of 64 bits, so that one product weighs both.

constexpr std::uint64_t red_blue_of(std::uint32_t color) {
    return (color & 0xFF) | std::uint64_t{color & 0xFF0000} << 16;
}
constexpr std::uint32_t green_of(std::uint32_t color) { return color >> 8 & 0xFF; }

/// What the weights of a sum add up to, as a shift: half of that is added before.
template <int kShift>
constexpr std::uint32_t color_of(std::uint64_t red_blue, std::uint32_t green) {
    constexpr std::uint64_t kHalf = std::uint64_t{1} << (kShift - 1);
    red_blue += kHalf | kHalf << 32;
    const auto red = static_cast<std::uint32_t>(red_blue >> kShift & 0xFF);
    const auto blue = static_cast<std::uint32_t>(red_blue >> (32 + kShift) & 0xFF);
    return 0xFF000000u | blue << 16 | ((green + static_cast<std::uint32_t>(kHalf)) >> kShift & 0xFF) << 8 | red;
}

// The four channels of a pixel at once, in the registers that every x86-64 has: what blended(), mixed() and shaded() do
// by other means. Elsewhere those are what is drawn.

#if defined(__x86_64__)

using Channels = __m128i;  ///< a word for each

__m128i pixel_in(std::uint32_t color) { return _mm_cvtsi32_si128(static_cast<int>(color)); }

/// Two weights side by side, four times.
__m128i weights(std::uint32_t of_second) {
    return _mm_set1_epi32(static_cast<int>(of_second << 16 | (kBlendParts - of_second)));
}

/// The sum of two pixels, weighed.
Channels weighed(std::uint32_t first, std::uint32_t second, __m128i by) {
    const __m128i in_turn = _mm_unpacklo_epi8(pixel_in(first), pixel_in(second));
    return _mm_madd_epi16(_mm_unpacklo_epi8(in_turn, _mm_setzero_si128()), by);
}

Channels four_blended(const FourTexels& texels, std::uint32_t across, std::uint32_t down) {
    const __m128i rows = weights(down);
    const Channels left = weighed(texels.upper_left, texels.lower_left, rows);
    const Channels right = weighed(texels.upper_right, texels.lower_right, rows);
    // Sums of rows take 16 bits, and products are of numbers with a sign: 2^15 less, and 2^15 times all weights more.
    const __m128i in_turn = _mm_xor_si128(_mm_or_si128(left, _mm_slli_epi32(right, 16)), _mm_set1_epi16(-0x8000));
    constexpr int kTakenOff = 0x8000 * static_cast<int>(kBlendParts), kHalf = 1 << (2 * kBlendBits - 1);
    const __m128i sums = _mm_add_epi32(_mm_madd_epi16(in_turn, weights(across)), _mm_set1_epi32(kTakenOff + kHalf));
    return _mm_srli_epi32(sums, 2 * kBlendBits);
}

Channels two_mixed(Channels color, Channels next, std::uint32_t part) {
    const __m128i in_turn = _mm_or_si128(color, _mm_slli_epi32(next, 16));
    const __m128i sums = _mm_add_epi32(_mm_madd_epi16(in_turn, weights(part)), _mm_set1_epi32(1 << (kBlendBits - 1)));
    return _mm_srli_epi32(sums, kBlendBits);
}

std::uint32_t pixel_of(Channels color) {
    const __m128i halves = _mm_packs_epi32(color, color);
    return static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_packus_epi16(halves, halves))) | 0xFF000000u;
}

std::uint32_t pixel_of(Channels color, Shade shade) {
    return pixel_of(_mm_srli_epi32(_mm_mullo_epi16(color, _mm_set1_epi32(static_cast<int>(shade))), 8));
}

#else

using Channels = std::uint32_t;

Channels four_blended(const FourTexels& texels, std::uint32_t across, std::uint32_t down) {
    return blended(texels, across, down);
}
Channels two_mixed(Channels color, Channels next, std::uint32_t part) { return mixed(color, next, part); }
std::uint32_t pixel_of(Channels color) { return color; }
std::uint32_t pixel_of(Channels color, Shade shade) { return shaded(color, shade); }

#endif

/// Inlined, so that what a column has in common is made ready once.
#define ENFILADE_IN_LOOP [[gnu::always_inline]] inline

/// A picture that is read in a loop, and where kByTable the colours of its color table at one level, by number. All of
/// it is copied: what a loop writes cannot change it.
template <bool kByTable>
class BlendedPicture {
public:
    BlendedPicture(const Texture& picture, const std::uint32_t* colors)
        : pixels_(picture.pixels.data()),
          numbers_(picture.numbers.data()),
          colors_(colors),
          width_(picture.width),
          height_(picture.height) {}

    TexelPair columns_around(TilePlace u) const { return texels_around(u, width_); }

    /// Between its texels.
    ENFILADE_IN_LOOP Channels at(const TexelPair& u, TilePlace v_place) const {
        const TexelPair v = texels_around(v_place, height_);
        const std::size_t left = std::size_t{u.first} * height_, right = std::size_t{u.second} * height_;
        return four_blended({color_at(left + v.first), color_at(left + v.second), color_at(right + v.first),
                             color_at(right + v.second)},
                            u.part, v.part);
    }

private:
    std::uint32_t color_at(std::size_t texel) const { return kByTable ? colors_[numbers_[texel]] : pixels_[texel]; }

    const std::uint32_t* pixels_;
    const std::uint8_t* numbers_;
    const std::uint32_t* colors_;
    std::uint32_t width_, height_;
};

template <bool kByTable>
std::uint32_t in_light(Channels color, Shade shade) {
    return kByTable ? pixel_of(color) : pixel_of(color, shade);
}

/// One column of a wall, from picture to picture `part` of the way.
template <bool kByTable>
void fill_wall(WallColumn to, TilePlace u_place, const BlendedPicture<kByTable> near,
               const BlendedPicture<kByTable> far, std::uint32_t part, Shade shade) {
    const TexelPair u = near.columns_around(u_place), u_far = far.columns_around(u_place);
    for (int row = 0; row < to.count; ++row, to.v += to.step) {
        const auto v = static_cast<TilePlace>(to.v >> 32);
        Channels color = near.at(u, v);
        if (part != 0) color = two_mixed(color, far.at(u_far, v), part);
        to.pixels[row] = in_light<kByTable>(color, shade);
    }
}

template <bool kByTable>
void fill_walls(const PlainWalls& w, const WallBlend& blend) {
    const Texture& smaller = blend.smaller ? *blend.smaller : *w.texture;
    for (int i = 0; i < w.runs.count; ++i) {
        if (w.runs.tops[i] >= w.runs.bottoms[i]) continue;
        const std::uint32_t* const colors = kByTable ? darkened_colors(*w.color_table, w.shades[i]) : nullptr;
        fill_wall<kByTable>(column_of(w, i), blend.u[i], {*w.texture, colors}, {smaller, colors},
                            blend.smaller ? blend.parts[i] : 0, w.shades[i]);
    }
}

/// position: as fill_blended_flats_at.
template <bool kByTable, class Position>
void fill_flats(const PlainFlats& f, const FlatBlend& blend, const Position& position) {
    const Texture &picture = *f.texture, &smaller = blend.smaller ? *blend.smaller : picture;
    for (int i = 0; i < f.runs.count; ++i) {
        std::uint32_t* const pixels = f.runs.pixels + i * f.runs.pitch;
        for (int y = f.runs.tops[i], end = f.runs.bottoms[i]; y < end; ++y) {
            const TexelPosition at = position(i, y);
            const TilePlace u = place_on_tile(at.u), v = place_on_tile(at.v);
            const std::uint32_t* const colors = kByTable ? f.color_table->at_level(0) + f.row_darkness[y] : nullptr;
            const BlendedPicture<kByTable> near(picture, colors), far(smaller, colors);
            const std::uint32_t part = blend.smaller ? blend.row_parts[y] : 0;
            Channels color = near.at(near.columns_around(u), v);
            if (part != 0) color = two_mixed(color, far.at(far.columns_around(u), v), part);
            pixels[y] = in_light<kByTable>(color, f.row_darkness[y] & 0xFFFF);
        }
    }
}

template <class Position>
void fill_flats_of(const PlainFlats& flats, const FlatBlend& blend, const Position& position) {
    flats.color_table ? fill_flats<true>(flats, blend, position) : fill_flats<false>(flats, blend, position);
}

template <NumberKind kNumber>
void fill_flats_in(const PlainFlats& f, const FlatBlend& blend) {
    fill_flats_of(f, blend, [&f, width = f.texture->width, height = f.texture->height](int i, int y) {
        const double depth = std::min(f.row_depths[y], f.farthest[i]);
        return TexelPosition{flat_position<kNumber>(f.base_u, depth, f.step_u[i], width),
                             flat_position<kNumber>(f.base_v, depth, f.step_v[i], height)};
    });
}

}  // namespace

std::uint32_t blended(const FourTexels& texels, std::uint32_t across, std::uint32_t down) {
    const std::uint32_t lower_right = across * down, lower_left = down * kBlendParts - lower_right,
                        upper_right = across * kBlendParts - lower_right,
                        upper_left = kBlendParts * kBlendParts - lower_left - across * kBlendParts;
    const std::uint64_t red_blue =
        red_blue_of(texels.upper_left) * upper_left + red_blue_of(texels.lower_left) * lower_left +
        red_blue_of(texels.upper_right) * upper_right + red_blue_of(texels.lower_right) * lower_right;
    const std::uint32_t green = green_of(texels.upper_left) * upper_left + green_of(texels.lower_left) * lower_left +
                                green_of(texels.upper_right) * upper_right + green_of(texels.lower_right) * lower_right;
    return color_of<2 * kBlendBits>(red_blue, green);
}

std::uint32_t mixed(std::uint32_t color, std::uint32_t next, std::uint32_t part) {
    const std::uint32_t rest = kBlendParts - part;
    return color_of<kBlendBits>(red_blue_of(color) * rest + red_blue_of(next) * part,
                                green_of(color) * rest + green_of(next) * part);
}

void fill_blended_walls(const PlainWalls& walls, const WallBlend& blend) {
    walls.color_table ? fill_walls<true>(walls, blend) : fill_walls<false>(walls, blend);
}

void fill_blended_flats(NumberKind number, const PlainFlats& flats, const FlatBlend& blend) {
    switch (number) {
        case NumberKind::real64: return fill_flats_in<NumberKind::real64>(flats, blend);
        case NumberKind::real32: return fill_flats_in<NumberKind::real32>(flats, blend);
        case NumberKind::fixed16: return fill_flats_in<NumberKind::fixed16>(flats, blend);
        case NumberKind::vanilla: break;
    }
    ENFILADE_CHECK(number != NumberKind::vanilla);
}

void fill_blended_flats_at(const PlainFlats& flats, const FlatBlend& blend,
                           const std::function<TexelPosition(int i, int y)>& position) {
    fill_flats_of(flats, blend, position);
}

}  // namespace enfilade::column
