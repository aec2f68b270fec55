#include "app/draw/font.h"

#include <imgui.h>

#include <algorithm>

#include "base/utf8.h"

namespace enfilade {
namespace {

/// The characters whose shapes are copied: printable ASCII and the upper half of Latin-1.
constexpr bool is_printable(unsigned code) { return (code >= 0x20 && code < 0x7F) || code >= 0xA0; }

/// ProggyClean has one bit a pixel: the atlas holds 0 and 255 only.
Glyph copy_shape(const ImFontGlyph& from, const unsigned char* atlas, int atlas_width, int atlas_height) {
    Glyph glyph;
    const int left = int(from.U0 * float(atlas_width) + 0.5f), top = int(from.V0 * float(atlas_height) + 0.5f);
    const int x0 = int(from.X0), y0 = int(from.Y0), width = int(from.X1 - from.X0), height = int(from.Y1 - from.Y0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool inside = x0 + x >= 0 && x0 + x < Font::kWidth && y0 + y >= 0 && y0 + y < Font::kHeight;
            const bool ink = atlas[(top + y) * atlas_width + left + x] >= 128;
            if (inside && ink) glyph.rows[std::size_t(y0 + y)] |= std::uint8_t(1u << (x0 + x));
        }
    return glyph;
}

constexpr char32_t kReplacement = 0xFFFD;

}  // namespace

Font::Font() {
    ImFontAtlas atlas;
    const ImFont* proggy = atlas.AddFontDefault();
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
    for (unsigned code = 0; code < 256; ++code) {
        const ImFontGlyph* from = is_printable(code) ? proggy->FindGlyphNoFallback(ImWchar(code)) : nullptr;
        known_[code] = from != nullptr;
        if (from) glyphs_[code] = copy_shape(*from, pixels, width, height);
    }
}

const Glyph& Font::operator[](char32_t character) const {
    const bool known = character < 256 && known_[character];
    return glyphs_[known ? character : U'?'];
}

char32_t take_character(std::string_view& text) {
    const std::size_t length = utf8_length(text);
    const char32_t character = length == 0 ? kReplacement : utf8_character(text);
    text.remove_prefix(std::max<std::size_t>(length, 1));
    return character;
}

int length_of(std::string_view text) {
    int count = 0;
    for (; !text.empty(); ++count) take_character(text);
    return count;
}

}  // namespace enfilade
