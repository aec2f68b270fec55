// The door to the TOML library: what comes through, and what is turned away before the library sees it.
#include "formats/toml.h"

#include <gmock/gmock.h>

#include "base/hash.h"
#include "formats/findings.h"
#include "formats/hostile.h"
#include "formats/toml_tree.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr TomlLimits kLimits;

/// A sound text: this test fails where it is not.
TomlDocument sound(std::string_view text) {
    Findings findings;
    auto document = TomlDocument::parse(text, kLimits, findings);
    EXPECT_THAT(codes_and_places(findings), IsEmpty()) << text;
    return document ? *std::move(document) : *TomlDocument::parse("", kLimits, findings);
}

/// The value of the first key.
TomlNode first_value(const TomlDocument& document) { return document.root().entries().at(0).value; }

std::vector<std::string> complaints(std::string_view text, const TomlLimits& limits = kLimits) {
    Findings findings;
    const bool parsed = TomlDocument::parse(text, limits, findings).has_value();
    EXPECT_EQ(parsed, findings.empty());
    return codes_and_places(findings);
}

std::string repeated(std::string_view part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

struct KindCase {
    const char* value;
    TomlKind kind;
};

class TomlKinds : public testing::TestWithParam<KindCase> {};

TEST_P(TomlKinds, AreTold) {
    const TomlDocument document = sound(std::string("a = ") + GetParam().value);
    EXPECT_EQ(first_value(document).kind(), GetParam().kind);
}

INSTANTIATE_TEST_SUITE_P(All, TomlKinds,
                         testing::Values(KindCase{"'x'", TomlKind::string}, KindCase{"1", TomlKind::integer},
                                         KindCase{"1.0", TomlKind::real}, KindCase{"inf", TomlKind::real},
                                         KindCase{"true", TomlKind::boolean}, KindCase{"1979-05-27", TomlKind::date},
                                         KindCase{"07:32:00", TomlKind::date}, KindCase{"[]", TomlKind::array},
                                         KindCase{"{}", TomlKind::table}));

TEST(Toml, TakesWholeNumbersForNumbers) {
    const TomlDocument document = sound("a = -7");
    EXPECT_EQ(first_value(document).number(), -7.0);
    EXPECT_EQ(first_value(document).integer(), -7);
}

TEST(Toml, ReadsNumbersToTheLastBit) {
    const TomlDocument document = sound("a = 0.1000000000000000055511151231257827");
    EXPECT_EQ(first_value(document).number(), 0.1);
}

TEST(Toml, GivesMembersInTheOrderOfTheText) {
    std::vector<std::string> keys;
    const TomlDocument document = sound("z = 1\na = 2\n[m]\n[b]\n");
    for (const TomlEntry& entry : document.root().entries()) keys.emplace_back(entry.key);
    EXPECT_THAT(keys, ElementsAre("z", "a", "m", "b"));
}

TEST(Toml, KnowsThePlacesOfKeysAndValues) {
    const TomlDocument document = sound("\n  key =  [1,\n 2]");
    const TomlEntry entry = document.root().entries().at(0);
    EXPECT_EQ(entry.key_place, (TextPlace{2, 3}));
    EXPECT_EQ(entry.value.place(), (TextPlace{2, 10}));
    EXPECT_EQ(entry.value.at(1).place(), (TextPlace{3, 2}));
}

TEST(Toml, CountsColumnsInCharacters) {
    const TomlDocument document = sound("a = ['é漢', 1]");
    EXPECT_EQ(first_value(document).at(1).place(), (TextPlace{1, 12}));
}

TEST(Toml, LooksPastAByteOrderMark) {
    const TomlDocument document = sound("\xEF\xBB\xBFkey = 1");
    EXPECT_EQ(document.root().entries().at(0).key_place, (TextPlace{1, 1}));
}

TEST(Toml, TakesAnEmptyTextForAnEmptyTable) { EXPECT_EQ(sound("").root().size(), 0u); }

struct BadCase {
    const char* text;
    const char* complaint;
};

void PrintTo(const BadCase& bad, std::ostream* out) { *out << bad.complaint; }

class BadToml : public testing::TestWithParam<BadCase> {};

TEST_P(BadToml, IsRefusedWithItsPlace) { EXPECT_THAT(complaints(GetParam().text), ElementsAre(GetParam().complaint)); }

INSTANTIATE_TEST_SUITE_P(Syntax, BadToml,
                         testing::Values(BadCase{"a = ", "bad-toml 1:5"}, BadCase{"a = 1\na = 2", "bad-toml 2:5"},
                                         BadCase{"a = [1, 2\nc = 3", "bad-toml 2:1"}, BadCase{"a = 08", "bad-toml 1:7"},
                                         BadCase{"a = \"", "bad-toml 1:6"},
                                         BadCase{"a = 99999999999999999999", "bad-toml 1:25"},
                                         BadCase{"a = {b = 1,\nc = 2}", "bad-toml 1:12"},
                                         BadCase{"a = \"\\ud800\"", "bad-toml 1:12"}));

// Texts that fuzzing found to break assertions of toml++ 3.3.0.
INSTANTIATE_TEST_SUITE_P(BrokenAssertions, BadToml,
                         testing::Values(BadCase{"[=]", "bad-toml 1:2"}, BadCase{"[.a]", "bad-toml 1:2"},
                                         BadCase{"[[=\"b\"", "bad-toml 1:3"}));

// … and to reach what it thought unreachable.
INSTANTIATE_TEST_SUITE_P(BareLetters, BadToml,
                         testing::Values(BadCase{"ç=1", "bad-toml 1:1"}, BadCase{"aç,]12", "bad-toml 1:2"},
                                         BadCase{"a = 1\nb = é", "bad-toml 2:5"},
                                         BadCase{"a = 'é'\u00A0", "bad-toml 1:8"}));

// A forgotten quote before an accent: the library looks ahead in a bare value, where the letters are no text to it.
INSTANTIATE_TEST_SUITE_P(QuotesInBareWords, BadToml,
                         testing::Values(BadCase{"a = 1'é'", "bad-toml 1:6"}, BadCase{"a = 2'é", "bad-toml 1:6"},
                                         BadCase{"a = 1\"é\"", "bad-toml 1:6"}, BadCase{"a = 0x1'é'", "bad-toml 1:8"},
                                         BadCase{"a = 1979-05-27'é'", "bad-toml 1:15"},
                                         BadCase{"a = [1'é']", "bad-toml 1:7"}, BadCase{"[1'é']", "bad-toml 1:3"},
                                         BadCase{"a = -'é'", "bad-toml 1:6"}, BadCase{"a = 1.'é'", "bad-toml 1:7"}));

TEST(Toml, AsksForTheQuoteThatIsMissing) {
    Findings findings;
    TomlDocument::parse("name = caf'é'", kLimits, findings);
    TomlDocument::parse("name = café'", kLimits, findings);
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].sentence,
              "expected the end of a key or a value, found a quote; is the quote at its start missing?");
    EXPECT_EQ(findings[1].sentence,
              "expected a key or a value, found 'é'; letters beyond ASCII may only stand in quotes and comments: is "
              "the quote before it missing?");
}

INSTANTIATE_TEST_SUITE_P(NotUtf8, BadToml,
                         testing::Values(BadCase{"a = 1 # \xE9\n", "not-utf8 1:9"},
                                         BadCase{"a = '\xC3\xA9'\nb = '''\n\xC3\xA9\xFF'''", "not-utf8 3:2"},
                                         BadCase{"\xFF\xFE", "not-utf8 1:1"}, BadCase{"a = '\xC0\x80'", "not-utf8 1:6"},
                                         BadCase{"a = '\xED\xA0\x80'", "not-utf8 1:6"},
                                         BadCase{"a = '\xF4\x90\x80\x80'", "not-utf8 1:6"},
                                         BadCase{"a = '\xE6\xBC", "not-utf8 1:6"}));

class DeepToml : public testing::TestWithParam<const char*> {};

// {open} is repeated; one nesting more than allowed is refused, a million do not harm.
TEST_P(DeepToml, IsRefusedHoweverDeep) {
    for (int depth : {kMaxTomlDepth + 1, 1'000'000}) {
        const std::string text = std::string(GetParam()[0] == '.' ? "a" : "a = ") + repeated(GetParam(), depth);
        ASSERT_EQ(complaints(text, {64 << 20, 64 << 20}).size(), 1u);
        EXPECT_EQ(complaints(text, {64 << 20, 64 << 20})[0].substr(0, 8), "too-deep") << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, DeepToml, testing::Values("[", "{a=", "[{b.c=", ".a", "[\n", ". 'a' "));

TEST(Toml, RefusesDeepHeaders) {
    EXPECT_THAT(complaints("[a" + repeated(".a", kMaxTomlDepth + 1) + "]"), ElementsAre("too-deep 1:131"));
}

TEST(Toml, CountsHeadersDotsAndBracketsTogether) {
    const std::string text = "[a" + repeated(".a", 30) + "]\nb" + repeated(".b", 20) + " = " + repeated("[", 20);
    EXPECT_THAT(complaints(text), ElementsAre("too-deep 2:57"));
}

TEST(Toml, ReadsToTheAllowedDepth) {
    EXPECT_THAT(complaints("a = " + repeated("[", kMaxTomlDepth) + repeated("]", kMaxTomlDepth)), IsEmpty());
}

TEST(Toml, DoesNotTakeStringsAndCommentsForNesting) {
    const std::string brackets = repeated("[{.", 100);
    EXPECT_THAT(complaints("# " + brackets + "\na = '" + brackets + "'\nb = \"\\\"" + brackets + "\"\nc = '''\n'" +
                           brackets + "''''\nd = \"\"\"\"" + brackets + "\\\"\"\"\"\n"),
                IsEmpty());
}

TEST(Toml, DoesNotTakeDecimalPointsForNesting) {
    EXPECT_THAT(complaints("a = [" + repeated("1.5, ", 100) + "]\nb = 1.5\n"), IsEmpty());
}

TEST(Toml, RefusesMoreBytesThanAllowed) { EXPECT_THAT(complaints("a = 1", {4, 100}), ElementsAre("too-large 0:0")); }

TEST(Toml, RefusesMoreValuesThanAllowed) {
    EXPECT_THAT(complaints("a = [1, 2, 3]", {100, kKeyWeight + 3}), IsEmpty());
    EXPECT_THAT(complaints("a = [1, 2, 3]", {100, kKeyWeight + 2}), ElementsAre("too-large 1:10"));
}

TEST(Toml, CountsWhatTakesMoreMemoryAsMoreValues) {
    const auto expect_count = [](std::string_view text, std::size_t count, const char* last) {
        EXPECT_THAT(complaints(text, {100, count}), IsEmpty()) << text;
        EXPECT_THAT(complaints(text, {100, count - 1}), ElementsAre(last)) << text;
    };
    expect_count("a = {}", kKeyWeight + kTableWeight, "too-large 1:5");
    expect_count("a = 'b'", kKeyWeight + kStringWeight, "too-large 1:5");
    expect_count("a.b = 1", kTableWeight + kKeyWeight, "too-large 1:5");
    expect_count("[a]", kTableWeight, "too-large 1:1");
    expect_count("[[a]]", kTableWeight + 1, "too-large 1:2");
}

TEST(Toml, RefusesDottedKeysThatWouldTakeQuadraticTime) {
    std::string text;
    for (std::size_t i = 0; i <= kMaxDottedKeys; ++i) text += "k" + std::to_string(i) + ".b = 1\n";
    EXPECT_THAT(complaints(text, {64 << 20, 64 << 20}), ElementsAre("too-large 65537:7"));
}

TEST(Toml, RefusesDottedHeadersThatWouldTakeQuadraticTime) {
    std::string text;
    for (std::size_t i = 0; i <= kMaxDottedHeaders; ++i) text += "[k" + std::to_string(i) + ".b]\n";
    EXPECT_THAT(complaints(text, {64 << 20, 64 << 20}), ElementsAre("too-large 262145:9"));
}

TEST(Toml, ReadsMoreOfAPlainTextThanTheLibraryWouldBeGiven) {
    std::string text = "a = [\n";
    for (std::size_t i = 0; i <= kLibraryLimits.values; ++i) text += "0,\n";
    text += "]\n";
    EXPECT_THAT(complaints(text, {64 << 20, 64 << 20}), ElementsAre());
    EXPECT_THAT(complaints(text + "b = \"\\u0041\"\n", {64 << 20, 64 << 20}), ElementsAre("too-large 8999998:2"));
}

TEST(Toml, SurvivesRandomTexts) {
    static constexpr std::string_view kParts[] = {"[",  "]",      "{", "}",  "=", ".", ",",  "\n",   "a",  "'",
                                                  "\"", "\"\"\"", "#", "\\", "1", "-", "e5", "inf",  "é",  "\xFF",
                                                  " ",  "[[",     "_", "+",  ":", "T", "0x", "true", "\t", "\r\n"};
    for (std::uint64_t seed = 0; seed < 5000; ++seed) {
        Random random(seed);
        std::string text;
        for (std::uint64_t i = random.below(30); i > 0; --i) text += kParts[random.below(std::size(kParts))];
        EXPECT_LE(complaints(text).size(), 1u) << text;
    }
}

TEST(Toml, SurvivesBeingCutAnywhere) {
    constexpr std::string_view kText =
        "\xEF\xBB\xBF# é\n[a.'b'.\"c\\u00e9\"]\nd = [1, 2.5e-3, 0xFF, 1979-05-27T07:32:00Z, '''\n''', "
        "\"\"\"\\\n\"\"\"]\n"
        "[[x]]\ny = { z = true, 'w' = nan }\n";
    sound(kText);
    for_each_cut(kText, [](std::string_view cut) { EXPECT_LE(complaints(cut).size(), 1u); });
}

TEST(Toml, WritesEveryValueItReads) {
    const std::pair<const char*, const char*> values[] = {
        {"nan", "nan"},
        {"-inf", "-inf"},
        {"+inf", "inf"},
        {"1", "1"},
        {"1.0", "1.0"},
        {"-2.5e3", "-2500.0"},
        {"1e300", "1e+300"},
        {"0xFF", "255"},
        {"9223372036854775807", "9223372036854775807"},
        {"-9223372036854775808", "-9223372036854775808"},
        {"true", "true"},
        {"'a\"\\b'", R"("a\"\\b")"},
        {"\"\\u0000\"", R"("\u0000")"},
        {"1979-05-27", "1979-05-27"},
        {"07:32:00.5", "07:32:00.5"},
        {"1979-05-27 07:32:00.999-07:30", "1979-05-27T07:32:00.999-07:30"},
        {"[ ]", "[]"},
        {"[nan, [-inf], 1979-05-27]", "[nan, [-inf], 1979-05-27]"},
        {"{ 'a b' = { c.d = 07:32:00 } }", R"({ "a b" = { "c" = { "d" = 07:32:00 } } })"}};
    for (const auto& [read, written] : values) {
        const std::string text = value_text(first_value(sound(std::string("x = ") + read)));
        EXPECT_EQ(text, written);
        EXPECT_EQ(value_text(first_value(sound("x = " + text))), written);
    }
}

}  // namespace
}  // namespace enfilade
