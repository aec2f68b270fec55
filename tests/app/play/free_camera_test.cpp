// An eye that flies.
#include "app/play/play_loop.h"

#include <gmock/gmock.h>

#include "math/vec.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using test::box_room;
using ::testing::HasSubstr;

Eye eye_at(Vec2 point, double yaw_degrees = 0) {
    return {{SectorId(0u), point}, 1, Angle::from_degrees(yaw_degrees), 0};
}

/// Flies for a second, straight on unless said otherwise.
void fly(FreeCamera& camera, const Map& map, TickInput input = {127, 0, 0, 0, 0}, int ticks = 60) {
    for (int i = 0; i < ticks; ++i) camera.move(map, input, kTickSeconds);
}

TEST(FreeCamera, FliesTheWayItLooks) {
    const Map map = test::built(test::map_of({box_room("room", 0, 0, 40, 40, 0, 20)}));
    FreeCamera camera(eye_at({2, 20}));
    fly(camera, map);
    EXPECT_NEAR(camera.eye().place.point.x, 7, 1e-6);
    EXPECT_EQ(camera.eye().z, 1);
    camera.move(map, {0, 0, 0, static_cast<std::int32_t>(Angle::from_degrees(30).steps), 0}, kTickSeconds);
    fly(camera, map);
    EXPECT_NEAR(camera.eye().place.point.x, 7 + 5 * 0.8660254, 1e-6);
    EXPECT_NEAR(camera.eye().z, 3.5, 1e-6);
    fly(camera, map, {0, 127, 0, 0, kButtonRun});
    EXPECT_NEAR(camera.eye().place.point.y, 40, 1e-6) << "to the right, four times as fast";
    fly(camera, map, {0, 0, 0, 0, kButtonUse});
    EXPECT_NEAR(camera.eye().z, 8.5, 1e-6);
    fly(camera, map, {0, 0, 0, 0, kButtonCrouch});
    EXPECT_NEAR(camera.eye().z, 3.5, 1e-6);
}

TEST(FreeCamera, FollowsLinks) {
    MapFile file = test::map_of({box_room("main", 0, 0, 4, 4), box_room("far", 100, 50, 104, 54, 7, 9)});
    test::link(file, "main", {4, 0}, {4, 4}, "far", {104, 50}, {104, 54});
    const Map map = test::built(file);
    FreeCamera camera(eye_at({2, 1}));
    fly(camera, map);
    EXPECT_EQ(camera.eye().place.sector, SectorId(1u));
    EXPECT_NEAR(camera.eye().place.point.x, 101, 1e-6);
    EXPECT_NEAR(camera.eye().z, 8, 1e-6);
    EXPECT_EQ(camera.eye().yaw, Angle::from_degrees(180));
}

TEST(FreeCamera, FliesThroughWallsIntoTheRoomBehindAndOutOfAllRooms) {
    const Map map = test::built(test::map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4)}));
    const Snapshot snapshot = at_rest(map);
    FreeCamera camera(eye_at({2, 1}));
    fly(camera, map);
    EXPECT_EQ(camera.eye().place.sector, SectorId(1u));
    EXPECT_THAT(camera.text(map, snapshot), HasSubstr("in 'right', x 7.00 y 1.00"));
    fly(camera, map);
    EXPECT_EQ(camera.whereabouts(snapshot), Whereabouts::outside);
    EXPECT_THAT(camera.text(map, snapshot), HasSubstr("outside all rooms, x 12.00"));
    EXPECT_EQ(camera.eye().place.sector, SectorId(1u)) << "the last room";
    fly(camera, map, {-127, 0, 0, 0, 0}, 120);
    EXPECT_EQ(camera.whereabouts(snapshot), Whereabouts::in_room);
    EXPECT_EQ(camera.eye().place.sector, SectorId(0u));
}

TEST(FreeCamera, TellsWhenItIsAboveACeilingOrBelowAFloor) {
    const Map map = test::built(test::map_of({box_room("room", 0, 0, 4, 4)}));
    const Snapshot snapshot = at_rest(map);
    FreeCamera camera(eye_at({2, 1}));
    fly(camera, map, {0, 0, 0, 0, kButtonUse});
    EXPECT_EQ(camera.whereabouts(snapshot), Whereabouts::above_ceiling);
    EXPECT_THAT(camera.text(map, snapshot), HasSubstr("above the ceiling of 'room'"));
    fly(camera, map, {0, 0, 0, 0, kButtonCrouch}, 120);
    EXPECT_EQ(camera.whereabouts(snapshot), Whereabouts::below_floor);
    EXPECT_THAT(camera.text(map, snapshot), HasSubstr("below the floor of 'room'"));
}

TEST(FreeCamera, StaysInTheWorld) {
    const Map map = test::built(test::map_of({box_room("room", 0, 0, 4, 4)}));
    FreeCamera camera(eye_at({2, 1}));
    fly(camera, map, {127, 0, 0, 0, kButtonRun | kButtonUse}, 120000);
    EXPECT_EQ(camera.eye().place.point.x, kWorldLimit);
    EXPECT_EQ(camera.eye().z, kWorldLimit);
}

}  // namespace
}  // namespace enfilade
