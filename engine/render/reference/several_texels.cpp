// Which texels a pixel shows where it is not the one at its middle: the rules of render/sampling.h and
// render/sampling.h once more, in the plainest numbers. Only the smaller pictures themselves are shared with the column
// renderer.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/reference/cast_ray.h"
#include "render/sampling.h"

namespace enfilade {
namespace {

constexpr double kParts = kBlendParts;

/// Two texels along one side of a picture, and the second one's weight [1].
struct Neighbors {
    std::size_t first, second;
    double weight;
};

Neighbors neighbors(TilePlace place, std::uint32_t size_px) {
    const double from_middle = place * 0x1p-32 * size_px - 0.5;  // exact: no more than 48 bits [texels]
    const double rounded = std::floor(from_middle * kParts + 0.5) / kParts, whole = std::floor(rounded);
    const std::int64_t first = static_cast<std::int64_t>(whole), size = size_px;
    return {static_cast<std::size_t>((first + size) % size), static_cast<std::size_t>((first + 1) % size),
            rounded - whole};
}

/// A colour and how much it counts.
struct Weighed {
    std::uint32_t color;
    double weight;
};

template <std::size_t kCount>
std::uint32_t mean_of(const std::array<Weighed, kCount>& colors) {
    std::uint32_t mean = 0xFF000000u;
    for (const int shift : {0, 8, 16}) {
        double sum = 0;
        for (const Weighed& weighed : colors) sum += weighed.weight * (weighed.color >> shift & 0xFF);
        mean |= static_cast<std::uint32_t>(std::floor(sum + 0.5)) << shift;
    }
    return mean;
}

/// As painted, and where a color table has darkened it.
struct TwoColors {
    std::uint32_t painted, darkened;
};

/// table: of the level that darkens; null: the picture goes by none.
TwoColors bilinear(const Texture& picture, TilePlace u, TilePlace v, const std::uint32_t* table) {
    const Neighbors across = neighbors(u, picture.width), down = neighbors(v, picture.height);
    std::array<Weighed, 4> painted{}, darkened{};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool is_right = i / 2 == 1, is_lower = i % 2 == 1;
        const std::size_t x = is_right ? across.second : across.first, y = is_lower ? down.second : down.first;
        const std::size_t place = x * picture.height + y;
        const double weight =
            (is_right ? across.weight : 1 - across.weight) * (is_lower ? down.weight : 1 - down.weight);
        painted[i] = {picture.pixels[place], weight};
        darkened[i] = {table ? table[picture.numbers[place]] : 0, weight};
    }
    return {mean_of(painted), table ? mean_of(darkened) : 0};
}

/// Where texels are so far apart: x of the 2^level. >= 1.
struct Doublings {
    int level = 0;
    double x = 1;  ///< 1..2
};

Doublings doublings(double texels_per_pixel) {
    constexpr int kMost = 31;
    Doublings found{0, static_cast<float>(texels_per_pixel)};
    for (; found.x >= 2 && found.level < kMost; ++found.level) found.x /= 2;
    return found.level == kMost || !(found.x > 1) ? Doublings{found.level, 1} : found;
}

std::uint32_t mix(std::uint32_t color, std::uint32_t next, double part) {
    return mean_of(std::array{Weighed{color, 1 - part}, Weighed{next, part}});
}

}  // namespace

std::uint32_t several_texels(const ReferenceScene& scene, const Texture& picture, const TexelsSeen& seen,
                             const Lighting& lighting, double depth, LightCell lamplight) {
    const TexelSampling& sampling = *scene.sampling;
    const Doublings size = doublings(seen.texels_per_pixel);
    if (sampling.kind == Sampling::mip) {
        const int level = size.level + (size.x > std::sqrt(2.0) ? 1 : 0);
        return lit(scene, texel(sampling.mips->at(picture, level), seen.u, seen.v), lighting, depth, lamplight);
    }
    const Shade shade = shade_at(lighting, depth);
    const std::uint32_t* const table =
        picture.numbers.empty() ? nullptr : darkened_colors(scene.textures.color_table, shade);
    TwoColors colors;
    if (sampling.kind == Sampling::trilinear) {
        const double part = std::floor((size.x - 1) * kParts) / kParts;
        const TwoColors larger = bilinear(sampling.mips->at(picture, size.level), seen.u, seen.v, table);
        const TwoColors smaller = bilinear(sampling.mips->at(picture, size.level + 1), seen.u, seen.v, table);
        colors = {mix(larger.painted, smaller.painted, part), mix(larger.darkened, smaller.darkened, part)};
    } else {
        colors = bilinear(picture, seen.u, seen.v, table);
    }
    return table ? lit_above(colors.darkened, colors.painted, shade, lamplight) : lit(colors.painted, shade, lamplight);
}

}  // namespace enfilade
