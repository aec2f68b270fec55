// Rigid maps: composing and undoing them is exact where maps need it, and tightly bounded elsewhere.
#include "math/vec.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "math/points.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kRigidTrials = 5000;

/// A turn by quarters, mirrored or not, with a shift on the vertex grid and a rise.
Rigid random_exact_map(Random& random) {
    constexpr std::array<Vec2, 4> kQuarters{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    const Vec2 turn = kQuarters[random.below(4)];
    return {turn.x, turn.y, random.below(2) ? 1.0 : -1.0, random_point(random, kVertexGrid),
            random_coordinate(random, kVertexGrid, 1000)};
}

/// As above, but turned by the angle of a Pythagorean triple or of any direction.
Rigid random_map(Random& random) {
    Rigid map = random_exact_map(random);
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double length = std::sqrt(x * x + y * y);
    return {x / length, y / length, map.flip, map.shift, map.rise};
}

TEST(Rigid, WithoutValuesIsTheIdentity) {
    EXPECT_TRUE(Rigid{}.is_identity());
    EXPECT_EQ(Rigid{}.apply({3, 4}), (Vec2{3, 4}));
    EXPECT_EQ(Rigid{}.apply_height(5), 5);
}

TEST(Rigid, TurnsToTheRightThenShiftsThenRises) {
    const Rigid quarter{0, 1, 1, {10, 0}, 2};
    EXPECT_EQ(quarter.turn({1, 0}), (Vec2{0, 1}));
    EXPECT_EQ(quarter.apply({1, 0}), (Vec2{10, 1}));
    EXPECT_EQ(quarter.apply_height(1), 3);
}

TEST(Rigid, MirrorsBeforeItTurns) {
    const Rigid across_x_axis{1, 0, -1, {}, 0};
    EXPECT_EQ(across_x_axis.apply({3, 4}), (Vec2{3, -4}));
    const Rigid quarter_of_mirror{0, 1, -1, {}, 0};
    EXPECT_EQ(quarter_of_mirror.apply({3, 4}), (Vec2{4, 3})) << "mirrored to (3, -4), then turned right";
}

// hard case R28
TEST(Rigid, KeepsOrSwapsLeftAndRightAsFlipSays) {
    Random random(51);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid map = random_exact_map(random);
        const Vec2 a = random_point(random, 1, 1000), b = random_point(random, 1, 1000);
        ASSERT_EQ(cross(map.turn(a), map.turn(b)), map.flip * cross(a, b));
        ASSERT_EQ(dot(map.turn(a), map.turn(b)), dot(a, b));
    }
}

TEST(Then, DoesOneAfterTheOtherExactlyForQuarterTurns) {
    Random random(52);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid first = random_exact_map(random), second = random_exact_map(random);
        const Vec2 p = random_point(random, kPointGrid);
        ASSERT_EQ(then(first, second).apply(p), second.apply(first.apply(p))) << "trial " << i;
        ASSERT_EQ(then(first, second).apply_height(1), second.apply_height(first.apply_height(1)));
    }
}

TEST(Then, GroupsAsItLikes) {
    Random random(53);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid a = random_exact_map(random), b = random_exact_map(random), c = random_exact_map(random);
        ASSERT_EQ(then(then(a, b), c), then(a, then(b, c))) << "trial " << i;
    }
}

TEST(Inverse, UndoesQuarterTurnsMirrorsAndGridShiftsExactly) {
    Random random(54);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid map = random_exact_map(random);
        ASSERT_TRUE(then(map, inverse(map)).is_identity()) << "trial " << i;
        ASSERT_TRUE(then(inverse(map), map).is_identity()) << "trial " << i;
        ASSERT_EQ(inverse(inverse(map)), map) << "trial " << i;
        const Vec2 p = random_point(random, kPointGrid);
        ASSERT_EQ(inverse(map).apply(map.apply(p)), p) << "trial " << i;
    }
}

TEST(Inverse, UndoesAnyTurnToWithinRounding) {
    // Coordinates below 2^17 m are rounded a handful of times, each time by at most 2^-37 m.
    constexpr double kRounding = 8 * 0x1p-37;
    Random random(55);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid map = random_map(random);
        const Vec2 p = random_point(random, kPointGrid);
        const Vec2 back = inverse(map).apply(map.apply(p));
        ASSERT_NEAR(back.x, p.x, kRounding) << "trial " << i;
        ASSERT_NEAR(back.y, p.y, kRounding) << "trial " << i;
    }
}

TEST(Then, DoesOneAfterTheOtherForAnyTurnToWithinRounding) {
    constexpr double kRounding = 8 * 0x1p-36;  // as above; two shifts lead up to 2^18 m
    Random random(56);
    for (int i = 0; i < kRigidTrials; ++i) {
        const Rigid first = random_map(random), second = random_map(random);
        const Vec2 p = random_point(random, kPointGrid);
        const Vec2 at_once = then(first, second).apply(p), in_turn = second.apply(first.apply(p));
        ASSERT_NEAR(at_once.x, in_turn.x, kRounding) << "trial " << i;
        ASSERT_NEAR(at_once.y, in_turn.y, kRounding) << "trial " << i;
        ASSERT_EQ(then(first, second).flip, first.flip * second.flip);
    }
}

// hard cases R25, C13
TEST(Then, ComesHomeExactlyAfterFourQuarterTurns) {
    const Rigid corner{0, 1, 1, {12.5, -3}, 0.25};
    Rigid round;
    for (int i = 0; i < 4; ++i) round = then(round, corner);
    EXPECT_EQ(round.c, 1);
    EXPECT_EQ(round.s, 0);
    EXPECT_EQ(round.shift, (Vec2{0, 0}));
    EXPECT_EQ(round.rise, 1);
}

// hard case R28
TEST(Then, OfTwoMirrorsIsATurn) {
    const Rigid floor_mirror{1, 0, -1, {}, 0}, diagonal_mirror{0, 1, -1, {}, 0};
    const Rigid both = then(floor_mirror, diagonal_mirror);
    EXPECT_EQ(both.flip, 1);
    EXPECT_EQ(both.apply({1, 0}), (Vec2{0, 1}));
}

}  // namespace
}  // namespace enfilade
