// The judge itself, where what it has to say can be worked out by hand.
#include "ties/exact_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hard_cases/scenes.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr std::uint32_t kNorth = 0, kEast = 1, kWest = 3;  // walls of box_room()

/// One room of 8 m x 6 m from (0, 0) on, 2 m high.
class ExactColumnInARoom : public testing::Test {
protected:
    PixelSurface seen(Vec2 eye, double eye_z, Vec2 forward, double rise, double slope = 0) const {
        View view;
        view.sector = SectorId(0u);
        view.eye = eye;
        view.eye_z = eye_z;
        view.forward = forward;
        ExactColumn column(map_, heights_, view, slope);
        return column.surface(rise, 32).value_or(kNothing);
    }
    PixelSurface wall(std::uint32_t number) const { return wall_id(map_, WallId(number), WallPart::middle); }

    Map map_ = built(map_of({box_room("room", 0, 0, 8, 6)}));
    std::vector<Heights> heights_{{0, 2}};
};

// The eye counts as a bit farther along x: 45 degrees to the right of x it meets x = 8 before y = 6.
TEST_F(ExactColumnInARoom, GoesBesideTheCornerThatItPointsTo) {
    EXPECT_EQ(seen({6, 4}, 1, {std::sqrt(0.5), std::sqrt(0.5)}, 0), wall(kEast));
    EXPECT_EQ(seen({6, 2}, 1, {1, 0}, 0, -1), wall(kEast));
    EXPECT_EQ(seen({2, 2}, 1, {-1, 0}, 0, 1), wall(kNorth));
}

// From (e, e^2) a ray along -x meets x = 0 at y = e^2; one that climbs the drawing by any real slope meets y = 0 first.
TEST_F(ExactColumnInARoom, StartsAnInfinitesimalInsideTheCornerThatTheEyeIsOn) {
    EXPECT_EQ(seen({0, 0}, 1, {-1, 0}, 0), wall(kWest));
    EXPECT_EQ(seen({0, 0}, 1, {-1, -0x1p-45}, 0), wall(kNorth));
    EXPECT_EQ(seen({0, 0}, 1, {-1, 0x1p-45}, 0), wall(kWest));
    EXPECT_EQ(seen({0, 0}, 1, {0, -1}, 0), wall(kNorth));
}

// 4 m ahead a ray of 8 rows above the horizon, of 32 a metre, is 1 m up: at the ceiling, which belongs to the ceiling.
TEST_F(ExactColumnInARoom, ReachesHeightsToTheLastBit) {
    EXPECT_EQ(seen({4, 3}, 1, {1, 0}, 8), ceiling_id(SectorId(0u)));
    EXPECT_EQ(seen({4, 3}, 1, {1, 0}, std::nextafter(8, 0)), wall(kEast));
    EXPECT_EQ(seen({4, 3}, 1, {1, 0}, -8), wall(kEast));
    EXPECT_EQ(seen({4, 3}, 1, {1, 0}, std::nextafter(-8, -9)), floor_id(SectorId(0u)));
}

// An eye on the wall's line meets it at once, whatever the row; only an eye at the very height sees what is above it.
TEST_F(ExactColumnInARoom, MeetsAWallThroughTheEyeAtOnce) {
    EXPECT_EQ(seen({4, 0}, 1, {0, -1}, 1e6), wall(kNorth));
    EXPECT_EQ(seen({4, 0}, 1, {0, -1}, -1e6), wall(kNorth));
    EXPECT_EQ(seen({4, 0}, 2, {0, -1}, 0), ceiling_id(SectorId(0u)));
    EXPECT_EQ(seen({4, 0}, 2, {0, -1}, -1e-9), wall(kNorth));
    EXPECT_EQ(seen({4, 0}, 2.5, {0, -1}, -1e6), ceiling_id(SectorId(0u)));
}

// Each look through the doors costs a link.
TEST(ExactColumnInAnEndlessHall, EndsAfterAsManyLinksAsMayBe) {
    const Map map = built(endless_hall());
    View view;
    view.sector = SectorId(0u);
    view.eye = {4, 3};
    view.eye_z = 1;
    const std::vector<Heights> heights{{0, 3}};
    ExactColumn column(map, heights, view, 0);
    EXPECT_EQ(column.surface(0, 32), kRecursionEnd);
    EXPECT_EQ(column.surface(-32 / 52.0 * (1 - 0x1p-30), 32), kRecursionEnd);  // floor 1 m below, 6 links: 52 m
    EXPECT_EQ(column.surface(-32 / 52.0 * (1 + 0x1p-30), 32), floor_id(SectorId(0u)));
}

}  // namespace
}  // namespace enfilade::test
