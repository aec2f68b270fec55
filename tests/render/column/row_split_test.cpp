// Rows at a wall: where ceiling, steps, opening and floor begin.
#include "render/column/viewport.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/hash.h"

namespace enfilade::column {
namespace {

/// fov 90 and a square picture: focal_y is half the width.
RayTables pitched_screen(int width, int height, double pitch_tangent = 0) {
    View view;
    view.pitch_tangent = pitch_tangent;
    RayTables screen;
    screen.set(Projection(view, width, height));
    return screen;
}

int first_row_below(const RayTables& screen, double height, double depth, int top, int bottom) {
    return RowsAt(screen, depth).first_below(height, top, bottom);
}

/// The definition, row by row.
int first_row_below_by_search(const RayTables& screen, double height, double depth, int top, int bottom) {
    for (int y = top; y < bottom; ++y)
        if (screen.tied_rises[y] * depth < height * screen.focal_y) return y;
    return bottom;
}

/// The middle of a row meets the very edge of a surface; rounding puts its depth a little to either side.
TEST(FirstRowBelow, IsTheSameWhateverRoundingDoesToADepth) {
    const RayTables screen = pitched_screen(320, 200);
    const double depth = 10.5 / screen.row_rises[30] * screen.focal_y;
    for (const double part : {-1e-14, 0.0, 1e-14})
        EXPECT_EQ(first_row_below(screen, 10.5, depth * (1 + part), 0, 200), 31) << part;
}

TEST(FirstRowBelow, IsTheRowTheDefinitionNames) {
    const RayTables screen = pitched_screen(320, 200, 0.25);
    Random random(1);
    for (int trial = 0; trial < 20000; ++trial) {
        const double height = random.uniform(-8, 8), depth = random.uniform(0, 40);
        const int top = static_cast<int>(random.below(200)), bottom = top + static_cast<int>(random.below(201 - top));
        ASSERT_EQ(first_row_below(screen, height, depth, top, bottom),
                  first_row_below_by_search(screen, height, depth, top, bottom))
            << "trial " << trial;
    }
}

// hard case R13
TEST(FirstRowBelow, GivesRowCentresOnTheEdgeToTheSurfaceBelowIt) {
    const RayTables screen =
        pitched_screen(320, 200);  // focal_y 160, horizon 100: the centre of row 19 is 80.5 rows above it
    EXPECT_EQ(first_row_below(screen, 80.5 / 160, 1, 0, 200), 20);
    EXPECT_EQ(first_row_below(screen, 80.5 / 160 + 1e-12, 1, 0, 200), 19);
}

// The definition says which of two rows shows an edge also where a product meets it to the last bit.
TEST(FirstRowBelow, IsBehindTheRowThatMeetsTheHeightToTheLastBit) {
    const RayTables screen = pitched_screen(256, 200);  // focal_y 128
    for (const int y : {3, 30, 99, 100, 150}) {
        const double height = screen.tied_rises[static_cast<std::size_t>(y)] / 128;
        EXPECT_EQ(first_row_below(screen, height, 1, 0, 200), y + 1);
        EXPECT_EQ(first_row_below(screen, 4 * height, 4, 0, 200), y + 1);
    }
}

TEST(FirstRowBelow, PutsAnEyeInTheWallsPlaneBetweenItsHeights) {
    const RayTables screen = pitched_screen(320, 200);
    EXPECT_EQ(first_row_below(screen, 1.0, 0, 10, 90), 10);    // the ceiling is above the eye: no row shows it
    EXPECT_EQ(first_row_below(screen, -1.0, 0, 10, 90), 90);   // the floor is below: no row shows it
    EXPECT_EQ(first_row_below(screen, 0.0, 0, 10, 190), 100);  // at the very height: from the horizon on
}

// hard case R7
TEST(FirstRowBelow, DividesTheRowsOfAnEyeAtAHeightOfTheWallItStandsInAtTheHorizon) {
    const RayTables screen = pitched_screen(320, 200);
    EXPECT_EQ(first_row_below(screen, 0.0, 0, 10, 190), 100);
}

TEST(SplitRows, CoversTheOpenRowsInOrderForAnyHeights) {
    const RayTables screen = pitched_screen(200, 160, -0.5);
    Random random(7);
    for (int trial = 0; trial < 20000; ++trial) {
        const double floor = random.uniform(-4, 1), behind_floor = random.uniform(-4, 4);
        const RelativeHeights here{floor, floor + random.uniform(0, 5)};
        const RelativeHeights behind{behind_floor, behind_floor + random.uniform(0, 5)};
        const int top = static_cast<int>(random.below(160)), bottom = top + static_cast<int>(random.below(161 - top));
        const RowSplit rows = split_rows(RowsAt(screen, random.uniform(0, 20)), {top, bottom}, here, &behind);
        ASSERT_LE(top, rows.wall_top);
        ASSERT_LE(rows.wall_top, rows.opening_top);
        ASSERT_LE(rows.opening_top, rows.opening_bottom);
        ASSERT_LE(rows.opening_bottom, rows.wall_bottom);
        ASSERT_LE(rows.wall_bottom, bottom);
    }
}

// hard case R18
TEST(SplitRows, GivesAClosedDoorNoOpening) {
    const RayTables screen = pitched_screen(320, 200);
    const RelativeHeights here{-1.5, 1.5}, door{-1.5, -1.5};
    const RowSplit rows = split_rows(RowsAt(screen, 3), {0, 200}, here, &door);
    EXPECT_EQ(rows.opening_top, rows.opening_bottom);
    EXPECT_EQ(rows.wall_top, 20);
    EXPECT_EQ(rows.opening_top, rows.wall_bottom);
}

}  // namespace
}  // namespace enfilade::column
