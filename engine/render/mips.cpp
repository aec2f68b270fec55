#include "render/mips.h"

#include <algorithm>
#include <bit>

#include "render/supersample.h"

namespace enfilade {
namespace {

/// The mean of the texels that one of the smaller picture covers: two by two, where a side is odd up to three.
std::uint32_t mean_below(const Texture& from, std::uint32_t x, std::uint32_t y, const Texture& to) {
    LightMean mean;
    std::uint32_t count = 0;
    for (std::uint32_t i = x * from.width / to.width; i < (x + 1) * from.width / to.width; ++i)
        for (std::uint32_t j = y * from.height / to.height; j < (y + 1) * from.height / to.height; ++j, ++count)
            mean.add(from.at(i, j));
    return mean.color(count);
}

Texture half_of(const Texture& from) {
    Texture to;
    to.width = std::max(1u, from.width / 2);
    to.height = std::max(1u, from.height / 2);
    to.pixels.reserve(std::size_t{to.width} * to.height);
    for (std::uint32_t x = 0; x < to.width; ++x)
        for (std::uint32_t y = 0; y < to.height; ++y) to.pixels.push_back(mean_below(from, x, y, to));
    return to;
}

std::vector<Texture> smaller_than(const Texture& picture, const ColorTable& table) {
    std::vector<Texture> smaller;
    const Texture* last = &picture;
    while (last->width > 1 || last->height > 1) {
        smaller.push_back(half_of(*last));
        last = &smaller.back();
    }
    if (!picture.numbers.empty())
        for (Texture& texture : smaller) table.paint_in_its_colors(texture);
    return smaller;
}

}  // namespace

MipChains::MipChains(const TextureSet& textures) : textures_(textures) {
    for (const Texture& picture : textures.textures)
        smaller_.push_back(picture.has_holes ? std::vector<Texture>() : smaller_than(picture, textures.color_table));
}

const Texture& MipChains::at(const Texture& picture, int level) const {
    if (level == 0 || &picture == &textures_.placeholder) return picture;
    const auto& smaller = smaller_[static_cast<std::size_t>(&picture - textures_.textures.data())];
    if (smaller.empty()) return picture;
    return smaller[std::min(static_cast<std::size_t>(level), smaller.size()) - 1];
}

MipPlace mip_place(double texels_per_pixel) {
    constexpr int kMantissaBits = 23, kBias = 127, kMostLevel = 31;
    const auto number = static_cast<float>(texels_per_pixel);
    if (!(number > 1)) return {};
    const auto bits = std::bit_cast<std::uint32_t>(number);
    const int level = static_cast<int>(bits >> kMantissaBits) - kBias;
    if (level >= kMostLevel) return {kMostLevel, 0};
    return {level, bits >> (kMantissaBits - kBlendBits) & (kBlendParts - 1)};
}

int mip_level(double texels_per_pixel) {
    constexpr double kSquareRootOf2 = 1.4142135623730951;
    int level = 0;
    for (double limit = kSquareRootOf2; texels_per_pixel > limit && level < 31; limit *= 2) ++level;
    return level;
}

}  // namespace enfilade
