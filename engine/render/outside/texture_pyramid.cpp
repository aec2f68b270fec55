#include "render/outside/texture_pyramid.h"

#include <algorithm>
#include <array>
#include <bit>

namespace enfilade {
namespace {

/// The mean of four pixels; colours count as much as they cover.
std::uint32_t mean(const std::array<std::uint32_t, 4>& pixels) {
    std::uint32_t alpha = 0, red = 0, green = 0, blue = 0;
    for (const std::uint32_t pixel : pixels) {
        const std::uint32_t weight = pixel >> 24;
        alpha += weight;
        red += (pixel & 0xFF) * weight;
        green += (pixel >> 8 & 0xFF) * weight;
        blue += (pixel >> 16 & 0xFF) * weight;
    }
    if (alpha == 0) return 0;
    return (alpha + 2) / 4 << 24 | blue / alpha << 16 | green / alpha << 8 | red / alpha;
}

}  // namespace

TexturePyramid::TexturePyramid(const Texture& texture) {
    levels_.push_back({texture.width, texture.height, texture.pixels});
    while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(halved(levels_.back()));
}

TexturePyramid::Level TexturePyramid::halved(const Level& from) {
    Level to{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
    const auto pixel = [&](std::uint32_t x, std::uint32_t y) {
        return from.pixels[std::size_t{std::min(x, from.width - 1)} * from.height + std::min(y, from.height - 1)];
    };
    for (std::uint32_t x = 0; x < to.width; ++x)
        for (std::uint32_t y = 0; y < to.height; ++y)
            to.pixels.push_back(mean(
                {pixel(2 * x, 2 * y), pixel(2 * x + 1, 2 * y), pixel(2 * x, 2 * y + 1), pixel(2 * x + 1, 2 * y + 1)}));
    return to;
}

std::uint32_t TexturePyramid::at(TilePlace u, TilePlace v, double texels_per_px) const {
    const auto whole = static_cast<std::uint32_t>(std::clamp(texels_per_px / 2, 0.0, 65536.0));
    const Level& level =
        levels_[std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(whole)), levels_.size() - 1)];
    return level.pixels[std::size_t{texel_of(u, level.width)} * level.height + texel_of(v, level.height)];
}

}  // namespace enfilade
