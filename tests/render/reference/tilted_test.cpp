// True pitch and roll by the reference.
#include <gtest/gtest.h>

#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

/// Two rooms, a figure between them, and a mirror.
MapFile rooms() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 3), box_room("attic", 8, 2, 12, 6, 0.5, 2.5)});
    split_and_join(file);
    wall(file, "hall", {0, 8}, {0, 0}).mirror = true;
    ThingRecord thing;
    thing.position = {6, 4};
    thing.sector = "hall";
    thing.frames = {{"figure", 0, Vec2{32, 64}}};
    file.things = {thing};
    return file;
}

Tilt tilt_of(double pitch_degrees, double roll_degrees) {
    return {direction(Angle::from_degrees(pitch_degrees)), direction(Angle::from_degrees(roll_degrees))};
}

View view_of(const Rooms& rooms, double pitch_degrees, double roll_degrees, double yaw_degrees = 20) {
    View view = look_from(rooms.map, {3, 4}, 1.5, yaw_degrees);
    view.tilt = tilt_of(pitch_degrees, roll_degrees);
    return view;
}

TEST(ReferenceTilt, ByNothingKeepsEveryBit) {
    const Rooms place(rooms());
    for (const double yaw : {20.0, 160.0}) {
        View view = view_of(place, 0, 0, yaw);
        const Picture tilted = place.look(view);
        view.tilt.reset();
        const Picture upright = place.look(view);
        EXPECT_EQ(tilted.frame.pixels, upright.frame.pixels);
        EXPECT_EQ(tilted.facts.ids, upright.facts.ids);
        EXPECT_EQ(tilted.facts.depths, upright.facts.depths);
    }
}

TEST(ReferenceTilt, ShowsTheFloorStraightBelow) {
    const Rooms place(rooms());
    const Picture picture = place.look(view_of(place, -90, 0), 65, 65);
    EXPECT_EQ(picture.id(32, 32), floor_id(sector_named(place.map, "hall")));
    EXPECT_NEAR(picture.depth(32, 32), 1.5, 1e-9);
    EXPECT_NEAR(picture.depth(0, 64), 1.5, 1e-9);  // along the line of sight all of the floor is as far away
}

TEST(ReferenceTilt, ShowsTheCeilingBelowAHeadThatIsUpsideDown) {
    const Rooms place(rooms());
    const Picture picture = place.look(view_of(place, 0, 180), 65, 65);
    EXPECT_EQ(picture.id(32, 60), ceiling_id(sector_named(place.map, "hall")));
}

/// Looking back over its head, an eye sees what is behind it upside down.
TEST(ReferenceTilt, ShowsTheFigureBehindAnEyeThatLooksBackPastItsFeet) {
    const Rooms place(rooms());
    View view = look_from(place.map, {7, 4}, 1.5, 0);  // the figure is a metre behind
    view.tilt = tilt_of(-89, 0);
    view.fov_degrees = 150;
    const Picture picture = place.look(view, 65, 65);
    EXPECT_EQ(picture.id(32, 60), thing_id(place.map, ThingId(0u)));
}

TEST(ReferenceTilt, MovesNothingThatARollDoesNot) {
    const Rooms place(rooms());
    const Picture level = place.look(view_of(place, 10, 0), 33, 33),
                  rolled = place.look(view_of(place, 10, 180), 33, 33);
    std::size_t differ = 0;
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) differ += level.id(x, y) != rolled.id(32 - x, 32 - y);
    EXPECT_EQ(differ, 0u);
}

}  // namespace
}  // namespace enfilade::test
