// Angles: exact where a map needs them exact, and a stated error against the C library in long double elsewhere.
#include "math/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "base/hash.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kQuarter = 1u << 30;
constexpr std::uint32_t kEighth = 1u << 29;

/// Random steps, and those around every eighth of a turn, where series and signs change. Stops at the first failure.
template <class Visit>
void for_many_steps(Visit visit) {
    const auto failed = [&](std::uint32_t steps) {
        visit(steps);
        return ::testing::Test::HasFatalFailure();
    };
    Random random(31);
    for (int i = 0; i < 200'000; ++i)
        if (failed(static_cast<std::uint32_t>(random.bits()))) return;
    for (std::uint32_t eighth = 0; eighth < 8; ++eighth)
        for (std::uint32_t near = 0; near < 2000; ++near)
            if (failed(eighth * kEighth + near - 1000)) return;
}

/// (cos, sin) by the C library.
struct LongDirection {
    long double x, y;
};

/// The quarter turns are taken out first, and the angle measured from the nearer axis: so pi is not rounded away.
LongDirection true_direction(std::uint32_t steps) {
    constexpr long double kRadiansPerStep = std::numbers::pi_v<long double> / 2147483648.0L;
    const std::uint32_t rest = steps % kQuarter;
    const bool past_middle = rest > kEighth;
    const long double radians = (past_middle ? kQuarter - rest : rest) * kRadiansPerStep;
    long double c = std::cos(radians), s = std::sin(radians);
    if (past_middle) std::swap(c, s);
    switch (steps / kQuarter) {
        case 0: return {c, s};
        case 1: return {-s, c};
        case 2: return {-c, -s};
        default: return {s, -c};
    }
}

TEST(Direction, IsWithinItsStatedError) {
    constexpr long double kStated = 0x1p-52L;
    for_many_steps([&](std::uint32_t steps) {
        const Vec2 d = direction({steps});
        const LongDirection truth = true_direction(steps);
        ASSERT_LE(std::fabs(d.x - truth.x), kStated) << steps;
        ASSERT_LE(std::fabs(d.y - truth.y), kStated) << steps;
    });
}

TEST(Direction, IsWithinTwoUnitsInTheLastPlaceEvenNextToZero) {
    const auto ulps = [](double found, long double truth) {
        const double size = std::fabs(found);
        return std::fabs(found - truth) / (std::nextafter(size, 2) - size);
    };
    for_many_steps([&](std::uint32_t steps) {
        if (steps % kQuarter == 0) return;
        const Vec2 d = direction({steps});
        const LongDirection truth = true_direction(steps);
        ASSERT_LE(ulps(d.x, truth.x), 2) << steps;
        ASSERT_LE(ulps(d.y, truth.y), 2) << steps;
    });
}

// hard case C28
TEST(Direction, IsExactAtQuarterTurns) {
    EXPECT_EQ(direction({0}), (Vec2{1, 0}));
    EXPECT_EQ(direction({kQuarter}), (Vec2{0, 1}));
    EXPECT_EQ(direction({2 * kQuarter}), (Vec2{-1, 0}));
    EXPECT_EQ(direction({3 * kQuarter}), (Vec2{0, -1}));
}

TEST(Direction, HasEqualSizesAtHalfwayAngles) {
    for (std::uint32_t odd : {1u, 3u, 5u, 7u}) {
        const Vec2 d = direction({odd * kEighth});
        EXPECT_EQ(std::fabs(d.x), std::fabs(d.y)) << odd;
        EXPECT_EQ(std::fabs(d.x), std::sqrt(0.5)) << odd;
    }
}

TEST(Direction, TurnsExactlyByQuarters) {
    for_many_steps([](std::uint32_t steps) {
        const Vec2 d = direction({steps});
        ASSERT_EQ(direction({steps + kQuarter}), right_of(d)) << steps;
        ASSERT_EQ(direction({steps + 2 * kQuarter}), -d) << steps;
    });
}

TEST(Direction, IsMirroredExactlyInBothAxes) {
    for_many_steps([](std::uint32_t steps) {
        const Vec2 d = direction({steps});
        ASSERT_EQ(direction(Angle{} - Angle{steps}), (Vec2{d.x, -d.y})) << steps;
        ASSERT_EQ(direction(Angle{kQuarter} - Angle{steps}), (Vec2{d.y, d.x})) << steps;
    });
}

// A change of the last bit of any sine changes pictures and replays, so it has to be seen here first.
// hard case D4
TEST(Direction, HasKnownBits) {
    EXPECT_EQ(direction(Angle::from_degrees(30)), (Vec2{0x1.bb67ae879cf4fp-1, 0x1.fffffff8beab5p-2}));
    EXPECT_EQ(direction({123456789}), (Vec2{0x1.f7ac16cc628a3p-1, 0x1.6fe03a5403383p-3}));
}

TEST(Tangent, IsWithinFourUnitsInTheLastPlace) {
    for_many_steps([](std::uint32_t steps) {
        const Angle angle{steps / 2 - kQuarter};
        if (angle.steps == 0 - kQuarter) return;  // -90 degrees; all others are in (-90, 90)
        const LongDirection truth = true_direction(angle.steps);
        const double found = tangent(angle);
        const double ulp = std::nextafter(std::fabs(found), INFINITY) - std::fabs(found);
        ASSERT_LE(std::fabs(found - truth.y / truth.x), 4 * ulp) << steps;
    });
}

TEST(Tangent, IsOneAtHalfARightAngle) {
    EXPECT_EQ(tangent(Angle::from_degrees(45)), 1);
    EXPECT_EQ(tangent(Angle::from_degrees(-45)), -1);
    EXPECT_EQ(tangent(Angle{}), 0);
}

TEST(TurnOf, IsWithinItsStatedErrorAtAnyLength) {
    constexpr long double kStated = 1e-15L;
    Random random(32);
    for (int i = 0; i < 200'000; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random.below(1800)) - 900);
        const Vec2 v{random.uniform(-size, size), random.uniform(-size, size)};
        const long double turns = std::atan2(static_cast<long double>(v.y), static_cast<long double>(v.x)) /
                                  (2 * std::numbers::pi_v<long double>);
        const long double truth = turns < 0 ? turns + 1 : turns;
        const long double apart = std::fabs(turn_of(v) - truth);
        ASSERT_LE(std::min(apart, 1 - apart), kStated) << v.x << ' ' << v.y;
    }
}

TEST(TurnOf, UndoesDirection) {
    for_many_steps([](std::uint32_t steps) {
        const double turn = turn_of(direction({steps}));
        ASSERT_GE(turn, 0);
        ASSERT_LT(turn, 1);
        const double apart = std::fabs(turn - steps * 0x1p-32);
        ASSERT_LE(std::min(apart, 1 - apart), 1e-15) << steps;
    });
}

TEST(TurnOf, IsExactAlongTheAxes) {
    EXPECT_EQ(turn_of({5, 0}), 0);
    EXPECT_EQ(turn_of({5, -0.0}), 0);
    EXPECT_EQ(turn_of({0, 5}), 0.25);
    EXPECT_EQ(turn_of({-5, 0}), 0.5);
    EXPECT_EQ(turn_of({0, -5}), 0.75);
    EXPECT_EQ(turn_of({0, 0}), 0);
}

TEST(TurnOf, NeverReachesAFullTurn) { EXPECT_LT(turn_of({1, -1e-300}), 1); }

// hard case C29
TEST(Angle, WrapsByItself) {
    EXPECT_EQ(Angle::from_degrees(350) + Angle::from_degrees(20), Angle::from_degrees(10));
    EXPECT_EQ(Angle::from_degrees(10) - Angle::from_degrees(20), Angle::from_degrees(-10));
}

// hard case C28
TEST(Angle, IsExactAtWholeQuartersHoweverManyTurnsAway) {
    for (double turns : {0.0, 1.0, -1.0, 1e9, -1e9, 0x1p40}) {
        EXPECT_EQ(Angle::from_degrees(turns * 360).steps, 0u) << turns;
        EXPECT_EQ(Angle::from_degrees(turns * 360 + 90).steps, kQuarter) << turns;
        EXPECT_EQ(Angle::from_degrees(turns * 360 - 90).steps, 3 * kQuarter) << turns;
    }
}

// hard case C29
TEST(Angle, IsTheNearestStepAfterABillionTurns) {
    for (double degrees : {1.0, 7.25, 123.5, 359.0})
        EXPECT_EQ(Angle::from_degrees(360e9 + degrees), Angle::from_degrees(degrees)) << degrees;
}

TEST(Angle, JustBelowZeroIsZeroAndNotAFullTurn) {
    EXPECT_EQ(Angle::from_degrees(-1e-300).steps, 0u);
    EXPECT_EQ(Angle::from_degrees(-0.0).steps, 0u);
    EXPECT_EQ(Angle::from_degrees(std::nextafter(360.0, 0)).steps, 0u);
}

TEST(Angle, IsTheNearestStep) {
    // Half a step, and what a division and a product of doubles may add at 2^32 steps: 2^32 * 2^-52.
    constexpr long double kNearest = 0.5L + 0x1p-20L;
    Random random(33);
    for (int i = 0; i < 100'000; ++i) {
        const double degrees = random.uniform(-1000, 1000);
        const long double truth = std::remainder(static_cast<long double>(degrees), 360.0L) / 360 * 4294967296.0L;
        const long double apart = std::remainder(Angle::from_degrees(degrees).steps - truth, 4294967296.0L);
        ASSERT_LE(std::fabs(apart), kNearest) << degrees;
    }
}

TEST(Angle, ComesBackFromDegrees) {
    for_many_steps([](std::uint32_t steps) {
        const Angle angle{steps};
        ASSERT_GE(angle.degrees(), 0);
        ASSERT_LT(angle.degrees(), 360);
        ASSERT_EQ(Angle::from_degrees(angle.degrees()), angle);
    });
}

TEST(Angle, TakesRadiansToTheSameQuarters) {
    EXPECT_EQ(Angle::from_radians(std::numbers::pi / 2).steps, kQuarter);
    EXPECT_EQ(Angle::from_radians(-std::numbers::pi / 2).steps, 3 * kQuarter);
    EXPECT_EQ(Angle::from_radians(std::numbers::pi / 4).steps, kEighth);
    EXPECT_EQ(Angle::from_radians(3.14159).steps, Angle::from_degrees(3.14159 * 180 / std::numbers::pi).steps);
}

TEST(AngleOf, UndoesDirection) {
    Random random(9);
    for (int i = 0; i < 10000; ++i) {
        const Angle angle{static_cast<std::uint32_t>(random.bits())};
        ASSERT_EQ(angle_of(direction(angle)).steps, angle.steps);
    }
}

TEST(AngleOf, IsOppositeInTheMirror) {
    Random random(10);
    for (int i = 0; i < 10000; ++i) {
        const Vec2 v{random.uniform(-1, 1), random.uniform(-1, 1)};
        ASSERT_EQ((angle_of(v) + angle_of({v.x, -v.y})).steps, 0u);
    }
}

// hard case C29
TEST(AngleOf, WrapsToZeroJustBelowAFullTurn) { EXPECT_EQ(angle_of({1, -1e-300}), Angle{}); }

}  // namespace
}  // namespace enfilade
