// What an author reads of a text that is no TOML: each of the library's reasons in our words.
#include "formats/toml_tree.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>

#include "formats/toml.h"

namespace enfilade {
namespace {

std::string sentence_for(std::string_view text) {
    Findings findings;
    TomlDocument::parse(text, {}, findings);
    return findings.empty() ? "" : findings.front().sentence;
}

struct WordsCase {
    const char* text;
    const char* sentence;  ///< behind "not valid TOML: "
};

class TomlWords : public testing::TestWithParam<WordsCase> {};

TEST_P(TomlWords, SayWhatToWrite) {
    EXPECT_EQ(sentence_for(GetParam().text), std::string("not valid TOML: ") + GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    All, TomlWords,
    testing::Values(
        WordsCase{"a = \"x\nb = 1",
                  "expected the quote that ends the string, found the end of the line; add the "
                  "quote; a text of several lines stands in three quotes"},
        WordsCase{"a = 'x\nb = 1",
                  "expected the quote that ends the string, found the end of the line; add the "
                  "quote; a text of several lines stands in three quotes"},
        WordsCase{"a = \"x\x01y\"",
                  "expected a letter, found a control character; take it away, or write \\u0007 and "
                  "the like"},
        WordsCase{"a = \"x", "expected the quote that ends the string, found the end of the file; add the quote"},
        WordsCase{
            "a = 2,5",
            "expected the end of the line behind the value, found ','; decimal numbers have a point, as in 2.5; put "
            "each key onto a line of its own"},
        WordsCase{"a = [1, 2", "expected a ']' that ends the array, found the end of the file; add the bracket"},
        WordsCase{"a = [1 2]",
                  "expected a comma or ']', found '2'; put a comma between members, and a ']' behind the "
                  "last"},
        WordsCase{"a = { b = 1, }",
                  "expected a key behind the last comma, found '}'; take the comma away: TOML allows "
                  "none at the end of { }, though it does in [ ]"},
        WordsCase{"a = {\n",
                  "expected a key or '}', found the end of the line; braces end on the line they begin on, "
                  "with no comma before the last one"},
        WordsCase{"a 1", "expected a '=' behind the key, found '1'; write key = value, and strings in quotes"},
        WordsCase{"a =\n",
                  "expected a value behind the '=', found the end of the line; write a number, true, false, "
                  "or a string in quotes"},
        WordsCase{"a = 1\na = 2", "expected a key that is not there yet, found it again; give each key once"},
        WordsCase{"[a]\n[a]",
                  "expected a table that is not there yet, found it again; put its keys together, or write "
                  "[[name]] for one more of many"},
        WordsCase{"[a\n",
                  "expected a ']' behind the table's name, found the end of the line; write [name], or "
                  "[[name]] with two on either side"},
        WordsCase{"a = \"\\q\"",
                  "expected an escape that TOML knows, like \\n, \\t, \\\", \\\\ or \\u00e9, found "
                  "another; write each backslash twice, or put the string into single quotes"},
        WordsCase{"a = 012",
                  "expected a number without a zero before it, found one; take the zero away, or use "
                  "quotes"},
        WordsCase{"a = 1 b = 2",
                  "expected the end of the line behind the value, found 'b'; put each key onto a line "
                  "of its own; strings stand in quotes, comments begin with #"},
        WordsCase{"a = hall", "expected a value, found a word without quotes; put a string into quotes"}));

TEST(TomlWords, LeaveAReasonAsItIsThatTheyDoNotKnow) {
    EXPECT_EQ(toml_words("Error while parsing dreams: too deep", false), "Error while parsing dreams: too deep");
    EXPECT_EQ(toml_words("out of dreams", false), "out of dreams");
}

/// All string literals of a piece of C++, one behind the other.
std::string literals_in(const std::string& code) {
    const std::regex literal("R\"\\(([^)]*)\\)\"|\"((?:[^\"\\\\]|\\\\.)*)\"");
    std::string text;
    for (std::sregex_iterator it(code.begin(), code.end(), literal), end; it != end; ++it)
        text += (*it)[1].str() + (*it)[2].str();
    return std::regex_replace(text, std::regex(R"(\\\\)"), "\\");
}

// The library's reasons stand in its source, which is here, as it is header-only.
TEST(TomlWords, KnowEveryReasonOfTheLibrary) {
    std::ifstream file("/usr/include/toml++/impl/parser.inl");
    const std::string source{std::istreambuf_iterator<char>(file), {}};
    if (source.empty()) GTEST_SKIP() << "the library's source is not in /usr/include";
    const std::regex statement("push_parse_scope\\(([^;]*)\\);|set_error[a-z_]*\\(([^;]*?)\\);");
    std::string scope;
    int reasons = 0;
    for (std::sregex_iterator it(source.begin(), source.end(), statement), end; it != end; ++it) {
        if ((*it)[1].matched) scope = literals_in((*it)[1]);
        if (scope.empty()) scope = "hexadecimal integer";  // or one of three others, whose name is no literal
        const std::string reason = literals_in((*it)[2]);
        if (reason.empty()) continue;
        ++reasons;
        EXPECT_TRUE(has_toml_words(scope, reason)) << scope << ": " << reason;
    }
    EXPECT_GE(reasons, 100);
}

}  // namespace
}  // namespace enfilade
