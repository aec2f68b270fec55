#include "render/sampling.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/result.h"

namespace enfilade {
namespace {

/// Full light in steps: near black, where they are widest apart, two neighbouring values of a channel differ by 20.
constexpr std::uint32_t kFullLight = 65535;

/// Newton's method, by products and quotients alone: libm's powers differ from machine to machine. 0 < x <= 1.
constexpr double fifth_root(double x) {
    constexpr int kEnough = 60;  // from 1 down to the root of the darkest value, with room to spare
    double root = 1;
    for (int i = 0; i < kEnough; ++i) root = (4 * root + x / (root * root * root * root)) / 5;
    return root;
}

/// x^2.4. 0 < x <= 1.
constexpr double to_the_twelve_fifths(double x) { return x * x * fifth_root(x) * fifth_root(x); }

constexpr std::uint32_t linear_light(int value) {
    const double c = value / 255.0;
    const double light = c <= 0.04045 ? c / 12.92 : to_the_twelve_fifths((c + 0.055) / 1.055);
    return static_cast<std::uint32_t>(light * kFullLight + 0.5);
}

/// By the value of a channel.
constexpr auto kLight = [] {
    std::array<std::uint32_t, 256> light{};
    for (int value = 0; value < 256; ++value) light[static_cast<std::size_t>(value)] = linear_light(value);
    return light;
}();

/// Which value to begin with, by sixteen steps of light at a time: nowhere brighter than the nearest one,
/// and hardly ever darker by more than one, because values are at least 20 steps apart.
constexpr std::uint32_t kStepsAtATime = 16;
constexpr auto kFirstValue = [] {
    std::array<std::uint8_t, (kFullLight + 1) / kStepsAtATime> first{};
    std::size_t value = 0;
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        while (value < 255 && kLight[value] + kLight[value + 1] < 2 * kStepsAtATime * i) ++value;
        first[i] = static_cast<std::uint8_t>(value);
    }
    return first;
}();

/// The value whose light is nearest to sum / count, the darker one of two.
std::uint32_t value_of(std::uint32_t sum, std::uint32_t count) {
    std::size_t value = kFirstValue[sum / count / kStepsAtATime];
    while (value < 255 && (kLight[value] + kLight[value + 1]) * count < 2 * sum) ++value;
    return static_cast<std::uint32_t>(value);
}

}  // namespace

void LightMean::add(std::uint32_t color) {
    red_ += kLight[color & 0xFF];
    green_ += kLight[color >> 8 & 0xFF];
    blue_ += kLight[color >> 16 & 0xFF];
}

std::uint32_t LightMean::color(std::uint32_t count) const {
    return 0xFF000000u | value_of(blue_, count) << 16 | value_of(green_, count) << 8 | value_of(red_, count);
}

View finer(View view, int samples) {
    view.ray_offset = view.ray_offset * samples;
    return view;
}

void take_means(const Frame& fine, int samples, Frame& frame) {
    ENFILADE_CHECK(fine.width == frame.width * samples && fine.height == frame.height * samples);
    const auto width = static_cast<std::size_t>(fine.width), side = static_cast<std::size_t>(samples);
    std::uint32_t* pixel = frame.pixels.data();
    for (std::size_t top = 0; top < static_cast<std::size_t>(fine.height); top += side)
        for (std::size_t left = 0; left < width; left += side) {
            LightMean mean;
            for (std::size_t y = top; y < top + side; ++y)
                for (std::size_t x = left; x < left + side; ++x) mean.add(fine.pixels[y * width + x]);
            *pixel++ = mean.color(static_cast<std::uint32_t>(side * side));
        }
}

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
