// How much is laid over a picture: a map may stack as many things as it likes, a frame has a limit.
#include "render/column/viewport_drawer.h"

#include <gtest/gtest.h>

namespace enfilade::column {
namespace {

constexpr int kMaskedWidth = 8;

TEST(MaskedColumns, TakeNoMoreOfAColumnThanTheMostPictures) {
    MaskedColumns masked;
    masked.clear(kMaskedWidth);
    for (std::size_t i = 0; i < 3 * kMostPictures; ++i) masked.note(0, 3, {0, 100}, {});
    EXPECT_EQ(masked.count(), kMostPictures);
    EXPECT_TRUE(masked.is_full(3));
}

TEST(MaskedColumns, CountPicturesThatAreAboveOrBelowWhatIsOpen) {
    MaskedColumns masked;
    masked.clear(kMaskedWidth);
    for (std::size_t i = 0; i < kMostPictures; ++i) masked.note(0, 3, {60, 60}, {});
    EXPECT_TRUE(masked.is_full(3));
    EXPECT_EQ(masked.count(), 0u);
}

TEST(MaskedColumns, CountEachColumnByItselfAndEachFrameAnew) {
    MaskedColumns masked;
    masked.clear(kMaskedWidth);
    for (std::size_t i = 0; i < kMostPictures; ++i) masked.note(0, 3, {0, 100}, {});
    EXPECT_FALSE(masked.is_full(2));
    EXPECT_FALSE(masked.is_full(4));
    masked.clear(kMaskedWidth);
    EXPECT_FALSE(masked.is_full(3));
    EXPECT_EQ(masked.count(), 0u);
}

}  // namespace
}  // namespace enfilade::column
