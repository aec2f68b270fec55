#include "wadconv/picture.h"

#include <algorithm>

#include "base/bytes.h"

namespace enfilade::wadconv {
namespace {

/// 0 in the alpha byte: a hole. The other bytes are black so that a solid wall shows black there, as Doom does at best.
constexpr std::uint32_t kHoleColor = 0;

constexpr std::size_t kLevels = 32;
constexpr std::size_t kColors = 256;

unsigned brightness(std::uint32_t color) { return (color & 255) + (color >> 8 & 255) + (color >> 16 & 255); }

/// Which of palette's entries (kHole + 1 .. 256, shifted by one) a picture uses.
std::vector<std::int16_t> colors_used(const Picture& picture) {
    std::array<bool, kColors + 1> used{};
    for (std::int16_t texel : picture.texels) used[static_cast<std::size_t>(texel + 1)] = true;
    std::vector<std::int16_t> colors;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) colors.push_back(static_cast<std::int16_t>(int(i) - 1));
    return colors;
}

std::uint32_t color_of(std::int16_t texel, const Palette& palette) {
    return texel == kHole ? kHoleColor : palette[static_cast<std::size_t>(texel)];
}

/// For the rare picture with all 256 colours and holes.
Bytes to_rgba_png(const Picture& picture, const Palette& palette) {
    Image image{picture.width, picture.height, {}};
    image.pixels.reserve(picture.texels.size());
    for (std::int16_t texel : picture.texels) image.pixels.push_back(color_of(texel, palette));
    return write_png(image);
}

Error too_short(std::span<const std::byte> colormap) {
    return {"", "COLORMAP has " + std::to_string(colormap.size()) + " bytes; 32 levels of light take 8192"};
}

}  // namespace

Result<Palette> read_palette(std::span<const std::byte> playpal) {
    ByteReader reader(playpal);
    Palette palette;
    for (std::uint32_t& color : palette) {
        const std::uint32_t red = reader.u8(), green = reader.u8(), blue = reader.u8();
        color = 0xFF000000u | blue << 16 | green << 8 | red;
    }
    if (reader.failed())
        return Error{"", "PLAYPAL has " + std::to_string(playpal.size()) + " bytes; a palette takes 768"};
    return palette;
}

Result<std::array<double, 32>> measure_colormap(std::span<const std::byte> colormap, const Palette& palette) {
    if (colormap.size() < kLevels * kColors) return too_short(colormap);
    unsigned full = 0;
    for (std::uint32_t color : palette) full += brightness(color);
    std::array<double, kLevels> levels{};
    for (std::size_t level = 0; level < kLevels; ++level) {
        unsigned sum = 0;
        for (std::size_t i = 0; i < kColors; ++i)
            sum += brightness(palette[std::to_integer<std::size_t>(colormap[level * kColors + i])]);
        levels[level] = full == 0 ? 0 : double(sum) / full;
    }
    return levels;
}

Result<Picture> color_table_picture(std::span<const std::byte> colormap) {
    if (colormap.size() < kLevels * kColors) return too_short(colormap);
    Picture picture(kColors, kLevels + 1);
    for (std::uint32_t x = 0; x < kColors; ++x) {
        picture.at(x, 0) = static_cast<std::int16_t>(x);
        for (std::uint32_t level = 0; level < kLevels; ++level)
            picture.at(x, level + 1) = std::to_integer<std::int16_t>(colormap[level * kColors + x]);
    }
    return picture;
}

Picture mirrored(const Picture& picture) {
    Picture mirror = picture;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        const auto row = mirror.texels.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * picture.width);
        std::reverse(row, row + picture.width);
    }
    return mirror;
}

Bytes to_png(const Picture& picture, const Palette& palette) {
    const std::vector<std::int16_t> colors = colors_used(picture);
    if (colors.size() > kColors) return to_rgba_png(picture, palette);
    std::array<std::uint8_t, kColors + 1> entry_of{};
    IndexedImage image{picture.width, picture.height, {}, {}};
    for (std::int16_t color : colors) {
        entry_of[static_cast<std::size_t>(color + 1)] = static_cast<std::uint8_t>(image.palette.size());
        image.palette.push_back(color_of(color, palette));
    }
    image.pixels.reserve(picture.texels.size());
    for (std::int16_t texel : picture.texels) image.pixels.push_back(entry_of[static_cast<std::size_t>(texel + 1)]);
    return write_indexed_png(image);
}

}  // namespace enfilade::wadconv
