// Lines, boxes and text over a finished frame: what the player sees on top of the world, with every renderer.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "render/frame.h"

namespace enfilade {

// A small pixel font: ProggyClean by Tristan Grimmer, as Dear ImGui carries it.

/// A character's shape: bit x of rows[y] is set where pixel (x, y) is ink.
struct Glyph {
    std::array<std::uint8_t, 13> rows{};
};

/// All printable characters of Latin-1, each kWidth x kHeight pixels, lines kHeight apart.
class Font {
public:
    static constexpr int kWidth = 7, kHeight = 13;  ///< [px]

    /// Cost: about a millisecond.
    Font();

    /// The character, or a question mark for what the font does not have.
    const Glyph& operator[](char32_t character) const;

private:
    std::array<Glyph, 256> glyphs_{};
    std::array<bool, 256> known_{};
};

/// Takes the next character off UTF-8 text that is not empty. Broken bytes give U+FFFD, one at a time.
char32_t take_character(std::string_view& text);

/// How many characters the text has.
int length_of(std::string_view text);

// Text that is too long for its line.

/// The text cut into lines of at most so many bytes, between words where there are any. most > 2: later lines are
/// indented by two.
std::vector<std::string> wrapped(std::string_view text, std::size_t most);

/// 0xAABBGGRR; alpha 255 covers, 0 leaves what is there.
using Color = std::uint32_t;

/// Of texts on pages that cover the picture: menu, list of maps, end of a map.
inline constexpr Color kTitleInk = 0xFFFFFFFF, kInk = 0xFFC8C8C8, kChosenInk = 0xFFFFFFFF, kValueInk = 0xFFA8D8E8,
                       kHintInk = 0xFFA8A8A8;
/// What such a page is laid on, so that the picture behind it still shows.
inline constexpr Color kPageShade = 0xD0000000;

/// A rectangle of pixels [left, left + width) x [top, top + height).
struct Rect {
    int left = 0, top = 0, width = 0, height = 0;
    bool contains(double x, double y) const { return x >= left && x < left + width && y >= top && y < top + height; }
};

/// Draws into a frame: over a picture, or into one that is all 0, which becomes what has to be laid over a picture, its
/// colours multiplied by their alpha. Whatever lies outside is left out; any coordinates are safe.
class Overlay {
public:
    /// Both must outlive the overlay. scale >= 1: how many pixels wide and high a pixel of the font and of a line is.
    Overlay(Frame& frame, const Font& font, int scale = 1) : frame_(frame), font_(font), scale_(scale) {}

    int width() const { return frame_.width; }
    int height() const { return frame_.height; }
    int scale() const { return scale_; }
    /// The same picture, to draw in so many times as large.
    Overlay scaled(int times) const { return Overlay(frame_, font_, scale_ * times); }
    int line_height() const { return Font::kHeight * scale_; }
    int text_width(std::string_view text) const { return length_of(text) * Font::kWidth * scale_; }

    void dot(int x, int y, Color color);
    void fill(const Rect& box, Color color);
    void outline(const Rect& box, Color color);
    /// From the pixel that holds a to the pixel that holds b; without gaps, scale() thick.
    void line(Vec2 a, Vec2 b, Color color);
    /// One line of text, its top left corner at (x, y).
    void text(int x, int y, std::string_view text, Color color);
    /// The same with a dark rim, readable on anything.
    void rimmed_text(int x, int y, std::string_view text, Color color);

private:
    void glyph(int x, int y, const Glyph& glyph, Color color);

    Frame& frame_;
    const Font& font_;
    int scale_;
};

/// The scale at which text is comfortable to read in a picture of this height: whole steps, 1 below 720 rows.
int comfortable_scale(int height_px);

}  // namespace enfilade
