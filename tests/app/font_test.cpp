// The pixel font, and characters out of UTF-8.
#include "app/draw/overlay.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace enfilade {
namespace {

std::string picture(const Glyph& glyph) {
    std::string text;
    for (const auto row : glyph.rows) {
        for (int x = 0; x < Font::kWidth; ++x) text += row >> x & 1 ? '#' : '.';
        text += '\n';
    }
    return text;
}

std::vector<char32_t> characters(std::string_view text) {
    std::vector<char32_t> all;
    while (!text.empty()) all.push_back(take_character(text));
    return all;
}

TEST(Font, DrawsAnA) {
    EXPECT_EQ(
        picture(Font()[U'A']),
        ".......\n.......\n.......\n...##..\n...##..\n..#..#.\n..#..#.\n..####.\n.#....#\n.#....#\n.#....#\n.......\n"
        ".......\n");
}

TEST(Font, LeavesASpaceEmpty) { EXPECT_EQ(picture(Font()[U' ']).find('#'), std::string::npos); }

TEST(Font, ShowsAQuestionMarkForWhatItLacks) { EXPECT_EQ(picture(Font()[U'\u4E16']), picture(Font()[U'?'])); }

TEST(Font, ShowsAQuestionMarkForControlCharacters) {
    const Font font;
    const auto expect_question_mark = [&](char32_t control) {
        EXPECT_EQ(font[control].rows, font[U'?'].rows) << int(control);
    };
    for (char32_t control = 0; control < 0x20; ++control) expect_question_mark(control);
    for (char32_t control = 0x7F; control < 0xA0; ++control) expect_question_mark(control);
}

TEST(TakeCharacter, ReadsOneToFourBytes) {
    EXPECT_EQ(characters("a\xC3\xA4\xE2\x82\xAC\xF0\x9F\x99\x82"), (std::vector<char32_t>{'a', 0xE4, 0x20AC, 0x1F642}));
}

TEST(TakeCharacter, ReplacesBrokenBytesOneAtATime) {
    EXPECT_EQ(characters("\xC3"
                         "a\xFF"),
              (std::vector<char32_t>{0xFFFD, 'a', 0xFFFD}));
}

TEST(TakeCharacter, SurvivesTextCutInTheMiddle) { EXPECT_EQ(characters("\xE2\x82").size(), 2u); }

TEST(LengthOf, CountsCharactersNotBytes) { EXPECT_EQ(length_of("\xC3\xA4z"), 2); }

}  // namespace
}  // namespace enfilade
