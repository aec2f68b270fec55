// Where a path crosses lines, and in which order, against exact rationals.
#include <gtest/gtest.h>

#include <vector>

#include "math/points.h"
#include "math/predicates.h"
#include "support/exact.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kPathTrials = 2000;

struct Path {
    Vec2 p, q;
};
struct Line {
    Vec2 a, b;
};

/// Where the path, moved by the tie rule, meets the line.
ExactFraction exact_fraction(const Path& path, const Line& line) {
    const ExactPoint along = exact(line.b) - exact(line.a);
    const Integer at_p = cross(along, exact_moved(path.p) - exact(line.a));
    const Integer at_q = cross(along, exact_moved(path.q) - exact(line.a));
    const Integer fall = at_p - at_q;
    return fall.sign() < 0 ? ExactFraction{-at_p, -fall} : ExactFraction{at_p, fall};
}

bool crosses(const Path& path, const Line& line) {
    return side_of_line(line.a, line.b, path.p) != side_of_line(line.a, line.b, path.q);
}

Path random_path(Random& random, double limit) {
    return {random_point(random, kPointGrid, limit), random_point(random, kPointGrid, limit)};
}

/// A line that the path crosses: often through a grid point on the path, where many lines meet.
Line line_across(Random& random, const Path& path) {
    while (true) {
        Line line{random_point(random, kVertexGrid), random_point(random, kVertexGrid)};
        if (random.below(2)) line.a = random.below(2) ? path.p : path.q;
        if (!(line.a == line.b) && crosses(path, line)) return line;
    }
}

TEST(FractionAlongPath, IsExact) {
    Random random(21);
    for (int i = 0; i < kPathTrials; ++i) {
        const Path path = random_path(random, kWorldLimit);
        const Line line = line_across(random, path);
        const PathFraction f = fraction_along_path(path.p, path.q, line.a, line.b);
        ASSERT_GT(f.denominator, 0);
        const ExactFraction truth = exact_fraction(path, line);
        const Integer value = Integer::scaled(f.value(), 1200);  // rounded three times, each within 2^-53 of itself
        const Integer error = (value * truth.denominator - (truth.numerator << 1200)) << 51;
        const Integer bound = (truth.numerator << 1200) + (truth.denominator << (1200 - 53));
        ASSERT_LE(error * Integer(error.sign()), bound * Integer(bound.sign())) << "trial " << i;
    }
}

// hard case C6
TEST(FractionAlongPath, IsOrderedAsExactRationalsAre) {
    Random random(22);
    test::count_trials(kPathTrials, "paths");
    for (int i = 0; i < kPathTrials; ++i) {
        const Path path = random_path(random, kWorldLimit);
        const Line s = line_across(random, path), t = line_across(random, path);
        const int order =
            compare(fraction_along_path(path.p, path.q, s.a, s.b), fraction_along_path(path.p, path.q, t.a, t.b));
        ASSERT_EQ(order, compare(exact_fraction(path, s), exact_fraction(path, t))) << "trial " << i;
    }
}

TEST(FractionAlongPath, OrdersLinesThroughOnePointOfThePath) {
    Random random(23);
    int ties = 0;
    for (int i = 0; i < kPathTrials; ++i) {
        const Vec2 meeting = random_point(random, kVertexGrid, 1000);
        const Vec2 reach = random_point(random, kVertexGrid, 1000);
        const Path path{meeting - reach, meeting + reach};
        const Line s{meeting, random_point(random, kVertexGrid)}, t{random_point(random, kVertexGrid), meeting};
        if (s.a == s.b || t.a == t.b || !crosses(path, s) || !crosses(path, t)) continue;
        ++ties;
        const int order =
            compare(fraction_along_path(path.p, path.q, s.a, s.b), fraction_along_path(path.p, path.q, t.a, t.b));
        ASSERT_EQ(order, compare(exact_fraction(path, s), exact_fraction(path, t))) << "trial " << i;
    }
    EXPECT_GT(ties, kPathTrials / 2);
}

TEST(FractionAlongPath, IsEqualOnlyForOneLine) {
    const Path path{{-1, 0}, {1, 0}};
    const auto at = [&](Vec2 a, Vec2 b) { return fraction_along_path(path.p, path.q, a, b); };
    EXPECT_EQ(compare(at({0, -1}, {0, 1}), at({0, 5}, {0, 3})), 0);
    EXPECT_NE(compare(at({0, -1}, {0, 1}), at({1, -1}, {-1, 1})), 0) << "both through the origin, other directions";
    EXPECT_EQ(compare(at({0, -1}, {0, 1}), at({0.5, -1}, {0.5, 1})), -1);
    EXPECT_EQ(compare(at({0.5, -1}, {0.5, 1}), at({0, -1}, {0, 1})), 1);
    EXPECT_EQ(at({0.5, -1}, {0.5, 1}).value(), 0.75);
}

// hard case C25
TEST(FractionAlongPath, RunsBackwardsOnTheWayBack) {
    Random random(24);
    for (int i = 0; i < kPathTrials; ++i) {
        const Path path = random_path(random, 100);
        const Line s = line_across(random, path), t = line_across(random, path);
        const int there =
            compare(fraction_along_path(path.p, path.q, s.a, s.b), fraction_along_path(path.p, path.q, t.a, t.b));
        const int back =
            compare(fraction_along_path(path.q, path.p, s.a, s.b), fraction_along_path(path.q, path.p, t.a, t.b));
        ASSERT_EQ(there, -back) << "trial " << i;
    }
}

/// True where the moved path passes the wall between its ends, from its right to its left.
bool exactly_leaves_through(const Path& path, const Line& wall) {
    if (path.p == path.q) return false;
    const ExactPoint p = exact_moved(path.p), q = exact_moved(path.q), a = exact(wall.a), b = exact(wall.b);
    const auto side = [](const ExactPoint& from, const ExactPoint& to, const ExactPoint& v) {
        return cross(to - from, v - from).sign();
    };
    return side(a, b, p) > 0 && side(a, b, q) < 0 && side(p, q, a) != side(p, q, b);
}

// hard case C1
TEST(PathLeavesThrough, IsExact) {
    Random random(25);
    int left = 0;
    test::count_trials(kPathTrials, "paths");
    for (int i = 0; i < kPathTrials; ++i) {
        const Path path = random_path(random, 10);
        Line wall{random_point(random, kVertexGrid, 10), random_point(random, kVertexGrid, 10)};
        if (i % 4 == 1) wall.a = path.p;
        if (i % 4 == 2) wall.b = path.q;
        if (i % 4 == 3) wall = {path.p * 2 - path.q, path.q};  // the path runs along the wall and ends with it
        if (wall.a == wall.b) continue;
        const bool leaves = path_leaves_through(path.p, path.q, wall.a, wall.b);
        left += leaves;
        ASSERT_EQ(leaves, exactly_leaves_through(path, wall)) << "trial " << i;
    }
    EXPECT_GT(left, kPathTrials / 20);
}

// hard case C4
TEST(PathLeavesThrough, IsNeverTrueForAPathOfNoLength) {
    EXPECT_FALSE(path_leaves_through({3, 0}, {3, 0}, {0, 0}, {9, 0}));
}

/// A convex room around the origin, clockwise on the drawing, all of it on the vertex grid.
std::vector<Vec2> room() { return {{-4, -3}, {0, -5}, {4, -3}, {6, 1}, {3, 5}, {-2, 4}, {-5, 1}}; }

// hard case C1
TEST(PathLeavesThrough, LeavesAConvexRoomThroughExactlyOneWallEvenThroughAVertex) {
    const auto v = room();
    Random random(26);
    test::count_trials(kPathTrials, "paths");
    for (int i = 0; i < kPathTrials; ++i) {
        const Vec2 inside = random_point(random, 0.25, 2);
        const Vec2 vertex = v[random.below(v.size())];
        const Vec2 outside = vertex + (vertex - inside) * static_cast<double>(1 + random.below(50));
        int exits = 0;
        for (std::size_t w = 0; w < v.size(); ++w)
            exits += path_leaves_through(inside, outside, v[w], v[(w + 1) % v.size()]);
        ASSERT_EQ(exits, 1) << "trial " << i;
    }
}

TEST(CompareProducts, IsExactAtEverySize) {
    Random random(27);
    const auto number = [&] {
        const auto high = static_cast<std::int64_t>(random.bits() >> 2) * (random.below(2) ? 1 : -1);
        const Int128 full = Int128{high} * (Int128{1} << 64) + random.bits();
        return full / (Int128{1} << random.below(126));
    };
    const auto exactly = [](Int128 x) {
        return (Integer(static_cast<std::int64_t>(x >> 64)) << 64) +
               (Integer(static_cast<std::int64_t>((x >> 32) & 0xFFFFFFFF)) << 32) +
               Integer(static_cast<std::int64_t>(x & 0xFFFFFFFF));
    };
    for (int i = 0; i < 10 * kPathTrials; ++i) {
        const Int128 a = number(), b = number(), c = number(), d = number();
        ASSERT_EQ(compare_products(a, b, c, d), (exactly(a) * exactly(b) - exactly(c) * exactly(d)).sign());
    }
}

TEST(CompareProducts, SeesEqualProductsOfDifferentFactors) {
    Random random(28);
    for (int i = 0; i < kPathTrials; ++i) {
        const auto factor = [&] { return Int128{static_cast<std::int64_t>(random.bits())} >> 2; };
        const Int128 w = factor(), x = factor(), y = factor(), z = factor();
        ASSERT_EQ(compare_products(w * x, y * z, w * y, x * z), 0);
        ASSERT_EQ(compare_products(w * x, y * z, w * y, -(x * z)),
                  ((w > 0) == (x > 0)) == ((y > 0) == (z > 0)) ? 1 : -1);
    }
}

TEST(CompareProducts, HoldsAtTheEndsOfItsRange) {
    const Int128 most = (Int128{1} << 126) - 1;
    EXPECT_EQ(compare_products(most, most, most, most - 1), 1);
    EXPECT_EQ(compare_products(most, -most, most - 1, -most), -1);
    EXPECT_EQ(compare_products(-most, -most, most, most), 0);
    EXPECT_EQ(compare_products(0, most, -most, 0), 0);
    EXPECT_EQ(compare_products(0, most, 1, -1), 1);
    EXPECT_EQ(compare_products(-1, 1, 0, 0), -1);
}

}  // namespace
}  // namespace enfilade
