// Finding names, the nearest ones, and those used twice.
#include "map/draft.h"

#include <gmock/gmock.h>

namespace enfilade {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

NameIndex rooms() {
    return NameIndex(
        {{0, "hall", 0}, {0, "cellar", 1}, {1, "door", 7}, {0, "hall", 4}, {2, "door", 3}, {0, "hall", 2}});
}

TEST(NameIndex, FindsTheFirstOfAName) { EXPECT_EQ(rooms().find(0, "hall"), 0u); }

TEST(NameIndex, KeepsScopesApart) {
    EXPECT_EQ(rooms().find(1, "door"), 7u);
    EXPECT_EQ(rooms().find(2, "door"), 3u);
    EXPECT_FALSE(rooms().find(0, "door"));
}

TEST(NameIndex, TellsEveryFurtherUseOfAName) { EXPECT_THAT(rooms().duplicates(), ElementsAre(Pair(0, 2), Pair(0, 4))); }

TEST(NameIndex, SuggestsTheNearestName) {
    EXPECT_EQ(rooms().suggestion(0, "celar"), "; did you mean 'cellar'?");
    EXPECT_EQ(rooms().suggestion(0, "attic"), "");
    EXPECT_EQ(rooms().suggestion(3, "door"), "");
}

TEST(NameIndex, StopsSuggestingWhenItHasCostTooMuch) {
    std::vector<std::string> texts;
    for (int i = 0; i < 1'000; ++i) texts.push_back("room" + std::to_string(i));
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < texts.size(); ++i) names.push_back({0, texts[i], i});
    const NameIndex index(std::move(names));
    EXPECT_NE(index.suggestion(0, "romm5"), "");
    for (int i = 0; i < 200; ++i) index.suggestion(0, "nothing like it");
    EXPECT_EQ(index.suggestion(0, "romm5"), "");
}

}  // namespace
}  // namespace enfilade
