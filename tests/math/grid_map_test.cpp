// Turns of the point grid: nobody who goes there and back comes to another point.
#include "math/vec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "math/angle.h"
#include "support/trials.h"

namespace enfilade {
namespace {

Rigid turn(Vec2 direction) { return {direction.x, direction.y, 1, {}, 0}; }

Vec2 any_point(Random& random, double reach) {
    return snap_to_point_grid({random.uniform(-reach, reach), random.uniform(-reach, reach)});
}

// hard case C10
TEST(GridMap, AndItsInverseReturnEveryPoint) {
    Random random(1);
    test::count_trials(1'000'000, "points");
    for (int i = 0; i < 1'000'000; ++i) {
        const Rigid m = turn(direction(Angle{static_cast<std::uint32_t>(random.bits())}));
        const Vec2 from = any_point(random, kWorldLimit), onto = any_point(random, kWorldLimit);
        const Vec2 p = any_point(random, kWorldLimit);
        ASSERT_EQ(GridMap(inverse(m), onto, from).apply(GridMap(m, from, onto).apply(p)), p) << i;
    }
}

// hard case C10
TEST(GridMap, AndItsInverseReturnEveryPointAtOddEighths) {
    Random random(2);
    test::count_trials(100'000, "points");
    for (int i = 0; i < 100'000; ++i) {
        const Rigid m = turn(direction(Angle{static_cast<std::uint32_t>(random.below(8)) << 29}));
        const Vec2 from = any_point(random, 10), onto = any_point(random, 10), p = any_point(random, 10);
        ASSERT_EQ(GridMap(inverse(m), onto, from).apply(GridMap(m, from, onto).apply(p)), p) << i;
    }
}

TEST(GridMap, StaysWithinOneAndAHalfStepsOfTheTurn) {
    Random random(3);
    for (int i = 0; i < 1'000'000; ++i) {
        const Rigid m = turn(direction(Angle{static_cast<std::uint32_t>(random.bits())}));
        const Vec2 p = any_point(random, 100);  // near enough for the true place to be known to a small part of a step
        const Vec2 off = GridMap(m, {}, {}).apply(p) - m.apply(p);
        ASSERT_LE(std::sqrt(dot(off, off)), 1.5 * kPointGrid) << i;
    }
}

// hard case C28
TEST(GridMap, TurnsByQuartersExactly) {
    const Vec2 from{1, 2}, onto{-3, 0.5}, p{1.25, 2.5};
    EXPECT_EQ(GridMap(turn({1, 0}), from, onto).apply(p), (Vec2{-2.75, 1}));
    EXPECT_EQ(GridMap(turn({0, 1}), from, onto).apply(p), (Vec2{-3.5, 0.75}));
    EXPECT_EQ(GridMap(turn({-1, 0}), from, onto).apply(p), (Vec2{-3.25, 0}));
    EXPECT_EQ(GridMap(turn({0, -1}), from, onto).apply(p), (Vec2{-2.5, 0.25}));
}

TEST(GridMap, CarriesItsCentreOntoTheOther) {
    const Vec2 from{1, 2}, onto{-3, 0.5};
    for (std::uint32_t i = 0; i < 1000; ++i)
        EXPECT_EQ(GridMap(turn(direction(Angle{i * 4294967})), from, onto).apply(from), onto);
}

TEST(FineTurn, OfTheOtherSideIsExactlyTheOpposite) {
    Random random(4);
    for (int i = 0; i < 100'000; ++i) {
        const Vec2 d = direction(Angle{static_cast<std::uint32_t>(random.bits())});
        ASSERT_EQ(fine_turn_of(d) + fine_turn_of({d.x, -d.y}), 0u) << i;
    }
}

TEST(FineTurn, IsAsNearAsTheVectorItselfTells) {
    Random random(5);
    for (int i = 0; i < 100'000; ++i) {
        // Of whole numbers, as links have them: the true angle is known to more places than those of a double.
        const auto x = random.uniform(-1000, 1000), y = random.uniform(0, 1000), length = std::sqrt(x * x + y * y);
        const long double turns = static_cast<long double>(fine_turn_of({x / length, y / length})) * 0x1p-64L;
        ASSERT_NEAR(
            static_cast<double>(turns * 2 * 3.14159265358979323846264338L - std::atan2((long double)y, (long double)x)),
            0, 1e-15)
            << i;
    }
}

TEST(FineTurn, IsExactAlongTheAxes) {
    EXPECT_EQ(fine_turn_of({1, 0}), 0u);
    EXPECT_EQ(fine_turn_of({0, 1}), std::uint64_t{1} << 62);
    EXPECT_EQ(fine_turn_of({-1, 0}), std::uint64_t{1} << 63);
    EXPECT_EQ(fine_turn_of({0, -1}), std::uint64_t{3} << 62);
}

}  // namespace
}  // namespace enfilade
