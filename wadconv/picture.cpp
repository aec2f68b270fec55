#include "wadconv/pictures.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/files.h"

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

namespace {

constexpr std::size_t kPictureHeaderBytes = 8;
constexpr std::uint8_t kEndOfColumn = 255;

Error bad_column(std::uint32_t x, const std::string& what) { return {"", "column " + std::to_string(x) + " " + what}; }

/// Posts may repeat rows, but one that paints several times its height is there to keep us busy [rows].
std::uint32_t max_painted_rows(std::uint32_t height) { return 2 * height + 255; }

/// Reads one column's posts from the reader into column x.
Result<void> read_column(ByteReader reader, std::uint32_t x, Picture& picture) {
    std::uint32_t top = 0, painted = 0;
    bool is_first = true;
    for (;;) {
        const std::uint8_t row = reader.u8();
        if (reader.failed()) return bad_column(x, "has no end");
        if (row == kEndOfColumn) return {};
        top = is_first || row > top ? row : top + row;
        is_first = false;
        const std::uint8_t length = reader.u8();
        reader.u8();  // a copy of the first texel, for a renderer that rounds
        const auto texels = reader.take(length);
        reader.u8();  // and of the last
        if (reader.failed()) return bad_column(x, "leads out of the lump");
        painted += length + 1u;
        if (painted > max_painted_rows(picture.height)) return bad_column(x, "paints more rows than the picture has");
        for (std::uint32_t i = 0; i < length && top + i < picture.height; ++i)
            picture.at(x, top + i) = std::to_integer<std::int16_t>(texels[i]);
    }
}

}  // namespace

Result<PatchHeader> read_patch_header(std::span<const std::byte> lump) {
    ByteReader reader(lump);
    PatchHeader header;
    header.width = reader.u16();
    header.height = reader.u16();
    header.left = reader.i16();
    header.top = reader.i16();
    if (reader.failed()) return Error{"", "the picture has only " + std::to_string(lump.size()) + " bytes"};
    if (header.width < 1 || header.height < 1 || header.width > kMaxPictureSide || header.height > kMaxPictureSide)
        return Error{"", "expected a picture of 1 to " + std::to_string(kMaxPictureSide) + " texels a side, found " +
                             std::to_string(header.width) + " x " + std::to_string(header.height)};
    if (reader.remaining() / 4 < header.width)
        return Error{"", "the table of " + std::to_string(header.width) + " columns does not fit the picture's " +
                             std::to_string(lump.size()) + " bytes"};
    return header;
}

Result<Picture> read_patch(std::span<const std::byte> lump) {
    const Result<PatchHeader> header = read_patch_header(lump);
    if (!header) return header.error();
    Picture picture(header.value().width, header.value().height);
    ByteReader offsets(lump.subspan(kPictureHeaderBytes));
    for (std::uint32_t x = 0; x < picture.width; ++x) {
        const std::uint32_t offset = offsets.u32();
        if (offset >= lump.size())
            return bad_column(x, "starts at byte " + std::to_string(offset) + " of " + std::to_string(lump.size()));
        if (const Result<void> done = read_column(ByteReader(lump.subspan(offset)), x, picture); !done.ok())
            return done.error();
    }
    return picture;
}

namespace {

/// A sprite lump's name is four letters, then a frame letter and a direction, then perhaps both again for the mirrored
/// view.
bool is_view(std::string_view pair) { return pair[0] >= 'A' && pair[0] <= ']' && pair[1] >= '0' && pair[1] <= '8'; }

void add_view(SpriteFrames& frames, std::string_view sprite, std::string_view pair, SpriteView view) {
    if (!is_view(pair)) return;
    frames[std::string(sprite) + pair[0]].views[static_cast<std::size_t>(pair[1] - '0')] = view;
}

/// The views of a frame that are drawn: the eight, or the one that serves all directions.
std::vector<SpriteView> views_drawn(const DoomSpriteFrame& frame) {
    if (frame.has_all_directions()) return {frame.views.begin() + 1, frame.views.end()};
    const auto first = std::ranges::find_if(frame.views, [](const SpriteView& v) { return v.lump != nullptr; });
    return first == frame.views.end() ? std::vector<SpriteView>{} : std::vector<SpriteView>{*first};
}

/// The header with the offset mirrored too, so that the thing's position stays the same point of the drawing.
Result<PatchHeader> header_of(const SpriteView& view) {
    Result<PatchHeader> header = read_patch_header(view.lump->bytes);
    if (!header) return Error{view.lump->name, header.error().what};
    PatchHeader h = header.value();
    if (view.is_mirrored) h.left = std::int32_t(h.width) - h.left;
    return h;
}

Result<Picture> picture_of(const SpriteView& view) {
    Result<Picture> picture = read_patch(view.lump->bytes);
    if (!picture) return Error{view.lump->name, picture.error().what};
    if (view.is_mirrored) return mirrored(picture.value());
    return picture;
}

/// A box around the thing's position, in texels, y down.
struct TexelBox {
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), top = left;
    std::int32_t right = std::numeric_limits<std::int32_t>::min(), bottom = right;

    void include(const PatchHeader& h) {
        left = std::min(left, -h.left);
        top = std::min(top, -h.top);
        right = std::max(right, -h.left + std::int32_t(h.width));
        bottom = std::max(bottom, -h.top + std::int32_t(h.height));
    }
};

}  // namespace

bool DoomSpriteFrame::has_all_directions() const {
    return std::all_of(views.begin() + 1, views.end(), [](const SpriteView& v) { return v.lump != nullptr; });
}

SpriteFrames sort_sprites(const WadPile& pile) {
    SpriteFrames frames;
    for (const auto& [name, lump] : pile.sprites()) {
        if (name.size() != 6 && name.size() != 8) continue;
        const std::string_view sprite = name.substr(0, 4);
        add_view(frames, sprite, name.substr(4, 2), {lump, false});
        if (name.size() == 8) add_view(frames, sprite, name.substr(6, 2), {lump, true});
    }
    return frames;
}

Result<SpriteCanvas> measure_frame(const DoomSpriteFrame& frame) {
    TexelBox box;
    const std::vector<SpriteView> views = views_drawn(frame);
    if (views.empty()) return Error{"", "the sprite has no picture"};
    for (const SpriteView& view : views) {
        const Result<PatchHeader> header = header_of(view);
        if (!header) return header.error();
        box.include(header.value());
    }
    const std::int32_t width = box.right - box.left, height = box.bottom - box.top;
    if (width > std::int32_t(kMaxPictureSide) || height > std::int32_t(kMaxPictureSide))
        return Error{views[0].lump->name, "the views lie too far apart for one picture"};
    return SpriteCanvas{std::uint32_t(width), std::uint32_t(height), -box.left, -box.top, views.size() == 8};
}

Result<Picture> draw_view(const DoomSpriteFrame& frame, const SpriteCanvas& canvas, std::size_t view) {
    const SpriteView drawn = canvas.has_rotations ? frame.views[view] : views_drawn(frame).front();
    const Result<PatchHeader> header = header_of(drawn);
    if (!header) return header.error();
    const Result<Picture> picture = picture_of(drawn);
    if (!picture) return picture.error();
    Picture on_canvas(canvas.width, canvas.height);
    const auto x0 = std::uint32_t(canvas.origin_x - header.value().left);
    const auto y0 = std::uint32_t(canvas.origin_y - header.value().top);
    for (std::uint32_t y = 0; y < picture.value().height; ++y)
        for (std::uint32_t x = 0; x < picture.value().width; ++x)
            on_canvas.at(x0 + x, y0 + y) = picture.value().at(x, y);
    return on_canvas;
}

}  // namespace enfilade::wadconv
