#include "base/text.h"

#include <cstdio>

namespace enfilade {

namespace {

constexpr bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// Separators of lines and paragraphs, and what turns the direction of the text behind it.
constexpr bool is_layout(char32_t c) {
    return c == 0x2028 || c == 0x2029 || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

/// Length of the character at the start of the text [bytes], 0 if it must not be printed.
std::size_t printable_length(std::string_view text) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return 0;
    const char32_t character = utf8_character(text);
    return is_control(character) || is_layout(character) ? 0 : length;
}

/// `kept` : control characters that stay
std::string printable_but(std::string_view text, std::string_view kept) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const bool stays = printable_length(text) > 0 || kept.find(text[0]) != std::string_view::npos;
        const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
        shown += stays ? text.substr(0, length) : "?";
        text.remove_prefix(length);
    }
    return shown;
}

}  // namespace

std::string printable_line(std::string_view text) { return printable_but(text, ""); }

std::string printable(std::string_view text) { return printable_but(text, "\n\t"); }

bool is_printable_line(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = printable_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

void print_to_stderr(std::string_view text) {
    const std::string shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stderr);
}

void redraw_line(std::string_view text) {
    constexpr std::string_view kBackAndWipe = "\r\033[K";
    const std::string line = std::string(kBackAndWipe) + printable_line(text);
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
}

}  // namespace enfilade
