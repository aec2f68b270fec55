// Side tests against exact arithmetic, where they are hardest: one unit from a line, and on it.
#include "math/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "math/points.h"
#include "support/exact.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kTrials = 3000;
constexpr std::array kBothGrids{kVertexGrid, kPointGrid};

int exact_corner(const Triple& t) { return cross(exact(t.b) - exact(t.a), exact(t.c) - exact(t.a)).sign(); }

int exact_side_of_line(Vec2 a, Vec2 b, Vec2 p) { return cross(exact(b) - exact(a), exact_moved(p) - exact(a)).sign(); }

int exact_side_of_path(Vec2 p, Vec2 q, Vec2 v) {
    return cross(exact_moved(q) - exact_moved(p), exact(v) - exact_moved(p)).sign();
}

Triple random_triple(Random& random, double grid) {
    Triple t{random_point(random, grid), random_point(random, grid), random_point(random, grid)};
    if (t.a == t.b) t.b.x = t.a.x + 1;
    return t;
}

/// Random triples, near misses and ties, in turn.
Triple hard_triple(Random& random, int trial, double grid) {
    switch (trial % 3) {
        case 0: return random_triple(random, grid);
        case 1: return nearly_straight(random, grid);
        default: return straight(random, grid);
    }
}

// hard cases T7, T10
TEST(Corner, IsExactForMapVertices) {
    Random random(11);
    test::count_trials(kTrials, "triples");
    for (int i = 0; i < kTrials; ++i) {
        const Triple t = hard_triple(random, i, kVertexGrid);
        ASSERT_EQ(corner(t.a, t.b, t.c), exact_corner(t)) << "trial " << i;
    }
}

TEST(Corner, TurnsRightClockwiseOnTheDrawing) {
    EXPECT_EQ(corner({0, 0}, {1, 0}, {1, 1}), 1);
    EXPECT_EQ(corner({0, 0}, {1, 0}, {1, -1}), -1);
    EXPECT_EQ(corner({0, 0}, {1, 0}, {5, 0}), 0);
}

TEST(Corner, IsTheSameFromEveryVertexAndOppositeInTheOtherDirection) {
    Random random(12);
    for (int i = 0; i < kTrials; ++i) {
        const Triple t = hard_triple(random, i, kVertexGrid);
        const int turn = corner(t.a, t.b, t.c);
        ASSERT_EQ(corner(t.b, t.c, t.a), turn) << "trial " << i;
        ASSERT_EQ(corner(t.c, t.a, t.b), turn) << "trial " << i;
        ASSERT_EQ(corner(t.c, t.b, t.a), -turn) << "trial " << i;
    }
}

// hard cases C2, C3
TEST(SideOfLine, IsExactOnBothGrids) {
    for (double grid : kBothGrids) {
        Random random(13);
        test::count_trials(kTrials, "triples");
        for (int i = 0; i < kTrials; ++i) {
            const Triple t = hard_triple(random, i, grid);
            ASSERT_EQ(side_of_line(t.a, t.b, t.c), exact_side_of_line(t.a, t.b, t.c)) << "trial " << i;
        }
    }
}

TEST(SideOfLine, IsRightWhereTheSectorIs) {
    EXPECT_EQ(side_of_line({0, 0}, {1, 0}, {0.5, 1}), 1);
    EXPECT_EQ(side_of_line({0, 0}, {1, 0}, {0.5, -1}), -1);
}

// hard cases C2, C3, C5
TEST(SideOfLine, DecidesEveryTieByTheTieRule) {
    const Vec2 here{3, 4};
    EXPECT_EQ(side_of_line({0, 4}, {9, 4}, here), 1) << "the point counts as moved down by e^2";
    EXPECT_EQ(side_of_line({9, 4}, {0, 4}, here), -1);
    EXPECT_EQ(side_of_line({3, 0}, {3, 9}, here), -1) << "the point counts as moved to +x by e";
    EXPECT_EQ(side_of_line({3, 9}, {3, 0}, here), 1);
    EXPECT_EQ(side_of_line({0, 1}, {6, 7}, here), -1) << "along a diagonal, e outweighs e^2";
    EXPECT_EQ(side_of_line(here, {9, 4}, here), 1) << "on the end of the line";
}

TEST(SideOfLine, IsOppositeForTheOppositeLine) {
    for (double grid : kBothGrids) {
        Random random(14);
        for (int i = 0; i < kTrials; ++i) {
            const Triple t = hard_triple(random, i, grid);
            const int side = side_of_line(t.a, t.b, t.c);
            ASSERT_TRUE(side == 1 || side == -1) << "trial " << i;
            ASSERT_EQ(side_of_line(t.b, t.a, t.c), -side) << "trial " << i;
        }
    }
}

// hard cases C1, C7
TEST(SideOfPath, IsExactOnBothGrids) {
    for (double grid : kBothGrids) {
        Random random(15);
        test::count_trials(kTrials, "triples");
        for (int i = 0; i < kTrials; ++i) {
            const Triple t = hard_triple(random, i, grid);
            ASSERT_EQ(side_of_path(t.a, t.b, t.c), exact_side_of_path(t.a, t.b, t.c)) << "trial " << i;
        }
    }
}

TEST(SideOfPath, IsOppositeForThePathBack) {
    Random random(16);
    for (int i = 0; i < kTrials; ++i) {
        const Triple t = hard_triple(random, i, kPointGrid);
        const int side = side_of_path(t.a, t.b, t.c);
        ASSERT_TRUE(side == 1 || side == -1) << "trial " << i;
        ASSERT_EQ(side_of_path(t.b, t.a, t.c), -side) << "trial " << i;
    }
}

// hard cases C1, C7
TEST(SideOfPath, DecidesEveryTieByMovingThePath) {
    EXPECT_EQ(side_of_path({0, 0}, {9, 0}, {4, 0}), -1) << "the path counts as moved down, the point is above it";
    EXPECT_EQ(side_of_path({0, 0}, {0, 9}, {0, 4}), 1) << "the path counts as moved to +x; facing down, right is -x";
}

// hard case T4
TEST(SideTests, HoldAtTheCornersOfTheWorld) {
    const std::array corners{Vec2{-kWorldLimit, -kWorldLimit}, Vec2{kWorldLimit, -kWorldLimit},
                             Vec2{kWorldLimit, kWorldLimit}, Vec2{-kWorldLimit, kWorldLimit}};
    for (Vec2 a : corners)
        for (Vec2 b : corners)
            for (Vec2 p : corners) {
                if (a == b) continue;
                EXPECT_EQ(side_of_line(a, b, p), exact_side_of_line(a, b, p));
                EXPECT_EQ(side_of_path(a, b, p), exact_side_of_path(a, b, p));
            }
}

TEST(ExactCross, IsRoundedOnce) {
    Random random(17);
    for (int i = 0; i < kTrials; ++i) {
        const Triple t = hard_triple(random, i, kPointGrid);
        const double rounded = exact_cross(t.a, t.b, t.c);
        const Integer truth = cross(exact(t.b) - exact(t.a), exact(t.c) - exact(t.a));
        const Integer error = truth - Integer::scaled(rounded, 2 * kExactUnits);
        const double ulp = std::nextafter(std::fabs(rounded), INFINITY) - std::fabs(rounded);
        const Integer allowed = rounded == 0 ? Integer(0) : Integer::scaled(ulp, 2 * kExactUnits);
        ASSERT_LE((error + error) * Integer(error.sign()), allowed) << "trial " << i;
    }
}

/// Whether the segment is nearer than radius, in whole grid steps of any size.
bool exact_is_nearer(Vec2 a, Vec2 b, Vec2 p, double radius) {
    const ExactPoint along = exact(b) - exact(a), to_p = exact(p) - exact(a), from_b = exact(p) - exact(b);
    const Integer r = Integer::scaled(radius, kExactUnits), length_squared = along.x * along.x + along.y * along.y;
    const Integer foot = along.x * to_p.x + along.y * to_p.y, area = cross(along, to_p);
    if (foot.sign() <= 0) return to_p.x * to_p.x + to_p.y * to_p.y < r * r;
    if (foot >= length_squared) return from_b.x * from_b.x + from_b.y * from_b.y < r * r;
    return area * area < r * r * length_squared;
}

// hard case C16
TEST(SegmentIsNearer, AgreesWithExactArithmeticAroundTheTouchingRadius) {
    Random random(31);
    test::count_trials(kTrials, "points");
    for (int i = 0; i < kTrials; ++i) {
        const Triple t = hard_triple(random, i, kPointGrid);
        const double distance = std::fabs(exact_cross(t.a, t.b, t.c)) / std::hypot(t.b.x - t.a.x, t.b.y - t.a.y);
        for (int step = -1; step <= 1; ++step) {
            const double radius = snap_to_point_grid(distance) + step * kPointGrid;
            if (radius <= 0) continue;
            ASSERT_EQ(segment_is_nearer(t.a, t.b, t.c, radius), exact_is_nearer(t.a, t.b, t.c, radius)) << i;
        }
    }
}

TEST(SegmentIsNearer, DoesNotCountTouching) {
    const double step = kPointGrid;
    EXPECT_FALSE(segment_is_nearer({0, 0}, {8, 0}, {4, 0.5}, 0.5));
    EXPECT_TRUE(segment_is_nearer({0, 0}, {8, 0}, {4, 0.5 - step}, 0.5));
    EXPECT_FALSE(segment_is_nearer({0, 0}, {8, 0}, {-3, 4}, 5));
    EXPECT_TRUE(segment_is_nearer({0, 0}, {8, 0}, {11 - step, 4}, 5));
}

/// Along (3, 4) all distances of whole steps times 5 are whole, however large: rounded numbers do not tell them.
TEST(SegmentIsNearer, DoesNotCountTouchingAskewOfLongWalls) {
    Random random(32);
    const auto at = [](std::int64_t x, std::int64_t y) {
        return Vec2{static_cast<double>(x) * kPointGrid, static_cast<double>(y) * kPointGrid};
    };
    for (int i = 0; i < 10000; ++i) {
        const auto length = static_cast<std::int64_t>((std::uint64_t{1} << 44) + random.below(std::uint64_t{1} << 44));
        const auto foot = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(length)));
        const auto away = static_cast<std::int64_t>(1 + random.below(std::uint64_t{1} << 44));
        const Vec2 p = at(3 * foot - 4 * away, 4 * foot + 3 * away), end = at(3 * length, 4 * length);
        const double distance = static_cast<double>(5 * away) * kPointGrid;
        ASSERT_FALSE(segment_is_nearer({0, 0}, end, p, distance)) << i;
        ASSERT_TRUE(segment_is_nearer({0, 0}, end, p, distance + kPointGrid)) << i;
    }
}

TEST(SegmentIsNearer, TakesASegmentOfNoLengthForAPoint) {
    EXPECT_TRUE(segment_is_nearer({1, 1}, {1, 1}, {4, 5}, 5 + kPointGrid));
    EXPECT_FALSE(segment_is_nearer({1, 1}, {1, 1}, {4, 5}, 5));
}

TEST(SegmentIsNearer, IsNeverNearerThanNothing) { EXPECT_FALSE(segment_is_nearer({0, 0}, {8, 0}, {4, 0}, 0)); }

}  // namespace
}  // namespace enfilade
