// A small pixel font: ProggyClean by Tristan Grimmer, as Dear ImGui carries it.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace enfilade {

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

}  // namespace enfilade
