// Ids: an index with a "none", and no way to mix two kinds.
#include "base/id.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace enfilade {
namespace {

static_assert(!std::is_convertible_v<SectorId, WallId> && !std::is_constructible_v<SectorId, WallId>);
static_assert(!std::is_convertible_v<std::uint32_t, SectorId>);
static_assert(sizeof(SectorId) == 4);

TEST(Id, IsNoneUntilItIsGivenAnIndex) {
    EXPECT_TRUE(SectorId{}.is_none());
    EXPECT_FALSE(SectorId{});
    EXPECT_FALSE(SectorId{std::uint32_t{0}}.is_none());
    EXPECT_TRUE(SectorId{std::uint32_t{0}});
}

TEST(Id, IsOrderedByIndexWithNoneLast) {
    EXPECT_LT(WallId{std::uint32_t{3}}, WallId{std::uint32_t{4}});
    EXPECT_LT(WallId{std::uint32_t{4}}, WallId{});
    EXPECT_EQ(WallId{std::size_t{7}}, WallId{std::uint32_t{7}});
}

}  // namespace
}  // namespace enfilade
