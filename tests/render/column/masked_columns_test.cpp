// How much is laid over a picture: a map may stack as many things as it likes, a frame has a limit.
#include "render/column/masked_columns.h"

#include <gtest/gtest.h>

namespace enfilade::column {
namespace {

constexpr int kWidth = 8, kHeight = 100;

TEST(MaskedColumns, TakeNoMoreOfAColumnThanItIsHighSoManyTimes) {
    MaskedColumns masked;
    masked.clear(kWidth, kHeight);
    for (int i = 0; i < 3 * MaskedColumns::kMostOverdraw; ++i) masked.note(0, 3, {0, kHeight}, {});
    EXPECT_EQ(masked.count(), std::size_t{MaskedColumns::kMostOverdraw});
    EXPECT_TRUE(masked.is_full(3));
}

TEST(MaskedColumns, CountRowsAndNotPictures) {
    MaskedColumns masked;
    masked.clear(kWidth, kHeight);
    for (int i = 0; i < 3 * MaskedColumns::kMostOverdraw; ++i) masked.note(0, 3, {50, 60}, {});
    EXPECT_EQ(masked.count(), std::size_t{3 * MaskedColumns::kMostOverdraw});
}

TEST(MaskedColumns, CountEachColumnByItselfAndEachFrameAnew) {
    MaskedColumns masked;
    masked.clear(kWidth, kHeight);
    for (int i = 0; i < MaskedColumns::kMostOverdraw; ++i) masked.note(0, 3, {0, kHeight}, {});
    EXPECT_FALSE(masked.is_full(2));
    EXPECT_FALSE(masked.is_full(4));
    masked.clear(kWidth, kHeight);
    EXPECT_FALSE(masked.is_full(3));
    EXPECT_EQ(masked.count(), 0u);
}

}  // namespace
}  // namespace enfilade::column
