// The oracle is tested too: laws of arithmetic, and 128-bit products the compiler knows.
#include "support/exact.h"

#include <gtest/gtest.h>

#include "base/hash.h"

namespace enfilade::test {
namespace {

TEST(Integer, AgreesWithTheCompilersProducts) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto a = static_cast<std::int64_t>(random.bits()) >> random.below(64);
        const auto b = static_cast<std::int64_t>(random.bits()) >> random.below(64);
        __extension__ const __int128 product = static_cast<__int128>(a) * b;
        const Integer expected = (Integer(static_cast<std::int64_t>(product >> 64)) << 64) +
                                 (Integer(static_cast<std::int64_t>((product >> 32) & 0xFFFFFFFF)) << 32) +
                                 Integer(static_cast<std::int64_t>(product & 0xFFFFFFFF));
        EXPECT_EQ(Integer(a) * Integer(b), expected);
    }
}

TEST(Integer, KeepsTheLawsOfArithmeticForHugeNumbers) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Integer a = Integer(static_cast<std::int64_t>(random.bits())) << static_cast<int>(random.below(500));
        const Integer b = Integer(static_cast<std::int64_t>(random.bits())) << static_cast<int>(random.below(500));
        EXPECT_EQ((a + b) * (a - b), a * a - b * b);
        EXPECT_EQ(a - a, Integer(0));
        EXPECT_EQ(a<b, b> a);
    }
}

TEST(Integer, HoldsADoubleExactly) {
    EXPECT_EQ(Integer::scaled(-1.5, 1), Integer(-3));
    EXPECT_EQ(Integer::scaled(0x1p40, -8), Integer(std::int64_t{1} << 32));
    EXPECT_EQ(Integer::scaled(0x1p-32, 544), Integer(1) << 512);
    EXPECT_EQ(Integer::scaled(0, 10), Integer(0));
    EXPECT_EQ(Integer::scaled(0x1.FFFFFFFFFFFFFp0, 52), Integer((std::int64_t{1} << 53) - 1));
}

TEST(Integer, HasOneZero) {
    EXPECT_EQ(-Integer(0), Integer(0));
    EXPECT_EQ(Integer(0).sign(), 0);
    EXPECT_EQ((Integer(-5) + Integer(5)).sign(), 0);
    EXPECT_EQ((Integer(-5) * Integer(0)), Integer(0));
}

}  // namespace
}  // namespace enfilade::test
