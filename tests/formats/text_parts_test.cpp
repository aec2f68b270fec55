// The small parts that all readers and writers share: numbers, characters, lines, words in messages.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "base/hash.h"
#include "base/text.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

TEST(NumberText, ReadsBackToTheLastBit) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const double number = std::bit_cast<double>(random.bits());
        if (!std::isfinite(number)) continue;
        const auto back = parse_number(number_text(number));
        ASSERT_TRUE(back.has_value()) << number_text(number);
        EXPECT_EQ(*back, number) << number_text(number);
    }
}

TEST(NumberText, IsShortAndPlain) {
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(-3), "-3");
    EXPECT_EQ(number_text(100000), "100000");
    EXPECT_EQ(number_text(0x1p-10), "0.0009765625");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(5e-324), "5e-324");
}

TEST(NumberText, HasNoNegativeZero) { EXPECT_EQ(number_text(-0.0), "0"); }

TEST(ParseNumber, TakesWholeNumbersOnly) {
    for (const char* text : {"", " 1", "1 ", "1x", "nan", "-inf", "0x10", "1e999", "--1", "+-1", "+", "."})
        EXPECT_FALSE(parse_number(text).has_value()) << text;
}

TEST(ParseNumber, TakesASign) { EXPECT_EQ(parse_number("+1.5"), 1.5); }

TEST(Utf8, KnowsTheEdgesOfWellFormedCharacters) {
    EXPECT_EQ(utf8_length("\x7F"), 1u);
    EXPECT_EQ(utf8_length("\xC2\x80"), 2u);
    EXPECT_EQ(utf8_length("\xED\x9F\xBF"), 3u);
    EXPECT_EQ(utf8_length("\xEF\xBF\xBF"), 3u);
    EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4u);
}

TEST(Utf8, RefusesWhatOnlyLooksLikeIt) {
    for (const char* text : {"\x80", "\xC1\xBF", "\xC2", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                             "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xC3(", "\xE6\xBC("})
        EXPECT_EQ(utf8_length(text), 0u);
}

TEST(LineReader, TakesBothEndsOfLines) {
    LineReader lines("a\r\n\nb");
    EXPECT_EQ(lines.next()->text, "a");
    EXPECT_EQ(lines.next()->text, "");
    const auto last = lines.next();
    EXPECT_EQ(last->text, "b");
    EXPECT_EQ(last->number, 3u);
    EXPECT_FALSE(lines.next().has_value());
}

TEST(Quoted, CutsBetweenCharacters) {
    std::string text(59, 'a');
    EXPECT_EQ(in_quotes(text + "é"), "'" + text + "…'");
}

TEST(Quoted, ShowsNothingThatATerminalObeys) {
    EXPECT_EQ(in_quotes("a\x1B\n\x7F"), "'a?\?\?'");
    EXPECT_EQ(in_quotes("\u009B\u202E\u2067\u2028\xFF"), "'\?\?\?\?\?'");
}

constexpr std::array<std::string_view, 4> kKnown{"texture", "next", "x", "y"};

TEST(Counted, TakesAnSUnlessItIsOne) {
    EXPECT_EQ(counted(0, "wall"), "0 walls");
    EXPECT_EQ(counted(1, "wall"), "1 wall");
    EXPECT_EQ(counted(2, "wall"), "2 walls");
}

TEST(CoordinateText, IsWhatAnAuthorWroteOnEitherGrid) {
    for (const double written : {0.0, 2.2, -1.25, 8.1, 100.0, 3.7, 0.3, -32768.0}) {
        EXPECT_EQ(coordinate_text(snap_to_vertex_grid({written, 0}).x), number_text(written));
        EXPECT_EQ(coordinate_text(snap_to_point_grid({written, 0}).x), number_text(written));
    }
    // Neighbours are told apart.
    EXPECT_EQ(coordinate_text(2.2001953125), "2.2");
    EXPECT_EQ(coordinate_text(2.2001953125 + kVertexGrid), "2.201");
    EXPECT_NE(coordinate_text(8 + kPointGrid), "8");
    EXPECT_EQ(point_text({2.2001953125, -1}), "(2.2, -1)");
}

TEST(NearestSuggestion, SaysNothingWhereNoneIsNear) {
    EXPECT_EQ(nearest_suggestion("txeture", kKnown), "; did you mean 'texture'?");
    EXPECT_EQ(nearest_suggestion("mirrored", kKnown), "");
}

TEST(Suggestion, FindsTheNearestWord) { EXPECT_EQ(suggestion("txeture", kKnown), "; did you mean 'texture'?"); }

TEST(Suggestion, ListsAllWhereNoneIsNear) {
    EXPECT_EQ(suggestion("mirrored", kKnown), "; known here: texture, next, x, y");
}

TEST(Suggestion, DoesNotCompareEndlessWords) {
    EXPECT_EQ(suggestion(std::string(1'000'000, 'x'), kKnown), "; known here: texture, next, x, y");
}

TEST(StringText, EscapesWhatTomlWants) {
    EXPECT_EQ(string_text("a\"b\\c\td\ne\x01\x7F é"), R"("a\"b\\c\td\ne\u0001\u007F é")");
}

}  // namespace
}  // namespace enfilade
