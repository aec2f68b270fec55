// Names of keys.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "platform/input_event.h"

namespace enfilade {
namespace {

TEST(KeyNames, LeadBackToTheirKeys) {
    std::set<std::string_view> names;
    for (int i = 1; i < kKeyCount; ++i) {
        const auto key = static_cast<KeyCode>(i);
        EXPECT_FALSE(name_of(key).empty()) << i;
        EXPECT_EQ(key_named(name_of(key)), key);
        names.insert(name_of(key));
    }
    EXPECT_EQ(names.size(), std::size_t(kKeyCount - 1));
}

TEST(KeyNames, AreTheSameInSmallLetters) { EXPECT_EQ(key_named("left shift"), KeyCode::left_shift); }

TEST(KeyNames, AreUnknownWhereThereIsNoSuchKey) {
    EXPECT_EQ(key_named("Any"), KeyCode::unknown);
    EXPECT_EQ(key_named(""), KeyCode::unknown);
}

}  // namespace
}  // namespace enfilade
