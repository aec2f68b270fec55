// Products without rounding against whole numbers of any size.
#include "math/exact_product.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "support/exact.h"

namespace enfilade::test {
namespace {

constexpr int kFraction = 400;  ///< every double here is a whole number of 2^-kFraction

Integer whole(Int128 x) {
    const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) & 0xFFFFFFFFu);
    return (Integer(static_cast<std::int64_t>(x >> 32)) << 32) + Integer(low);
}

/// Up to 94 bits, often few.
Int128 random_whole(Random& random) {
    const Int128 high = static_cast<std::int64_t>(random.bits()), low = static_cast<std::int64_t>(random.bits());
    return ((high >> 34 << 64) + low) >> random.below(94);
}

double random_double(Random& random) {
    const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random.bits()) >> random.below(63));
    return std::ldexp(mantissa, static_cast<int>(random.below(60)) - 120);
}

/// a * x * y, once by each arithmetic; the oracle's in units of 2^-2 kFraction.
struct Product {
    ExactProduct product;
    Integer truth;

    Product(Int128 a, double x, double y)
        : product(ExactProduct(a).times(x).times(y)),
          truth(whole(a) * Integer::scaled(x, kFraction) * Integer::scaled(y, kFraction)) {}
};

int order(const Product& a, const Product& b) { return (a.truth - b.truth).sign(); }

TEST(ExactProduct, IsOrderedAsWholeNumbersAre) {
    Random random(1);
    for (int i = 0; i < 50'000; ++i) {
        const Product a(random_whole(random), random_double(random), random_double(random));
        const Product b(random_whole(random), random_double(random), random_double(random));
        ASSERT_EQ(compare(a.product, b.product), order(a, b)) << i;
    }
}

TEST(ExactProduct, TellsEqualProductsFromThoseThatDifferInTheLastBit) {
    Random random(2);
    for (int i = 0; i < 50'000; ++i) {
        const Int128 a = random_whole(random);
        const double x = random_double(random), y = random_double(random);
        const Product product(a, x, y), swapped(a, y, x), more(a + 1, x, y),
            longer(a, x != 0 ? std::nextafter(x, 1) : x, y);
        ASSERT_EQ(compare(product.product, swapped.product), 0);
        ASSERT_EQ(compare(product.product, more.product), order(product, more));
        ASSERT_EQ(compare(product.product, longer.product), order(product, longer));
    }
}

TEST(ExactProduct, HoldsTheLargestAndSmallestNumbers) {
    const Int128 most = (Int128{1} << 113) - 1;
    const ExactProduct large = ExactProduct(most).times(0x1.fffffffffffffp1023).times(0x1.fffffffffffffp1023);
    const ExactProduct small = ExactProduct(-most).times(0x1p-1074).times(0x1p-1074);
    EXPECT_EQ(compare(large, small), 1);
    EXPECT_EQ(compare(small, ExactProduct(Int128{0}).times(3.0)), -1);
    EXPECT_EQ(compare(ExactProduct(Int128{0}), ExactProduct(Int128{5}).times(0.0)), 0);
    EXPECT_EQ(compare(ExactProduct(Int128{1}).scaled(23), ExactProduct(Int128{1} << 23)), 0);
}

}  // namespace
}  // namespace enfilade::test
