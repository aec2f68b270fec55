// Texts: which of their bytes are characters, and how they reach stderr.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace enfilade {

// UTF-8: which bytes are characters, and which.

/// What some editors put at the start of a UTF-8 file.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Length of the character at the start of a text [bytes], 1..4, or 0 if it is not well-formed: stray or missing
/// continuation, overlong, surrogate, beyond U+10FFFF (The Unicode Standard, table 3-7). `text` is not empty.
constexpr std::size_t utf8_length(std::string_view text) {
    const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto within = [byte](std::size_t i, unsigned low, unsigned high) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return within(1, 0x80, 0xBF) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF) {
        const bool second = within(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF);
        return second && within(2, 0x80, 0xBF) ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const bool second = within(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF);
        return second && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
    }
    return 0;
}

/// The character at the start of a text, whose utf8_length() is not 0.
constexpr char32_t utf8_character(std::string_view text) {
    constexpr char32_t kOfFirst[] = {0, 0x7F, 0x1F, 0x0F, 0x07};  // by length
    const std::size_t length = utf8_length(text);
    char32_t character = static_cast<unsigned char>(text[0]) & kOfFirst[length];
    for (char c : text.substr(1, length - 1)) character = character << 6 | (static_cast<unsigned char>(c) & 0x3F);
    return character;
}

/// How many characters a well-formed text has.
constexpr std::size_t characters_in(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// What is printed. Names and texts of files may be in it, and files may be hostile: a terminal shows all of it as
// letters, and obeys none.

/// The text with a question mark for each character that a terminal would obey: control characters (C0, DEL, C1; line
/// feeds and tabs, too), separators of lines and paragraphs, overrides and isolates of direction (Boucher and Anderson,
/// "Trojan Source", 2021); and for each byte that is not UTF-8. Cost: a few ns a byte.
std::string printable_line(std::string_view text);

/// The same of several lines: line feeds and tabs stay.
std::string printable(std::string_view text);

/// Whether the text is a line that can be printed as it is.
bool is_printable_line(std::string_view text);

/// Writes printable(text), which brings its line feeds along, to stderr. What cannot be written is lost: nobody is left
/// to be told. For standard output see command/command.h.
void print_to_stderr(std::string_view text);

/// Replaces the line that the cursor of stderr is in; without a text, wipes it.
void redraw_line(std::string_view text);

}  // namespace enfilade
