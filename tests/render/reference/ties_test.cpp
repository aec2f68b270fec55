// The reference renderer where numbers coincide: one answer, the same on both sides.
#include <gtest/gtest.h>

#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

/// Two rooms of 4 m x 4 m in a row along x, both 0 to 2 m high.
MapFile two_like_rooms() {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 4, 0, 8, 4)});
    join_all(file);
    return file;
}

bool is_of_a_sector(PixelSurface id, bool (*test)(PixelSurface)) { return id >= 1 && id <= 4 && test(id); }
bool is_floor(PixelSurface id) {
    return is_of_a_sector(id, [](PixelSurface i) { return i % 2 == 1; });
}
bool is_ceiling(PixelSurface id) {
    return is_of_a_sector(id, [](PixelSurface i) { return i % 2 == 0; });
}

/// An eye on the line between the rooms and at the height of their floor or ceiling, looking every way. Odd sizes have
/// a ray exactly along the look and a row exactly on the horizon.
class EyeOnALine : public testing::TestWithParam<int> {
protected:
    static constexpr int kWidth = 65, kHeight = 47, kHorizon = kHeight / 2;

    Picture look(double eye_z) const {
        const Rooms rooms(two_like_rooms());
        return rooms.look(look_from(rooms.map, {4, 1.40625}, eye_z, GetParam()), kWidth, kHeight);
    }
};

// hard case R7
TEST_P(EyeOnALine, SeesOnlyFloorBelowTheHorizonWhenItLiesOnTheFloor) {
    const Picture picture = look(0);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) ASSERT_EQ(is_floor(picture.id(x, y)), y > kHorizon) << x << ", " << y;
}

// hard case R7
TEST_P(EyeOnALine, SeesOnlyCeilingFromTheHorizonUpWhenItTouchesTheCeiling) {
    const Picture picture = look(2);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) ASSERT_EQ(is_ceiling(picture.id(x, y)), y <= kHorizon) << x << ", " << y;
}

// hard case R7
TEST_P(EyeOnALine, SeesNoPixelOfNothing) {
    for (double eye_z : {0.0, 1.0, 2.0})
        for (PixelSurface id : look(eye_z).facts.ids) ASSERT_NE(id, kNothing);
}

TEST_P(EyeOnALine, KnowsADepthForEveryPixel) {
    for (double eye_z : {0.0, 1.0, 2.0})
        for (double depth : look(eye_z).facts.depths) ASSERT_TRUE(depth >= 0 && depth < 10) << depth;
}

INSTANTIATE_TEST_SUITE_P(Every15Degrees, EyeOnALine, testing::Range(0, 360, 15));

TEST(RayThroughVertices, GoesOnWhereTheEyeStandsOnALineAndLooksAlongIt) {
    const Rooms rooms(two_like_rooms());
    for (double yaw : {90.0, 270.0}) {
        const View view = look_from(rooms.map, {4, 2}, 1, yaw);
        const Picture picture = rooms.look(view, 65, 47);
        // Straight ahead, 2 m away, is the end wall of the room on that side of the line that the eye is in.
        const Vec2 a = yaw == 90 ? Vec2{8, 4} : Vec2{4, 0}, b = yaw == 90 ? Vec2{4, 4} : Vec2{8, 0};
        const WallId ahead = wall_between(rooms.map, view.sector, a, b);
        EXPECT_EQ(picture.id(32, 23), wall_id(rooms.map, ahead, WallPart::middle)) << "yaw " << yaw;
        EXPECT_EQ(picture.depth(32, 23), 2) << "yaw " << yaw;
    }
}

// hard case R8
TEST(WallSeenOnEdge, CoversNoColumn) {
    // Rooms in the shape of an L; of the wall from x = 4 to 8 at y = 2, an eye at (2, 2) sees the edge.
    const Rooms above(map_of({room("L", {{0, 0}, {8, 0}, {8, 2}, {4, 2}, {4, 4}, {0, 4}})}));
    const Rooms below(map_of({room("L", {{0, 0}, {4, 0}, {4, 2}, {8, 2}, {8, 4}, {0, 4}})}));
    const PixelSurface edge_above =
        wall_id(above.map, wall_between(above.map, SectorId(0u), {8, 2}, {4, 2}), WallPart::middle);
    const PixelSurface edge_below =
        wall_id(below.map, wall_between(below.map, SectorId(0u), {4, 2}, {8, 2}), WallPart::middle);
    for (PixelSurface id : above.look(look_from(above.map, {2, 2}, 1, 0), 65, 47).facts.ids) ASSERT_NE(id, edge_above);
    for (PixelSurface id : below.look(look_from(below.map, {2, 2}, 1, 0), 65, 47).facts.ids) ASSERT_NE(id, edge_below);
}

}  // namespace
}  // namespace enfilade::test
