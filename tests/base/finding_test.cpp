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

}  // namespace
}  // namespace enfilade
