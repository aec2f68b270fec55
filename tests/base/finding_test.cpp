// Findings as text, their order, and which of them refuse a file.
#include "base/finding.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Finding, IsPrintedAsCompilersDo) {
    EXPECT_EQ(to_text("a.toml", {{3, 7}, Severity::error, "unknown-key", "unknown key `colour`"}),
              "a.toml:3:7: error: unknown key `colour` [unknown-key]");
    EXPECT_EQ(to_text("a.toml", {{3, 7}, Severity::warning, "no-picture", "no file a.png"}),
              "a.toml:3:7: warning: no file a.png [no-picture]");
}

TEST(Finding, WithoutAPlaceIsAboutTheWholeFile) {
    EXPECT_EQ(to_text("a.toml", {{}, Severity::error, "too-large", "600 MB"}), "a.toml: error: 600 MB [too-large]");
}

TEST(Findings, AreErrorsWhenOneOfThemIs) {
    const Finding warning{{1, 1}, Severity::warning, "w", "w"};
    const Finding error{{1, 1}, Severity::error, "e", "e"};
    EXPECT_FALSE(has_errors({}));
    EXPECT_FALSE(has_errors({warning, warning}));
    EXPECT_TRUE(has_errors({warning, error}));
}

TEST(Findings, AreSortedByPlaceAndOtherwiseStayInOrder) {
    Findings findings{{{2, 1}, Severity::error, "d", ""},
                      {{1, 9}, Severity::error, "b", ""},
                      {{1, 9}, Severity::error, "c", ""},
                      {{0, 0}, Severity::error, "a", ""}};
    sort_by_place(findings);
    std::string codes;
    for (const Finding& f : findings) codes += f.code;
    EXPECT_EQ(codes, "abcd");
}

TEST(CaretLines, ShowTheLineAndThePlaceInIt) {
    EXPECT_EQ(caret_lines("format = 1\nname = 7\n", {2, 8}), "  2 | name = 7\n    |        ^\n");
    EXPECT_EQ(caret_lines("a\r\nb\r\n", {2, 1}), "  2 | b\n    | ^\n");
    EXPECT_EQ(caret_lines("a = 1", {1, 6}), "  1 | a = 1\n    |      ^\n") << "behind the last letter";
}

TEST(CaretLines, CountCharactersAsEditorsDo) {
    EXPECT_EQ(caret_lines("\tname = \"é\", x", {1, 14}), "  1 |  name = \"é\", x\n    |              ^\n");
}

TEST(CaretLines, ShowOfALongLineWhatIsAround) {
    const std::string text = std::string(200, 'a') + "b" + std::string(200, 'c');
    const std::string shown = caret_lines(text, {1, 201});
    EXPECT_EQ(shown, "  1 | …" + std::string(64, 'a') + "b" + std::string(31, 'c') + "…\n    | " +
                         std::string(65, ' ') + "^\n");
}

TEST(CaretLines, AreNoneWhereThereIsNoSuchPlace) {
    EXPECT_EQ(caret_lines("a\nb\n", {0, 0}), "");
    EXPECT_EQ(caret_lines("a\nb\n", {9, 1}), "");
    EXPECT_EQ(caret_lines("a\nb\n", {1, 7}), "");
}

TEST(CaretLines, ObeyNothing) { EXPECT_EQ(caret_lines("a\x1B[2Jb", {1, 1}), "  1 | a?[2Jb\n    | ^\n"); }

TEST(Sources, TellWhoseAPlaceIs) {
    const std::vector<SourceFile> sources{{"a.toml", 11}, {"b.toml", 31}};
    Findings findings{{{10, 2}, Severity::error, "x", "x"},
                      {{11, 3}, Severity::error, "y", "y"},
                      {{33, 4}, Severity::error, "z", "z"}};
    tell_files(findings, sources);
    EXPECT_EQ(to_text("map.toml", findings[0]), "map.toml:10:2: error: x [x]");
    EXPECT_EQ(to_text("map.toml", findings[1]), "a.toml:1:3: error: y [y]");
    EXPECT_EQ(to_text("map.toml", findings[2]), "b.toml:3:4: error: z [z]");
}

}  // namespace
}  // namespace enfilade
