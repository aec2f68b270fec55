// What may reach a terminal.
#include "base/text.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Printable, LeavesLettersAsTheyAre) {
    for (const char* text : {"", "a b-~", "é", "\u00A0", "漢字", "𝄞", "\u2027\u202F\u2065\u206A", "שלום"}) {
        EXPECT_EQ(printable(text), text);
        EXPECT_EQ(printable_line(text), text);
        EXPECT_TRUE(is_printable_line(text)) << text;
    }
}

TEST(Printable, ReplacesEachControlCharacter) {
    for (int c = 0; c < 0x20; ++c) {
        const std::string text{'a', static_cast<char>(c), 'b'};
        EXPECT_EQ(printable_line(text), "a?b") << c;
        EXPECT_EQ(printable(text), c == '\n' || c == '\t' ? text : "a?b") << c;
        EXPECT_FALSE(is_printable_line(text)) << c;
    }
    EXPECT_EQ(printable("a\x7F"), "a?");
    for (int c = 0x80; c < 0xA0; ++c) EXPECT_EQ(printable(std::string{'\xC2', static_cast<char>(c), 'b'}), "?b") << c;
}

TEST(Printable, ReplacesWhatTurnsOrEndsALine) {
    for (const char* text : {"\u2028", "\u2029", "\u202A", "\u202B", "\u202C", "\u202D", "\u202E", "\u2066", "\u2067",
                             "\u2068", "\u2069"}) {
        EXPECT_EQ(printable("a" + std::string(text) + "b"), "a?b");
        EXPECT_FALSE(is_printable_line(text)) << text;
    }
}

TEST(Printable, ReplacesBytesThatAreNotUtf8OneAtATime) {
    EXPECT_EQ(printable("a\xFF\xC3\xE6\xBC"), "a?\?\?\?");
    EXPECT_EQ(printable("\xC0\x9B"), "??");       // ESC [ in too many bytes
    EXPECT_EQ(printable("\xED\xA0\x80"), "???");  // a surrogate
    EXPECT_EQ(printable("\x9B[2J"), "?[2J");      // C1 in one byte, as some terminals take it
}

TEST(Utf8Character, ReadsOneToFourBytes) {
    EXPECT_EQ(utf8_character("a"), U'a');
    EXPECT_EQ(utf8_character("\xC2\x80"), char32_t{0x80});
    EXPECT_EQ(utf8_character("ÿz"), U'ÿ');
    EXPECT_EQ(utf8_character("\uFFFD"), U'\uFFFD');
    EXPECT_EQ(utf8_character("𝄞"), U'𝄞');
    EXPECT_EQ(utf8_character("\U0010FFFF"), U'\U0010FFFF');
}

}  // namespace
}  // namespace enfilade
