// What the engine takes for granted about floating point, asked of the compiler and the machine at run time: no
// contraction, no fast-math, double means double, and tiny numbers do not vanish.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

namespace enfilade {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "double must be computed as double, not in wider registers");
static_assert(std::numeric_limits<double>::is_iec559);
#ifdef __FAST_MATH__
#error "this code is exact and must not be compiled with relaxed floating point"
#endif

/// Hides a value from the optimiser.
double opaque(double x) {
    volatile double hidden = x;
    return hidden;
}

// hard case D1
TEST(FloatingPoint, RoundsAProductBeforeItIsAddedTo) {
    const double x = opaque(1 + 0x1p-30), y = opaque(1 - 0x1p-30), z = opaque(-1);
    EXPECT_EQ(x * y + z, 0) << "a fused multiply-add would give -2^-60";
    EXPECT_EQ(std::fma(x, y, z), -0x1p-60) << "the probe above can tell the difference";
}

// hard case D1
TEST(FloatingPoint, RoundsFloatProductsToo) {
    volatile float x = 1 + 0x1p-15f, y = 1 - 0x1p-15f, z = -1;
    EXPECT_EQ(x * y + z, 0.0f);
}

// hard case D2
TEST(FloatingPoint, IsNotReassociated) {
    const double large = opaque(0x1p53), one = opaque(1);
    EXPECT_EQ((large + one) - large, 0);
    EXPECT_EQ((one + large * 0x1p10) - large * 0x1p10, 0);
    EXPECT_EQ(opaque(0.1) + opaque(0.2) + opaque(0.3) == opaque(0.1) + (opaque(0.2) + opaque(0.3)), false);
}

// hard case D3
TEST(FloatingPoint, DividesAndDoesNotMultiplyByAReciprocal) {
    const double x = opaque(5), y = opaque(49);
    EXPECT_NE(x / y, x * (1 / y)) << "49 is a divisor for which the two differ";
    EXPECT_EQ(x / y, 0x1.a1f58d0fac688p-4);
}

// hard cases C23, D2
TEST(FloatingPoint, KeepsDenormalNumbers) {
    const double least_normal = opaque(std::numeric_limits<double>::min());
    EXPECT_GT(least_normal / 2, 0);
    EXPECT_EQ(least_normal / 2 * 2, least_normal);
    EXPECT_NE(opaque(1.5 * std::numeric_limits<double>::min()) - least_normal, 0);
}

// hard case D2
TEST(FloatingPoint, KnowsNoNumberAndInfinity) {
    const double zero = opaque(0);
    EXPECT_TRUE(std::isnan(zero / zero));
    EXPECT_FALSE(zero / zero == zero / zero);
    EXPECT_TRUE(std::isinf(1 / zero));
    EXPECT_TRUE(std::signbit(-zero)) << "the sign of zero is kept";
}

// hard case D4
TEST(FloatingPoint, TakesExactSquareRoots) {
    EXPECT_EQ(std::sqrt(opaque(2)), 0x1.6a09e667f3bcdp+0);
    EXPECT_EQ(std::sqrt(opaque(0x1p-1074)), 0x1p-537);
}

}  // namespace
}  // namespace enfilade
