// Snapping to the two grids: half to even, no negative zero, and what is on the grid stays.
#include "math/vec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"

namespace enfilade {
namespace {

/// The C library's rounding, half to even; the quotient is exact because the grid is a power of two.
double rounded(double x, double grid) { return std::nearbyint(x / grid) * grid; }

TEST(SnapToGrid, RoundsAsTheCLibraryDoes) {
    Random random(41);
    for (int i = 0; i < 100'000; ++i) {
        const double x = random.uniform(-kWorldLimit, kWorldLimit);
        ASSERT_EQ(snap_to_vertex_grid(x), rounded(x, kVertexGrid)) << x;
        ASSERT_EQ(snap_to_point_grid(x), rounded(x, kPointGrid)) << x;
    }
}

// hard case T3
TEST(SnapToGrid, RoundsHalvesToEven) {
    for (int steps = -9; steps <= 9; ++steps) {
        const int even = (steps % 2 != 0) ? steps + 1 : steps;  // of steps and steps + 1
        EXPECT_EQ(snap_to_vertex_grid((steps + 0.5) * kVertexGrid), even * kVertexGrid) << steps;
        EXPECT_EQ(snap_to_point_grid((steps + 0.5) * kPointGrid), even * kPointGrid) << steps;
    }
}

// hard case T1
TEST(SnapToGrid, LeavesNoNegativeZero) {
    for (double x : {-0.0, -kVertexGrid / 2, -1e-300, 0.0}) {
        EXPECT_FALSE(std::signbit(snap_to_vertex_grid(x))) << x;
        EXPECT_EQ(snap_to_vertex_grid(x), 0) << x;
    }
    EXPECT_FALSE(std::signbit(snap_to_point_grid(-0.0)));
}

TEST(SnapToGrid, LeavesWhatIsOnTheGrid) {
    Random random(42);
    for (int i = 0; i < 100'000; ++i) {
        const double vertex = static_cast<double>(static_cast<std::int64_t>(random.bits()) >> 38) * kVertexGrid;
        const double point = static_cast<double>(static_cast<std::int64_t>(random.bits()) >> 16) * kPointGrid;
        ASSERT_EQ(snap_to_vertex_grid(vertex), vertex);
        ASSERT_EQ(snap_to_point_grid(vertex), vertex) << "the vertex grid is part of the finer one";
        ASSERT_EQ(snap_to_point_grid(point), point);
    }
}

TEST(SnapToGrid, HoldsToTheEndsOfItsRange) {
    for (double sign : {-1.0, 1.0}) {
        EXPECT_EQ(snap_to_vertex_grid(sign * 0x1p41), sign * 0x1p41);
        EXPECT_EQ(snap_to_point_grid(sign * 0x1p18), sign * 0x1p18);
        const double almost = std::nextafter(kWorldLimit, 0) * sign;
        EXPECT_EQ(snap_to_vertex_grid(almost), sign * kWorldLimit);
    }
}

TEST(SnapToGrid, KeepsDoomsUnits) {
    for (int unit = -32768; unit < 32768; ++unit) ASSERT_EQ(snap_to_vertex_grid(unit / 32.0), unit / 32.0);
}

TEST(SnapToGrid, IsTheSameWhenTheCompilerDoesIt) {
    static_assert(snap_to_vertex_grid(0.1) == 102 * kVertexGrid);
    static_assert(snap_to_vertex_grid(Vec2{-0.1, 1.5 * kVertexGrid}) == Vec2{-102 * kVertexGrid, 2 * kVertexGrid});
    volatile double tenth = 0.1;
    EXPECT_EQ(snap_to_vertex_grid(tenth), 102 * kVertexGrid);
}

TEST(GridUnits, AreExactUpToTheirLimit) {
    EXPECT_EQ(to_grid_units(kPointGrid), 1);
    EXPECT_EQ(to_grid_units(-kVertexGrid), -(std::int64_t{1} << 22));
    EXPECT_EQ(to_grid_units(kWorldLimit - kPointGrid), (std::int64_t{1} << 47) - 1);
    EXPECT_EQ(to_grid_units(-0x1p30), -(std::int64_t{1} << 62));
}

}  // namespace
}  // namespace enfilade
