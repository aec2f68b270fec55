// The quick parser against the library: what it accepts, the library must read as the same values at the same places.
#include <gmock/gmock.h>

#include <filesystem>

#include "base/files.h"
#include "base/hash.h"
#include "formats/both_parsers.h"
#include "formats/toml_tree.h"

namespace enfilade {
namespace {

class PlainToml : public ::testing::TestWithParam<const char*> {};

TEST_P(PlainToml, IsReadAsTheLibraryReadsIt) {
    const ParsedTwice parsed = parse_twice(GetParam());
    EXPECT_TRUE(parsed.is_plain);
    EXPECT_EQ(parsed.plain, parsed.any);
}

INSTANTIATE_TEST_SUITE_P(Texts, PlainToml,
                         ::testing::Values("", "\n", "# only\n#\tcomments", "a = 1", "a=1#x\nb = -0\n",
                                           "  a\t=  true  \nb = false",
                                           "a = 0.5\nb = -1.25e-3\nc = 1e5\nd = 2E+2\ne = -0.0",
                                           "a = \"x y\"\nb = 'c:\\d'\nc = \"\"\nd = ''",
                                           "a = [1, 2.5, 'x', [], [true,],\n # so\n {b = 1}\n]\nc = 1",
                                           "a = {}\nb = { c = 1, d = [1\n,2] }", "a = 1\r\nb = 2\r\n# c\r\n",
                                           "a = 'äö€' # ß\nb = ['ü', 'x', {k = '𝄞', l = 2}]",
                                           "a = 1\n[b]\nc = 2\n[d]\n",
                                           "[[a]]\nx = 1\n[[a.b]]\ny = 1\n[[a.b]]\n[a.c]\nz = 3\n[[a]]\nx = 2\n[[a.b]]",
                                           " [ a ] # c\n [[ b ]]\n [[ b . c ]]\n", "[a]\n[a.b]\n[[a.c]]\nx = 1",
                                           "a-b_9 = 123456789012345678", "a = 1.000000000000000000000000000000"));

class OddToml : public ::testing::TestWithParam<const char*> {};

TEST_P(OddToml, IsLeftToTheLibrary) { EXPECT_FALSE(parse_plain_toml(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Texts, OddToml,
                         ::testing::Values("a = \"\\n\"", "a.b = 1", "'a' = 1", "a = 1979-05-27", "a = 0x10", "a = +1",
                                           "a = 1_000", "a = nan", "a = \"\"\"x\"\"\"", "a = '''x'''",
                                           "\xEF\xBB\xBF"
                                           "a = 1",
                                           "a = 1\na = 2", "a = [1]\n[[a]]", "[a]\n[a]", "a = {}\n[a.b]", "[a.b]",
                                           "a = 1 b = 2", "a = [1 2]", "a = [,]", "a = {b = 1,}", "a = {b = 1",
                                           "a = [1", "a = 01", "a = 1.", "a = .5", "a = tru", "a = truex", "[a", "[[a]",
                                           "[a]]", "a = 1\rb = 2", "a", "= 1", "a = \"x", "a = 'x\ny'", "a = '\x01'",
                                           "# \x01", "a = 1234567890123456789", "[[a]]\n[a]", "[a]\n[[a]]", "a = 1e",
                                           "a = -", "a = 1.0000000000000000000000000000000"));

TEST(PlainTomlFiles, AreTheProjectsOwnMaps) {
    int plain = 0;
    for (const auto& file : std::filesystem::directory_iterator(ENFILADE_SOURCE_DIR "/maps")) {
        if (file.path().extension() != ".toml") continue;
        const auto bytes = read_file(file.path().string());
        const ParsedTwice parsed = parse_twice(as_text(bytes.value()));
        plain += parsed.is_plain;
        EXPECT_EQ(parsed.plain, parsed.any) << file.path();
    }
    EXPECT_GE(plain, 15);
}

/// Two places of a text changed: letters that mean something put in, taken out, or swapped.
std::string spoiled(std::string text, Random& random) {
    constexpr std::string_view kLetters = "[]{}=,.\"'#\n\r\t -+_eE0123456789abtrue\\\x01";
    for (int changes = 0; changes < 2; ++changes) {
        const std::size_t at = random.below(text.size());
        const char letter = kLetters[random.below(kLetters.size())];
        switch (random.below(3)) {
            case 0: text.insert(at, 1, letter); break;
            case 1: text.erase(at, 1); break;
            default: text[at] = letter;
        }
    }
    return text;
}

TEST(PlainTomlSpoiled, IsAcceptedOnlyAsTheLibraryReadsIt) {
    const std::string sound =
        "a = 1\nb = [1.5, 'x', { c = true, d = \"y\" }, [\n]] # e\n[f]\ng = -0.25\n[[h]]\ni = 7e3\n[[h.j]]\nk = {}\n"
        "[h.l]\nm = ''\n[[h]]\n[[n]]\n";
    Random random(1);
    int plain = 0;
    for (int i = 0; i < 40000; ++i) {
        const std::string text = spoiled(sound, random);
        const ParsedTwice parsed = parse_twice(text);
        plain += parsed.is_plain;
        ASSERT_EQ(parsed.plain, parsed.any) << text;
    }
    EXPECT_GE(plain, 2500);  // enough of them are still TOML
}

}  // namespace
}  // namespace enfilade
