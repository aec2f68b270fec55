// The library behind the door, without the guard before it: no text may end the program, whatever the guard thinks of
// it, and what the guard refuses as not TOML the library must refuse as well.
#include <gtest/gtest.h>

#include <string>

#include "formats/toml_tree.h"

namespace enfilade {
namespace {

constexpr TomlLimits kUsualLimits;

/// What a text is made of: what the rules of TOML distinguish, one of each kind, and letters of one to four bytes.
constexpr std::string_view kPieces[] = {"'", "\"", "'''", "\"\"\"", "é",  "\xC3", "漢", "𝄞",
                                        "0", "1",  "-",   "e",      ".",  "0x",   "[",  "]",
                                        "{", "}",  "=",   ",",      "\n", "#",    "\\", "1979-05-27"};

/// What may stand before them: keys and headers, a value, a member of an array.
constexpr std::string_view kStarts[] = {"", "a = ", "a = ["};

/// How many parts are put together. An optimised build takes ten seconds for four of them.
#ifdef NDEBUG
constexpr std::size_t kLength = 4;
#else
constexpr std::size_t kLength = 3;
#endif

/// Whether the library reads a text.
bool library_reads(std::string_view text) {
    Findings findings;
    const bool is_read = parse_any_toml(text, findings).has_value();
    EXPECT_EQ(findings.size(), is_read ? 0u : 1u) << text;
    return is_read;
}

/// Asks guard and library about a text and about all that grow from it by so many parts.
void ask_about(std::string& text, std::size_t parts_left, std::size_t& asked) {
    ++asked;
    const bool is_read = library_reads(text);
    ASSERT_FALSE(is_read && scan_toml(text, kUsualLimits)) << text;
    const std::size_t length = text.size();
    for (std::string_view part : kPieces) {
        if (parts_left == 0) return;
        ask_about(text.append(part), parts_left - 1, asked);
        text.resize(length);
    }
}

TEST(TomlLibrary, SurvivesEveryShortText) {
    std::size_t asked = 0;
    for (std::string_view start : kStarts) {
        std::string text(start);
        ask_about(text, kLength, asked);
    }
    EXPECT_GE(asked, std::size(kStarts) * std::size(kPieces) * std::size(kPieces) * std::size(kPieces));
}

/// As UTF-8; a letter of the first plane, from U+0080 on.
std::string utf8(unsigned letter) {
    const auto continued = [letter](unsigned bits) { return static_cast<char>(0x80 | (letter >> bits & 0x3F)); };
    if (letter < 0x800) return {static_cast<char>(0xC0 | letter >> 6), continued(0)};
    return {static_cast<char>(0xE0 | letter >> 12), continued(6), continued(0)};
}

TEST(TomlLibrary, RefusesEveryBareLetterBeyondAscii) {
    for (unsigned letter = 0x80; letter <= 0xFFFF; ++letter) {
        if (letter >= 0xD800 && letter <= 0xDFFF) continue;  // surrogates are not letters
        EXPECT_FALSE(library_reads("a = 1'" + utf8(letter) + "'")) << letter;
    }
}

}  // namespace
}  // namespace enfilade
