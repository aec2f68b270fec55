#include "app/draw/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

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

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
    std::vector<std::string> lines;
    for (std::string indent; !text.empty(); indent = "  ") {
        const std::size_t room = most - indent.size();
        const std::size_t space = text.size() > room ? text.rfind(' ', room) : std::string_view::npos;
        const bool between_words = space != std::string_view::npos && space > 0;
        const std::size_t cut = std::min(between_words ? space : room, text.size());
        lines.push_back(indent + std::string(text.substr(0, cut)));
        text.remove_prefix(between_words ? cut + 1 : cut);
    }
    return lines;
}

namespace {

/// One channel of `over` with alpha in 0..255 over `under`, rounded.
std::uint32_t mix(std::uint32_t under, std::uint32_t over, std::uint32_t alpha, int shift) {
    const std::uint32_t a = under >> shift & 255, b = over >> shift & 255;
    return ((a * (255 - alpha) + b * alpha + 127) / 255) << shift;
}

std::uint32_t blend(std::uint32_t under, Color color) {
    const std::uint32_t alpha = color >> 24;
    if (alpha == 255) return color;
    return mix(under, 0xFF000000u, alpha, 24) | mix(under, color, alpha, 0) | mix(under, color, alpha, 8) |
           mix(under, color, alpha, 16);
}

/// Cuts the part of the segment outside [low, high] in one coordinate (Liang, Barsky: "A New Concept and Method for
/// Line Clipping", 1984). False where nothing is left.
bool clip(double from, double way, double low, double high, double& begin, double& end) {
    if (way == 0) return from >= low && from <= high;
    const double a = (low - from) / way, b = (high - from) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    return begin <= end;
}

}  // namespace

void Overlay::dot(int x, int y, Color color) {
    if (x < 0 || y < 0 || x >= frame_.width || y >= frame_.height) return;
    std::uint32_t& pixel = frame_.pixels[std::size_t(y) * std::size_t(frame_.width) + std::size_t(x)];
    pixel = blend(pixel, color);
}

void Overlay::fill(const Rect& box, Color color) {
    const int left = std::max(box.left, 0), right = std::min(box.left + box.width, frame_.width);
    const int top = std::max(box.top, 0), bottom = std::min(box.top + box.height, frame_.height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) dot(x, y, color);
}

void Overlay::outline(const Rect& box, Color color) {
    fill({box.left, box.top, box.width, scale_}, color);
    fill({box.left, box.top + box.height - scale_, box.width, scale_}, color);
    fill({box.left, box.top + scale_, scale_, box.height - 2 * scale_}, color);
    fill({box.left + box.width - scale_, box.top + scale_, scale_, box.height - 2 * scale_}, color);
}

void Overlay::line(Vec2 a, Vec2 b, Color color) {
    const Vec2 way = b - a;
    double begin = 0, end = 1;
    const double rim = scale_;
    if (!clip(a.x, way.x, -rim, frame_.width + rim, begin, end)) return;
    if (!clip(a.y, way.y, -rim, frame_.height + rim, begin, end)) return;
    const Vec2 first = a + way * begin, last = a + way * end;
    const double longest = std::max(std::abs(last.x - first.x), std::abs(last.y - first.y));
    const int steps = std::max(1, int(std::ceil(longest / scale_)));
    for (int i = 0; i <= steps; ++i) {
        const Vec2 p = first + (last - first) * (double(i) / steps);
        fill({int(std::floor(p.x)) - scale_ / 2, int(std::floor(p.y)) - scale_ / 2, scale_, scale_}, color);
    }
}

void Overlay::text(int x, int y, std::string_view text, Color color) {
    while (!text.empty()) {
        glyph(x, y, font_[take_character(text)], color);
        x += Font::kWidth * scale_;
    }
}

void Overlay::rimmed_text(int x, int y, std::string_view words, Color color) {
    constexpr Color kRim = 0xFF000000;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {1, 1}})
        text(x + dx * scale_, y + dy * scale_, words, kRim);
    text(x, y, words, color);
}

void Overlay::glyph(int x, int y, const Glyph& glyph, Color color) {
    for (int row = 0; row < Font::kHeight; ++row)
        for (int column = 0; column < Font::kWidth; ++column)
            if (glyph.rows[std::size_t(row)] >> column & 1)
                fill({x + column * scale_, y + row * scale_, scale_, scale_}, color);
}

int comfortable_scale(int height_px) { return 1 + height_px / 720; }

}  // namespace enfilade
