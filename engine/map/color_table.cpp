#include "map/textures.h"

#include <algorithm>
#include <optional>
#include <string>

namespace enfilade {
namespace {

constexpr std::uint32_t kAlpha = 0xFF000000u;

/// The square of how far two colours are apart.
int distance(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (const int shift : {0, 8, 16}) {
        const int apart = static_cast<int>(a >> shift & 0xFF) - static_cast<int>(b >> shift & 0xFF);
        sum += apart * apart;
    }
    return sum;
}

}  // namespace

Result<ColorTable> ColorTable::read(const Texture& picture) {
    if (picture.width > kMostColors || picture.height != kLevels + 1 || picture.has_holes)
        return Error{"",
                     "expected up to 256 columns, one for each colour, of 33 opaque pixels: the colour as painted, and "
                     "below it what it becomes at 32 levels of light, the brightest first; found " +
                         std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                         (picture.has_holes ? " with holes" : "")};
    ColorTable table;
    table.levels_.resize(kLevels * kMostColors, kAlpha);
    for (std::uint32_t x = 0; x < picture.width; ++x) {
        table.painted_.push_back({picture.at(x, 0), static_cast<std::uint8_t>(x)});
        for (std::uint32_t level = 0; level < kLevels; ++level)
            table.levels_[level * kMostColors + x] = picture.at(x, level + 1);
    }
    std::ranges::stable_sort(table.painted_, {}, &Painted::color);
    return table;
}

std::vector<std::uint8_t> ColorTable::numbers_in(const Texture& picture) const {
    std::vector<std::uint8_t> numbers(picture.pixels.size());
    std::optional<Painted> last;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (picture.pixels[i] >> 24 == 0) continue;
        const std::uint32_t color = picture.pixels[i] | kAlpha;
        if (!last || last->color != color) {
            const auto found = std::ranges::lower_bound(painted_, color, {}, &Painted::color);
            if (found == painted_.end() || found->color != color) return {};
            last = *found;
        }
        numbers[i] = last->number;
    }
    return numbers;
}

void ColorTable::paint_in_its_colors(Texture& picture) const {
    picture.numbers.clear();
    for (std::uint32_t& pixel : picture.pixels) {
        const auto nearest =
            std::ranges::min_element(painted_, {}, [&](const Painted& p) { return distance(p.color, pixel); });
        pixel = nearest->color;
        picture.numbers.push_back(nearest->number);
    }
}

}  // namespace enfilade
