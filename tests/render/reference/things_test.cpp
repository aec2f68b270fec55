// Things as the reference renderer shows them: where their pictures are on the screen, and what hides them.
#include <gtest/gtest.h>

#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

/// A thing 2 m wide and high, at full light, whose picture's left half is texels 0 to 31.
ThingRecord thing_at(Vec2 position) {
    ThingRecord thing;
    thing.position = position;
    thing.light = 1;
    thing.frames = {{"tree", 0, Vec2{32, 64}}};
    return thing;
}

MapFile room_with(const ThingRecord& thing) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 4)});
    file.things = {thing};
    return file;
}

// fov 90 and 64 columns: at 4 m depth a metre is 8 pixels. The thing's foot is 1 m below the eye.
TEST(ThingSeen, IsWhereTheProjectionPutsIt) {
    const Rooms rooms(room_with(thing_at({6, 4})));
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0));
    const PixelSurface thing = thing_id(rooms.map, ThingId(0u));
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(picture.id(x, y) == thing, x >= 24 && x < 40 && y >= 16 && y < 32) << x << " " << y;
}

TEST(ThingSeen, IsAsDeepAsItsPlace) {
    const Rooms rooms(room_with(thing_at({6, 4})));
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0));
    EXPECT_EQ(picture.depth(24, 20), 4);
    EXPECT_EQ(picture.depth(39, 20), 4);
}

TEST(ThingSeen, ShowsItsPicturesLeftOnTheLeft) {
    const Rooms rooms(room_with(thing_at({6, 4})));
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0));
    EXPECT_DOUBLE_EQ(picture.texel(24, 16).u, 0.5 / 16);
    EXPECT_DOUBLE_EQ(picture.texel(24, 16).v, 0.5 / 16);
    EXPECT_DOUBLE_EQ(picture.texel(39, 31).u, 15.5 / 16);
}

TEST(ThingSeen, InAMirrorIsMirrored) {
    MapFile file = room_with(thing_at({6, 6}));
    wall(file, "room", {8, 0}, {8, 8}).mirror = true;
    const Rooms rooms(file);
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0), 256, 192);
    const PixelSurface thing = thing_id(rooms.map, ThingId(0u));
    // Its image stands at (10, 6), 8 m ahead and 2 m to the right: columns 144 to 176 of those 16 a metre.
    EXPECT_EQ(picture.id(144, 96), thing);
    EXPECT_NE(picture.id(143, 96), thing);
    EXPECT_DOUBLE_EQ(picture.texel(144, 96).u, 1 - 0.5 / 32);
}

TEST(ThingSeen, IsHiddenBelowTheFloor) {
    ThingRecord sunk = thing_at({6, 4});
    sunk.z = -1;
    const Rooms rooms(room_with(sunk));
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0));
    EXPECT_EQ(picture.id(32, 31), thing_id(rooms.map, ThingId(0u)));
    EXPECT_EQ(picture.id(32, 32), floor_id(SectorId(0u)));
}

TEST(ThingSeen, IsHiddenAboveTheCeiling) {
    ThingRecord tall = thing_at({6, 4});
    tall.z = 3;
    const Rooms rooms(room_with(tall));
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 3, 0));
    EXPECT_EQ(picture.id(32, 16), thing_id(rooms.map, ThingId(0u)));
    EXPECT_EQ(picture.id(32, 15), ceiling_id(SectorId(0u)));
}

/// How many pixels show the thing.
int pixels_of_thing(const Rooms& rooms, const Picture& picture) {
    int count = 0;
    for (PixelSurface id : picture.facts.ids) count += id == thing_id(rooms.map, ThingId(0u));
    return count;
}

// The union of both halves is the whole thing: nothing is cut away at the doorway, nothing is there twice.
TEST(ThingSeen, InADoorwayIsWhole) {
    const Rooms whole(room_with(thing_at({4, 4})));
    MapFile file = map_of({box_room("near", 0, 0, 4, 8, 0, 4), box_room("far", 4, 0, 8, 8, 0, 4)});
    join_all(file);
    file.things = {thing_at({4, 4})};
    const Rooms halves(file);
    for (double yaw : {-20.0, 0.0, 7.0, 30.0}) {
        const View view = look_from(whole.map, {1, 4}, 1, yaw);
        const Picture expected = whole.look(view);
        const View cut = look_from(halves.map, {1, 4}, 1, yaw);
        EXPECT_EQ(pixels_of_thing(halves, halves.look(cut)), pixels_of_thing(whole, expected)) << yaw;
    }
}

// A thing on the line x = 0 is in the room to the right of it.
TEST(ThingSeen, InALinkedDoorwayIsWholeWhateverTheLinksAngle) {
    MapFile plain = map_of({box_room("near", 0, 0, 4, 5, 0, 4), box_room("far", -5, 0, 0, 5, 0, 4)});
    join_all(plain);
    plain.things = {thing_at({0, 2.5})};
    MapFile linked = plain;  // the far room turned by the angle of a 3-4-5 triangle
    sector(linked, "far") = room("far", {{100, 0}, {104, 3}, {101, 7}, {97, 4}}, 0, 4);
    link(linked, "near", {0, 5}, {0, 0}, "far", {97, 4}, {100, 0});
    const Rooms whole(plain), halves(linked);
    for (double yaw : {160.0, 180.0, 187.0, 210.0})
        EXPECT_EQ(pixels_of_thing(halves, halves.look(look_from(halves.map, {3, 2.5}, 1, yaw))),
                  pixels_of_thing(whole, whole.look(look_from(whole.map, {3, 2.5}, 1, yaw))))
            << yaw;
}

TEST(ThingSeen, BehindAStepShowsWhatRisesAboveIt) {
    MapFile file = map_of(
        {box_room("low", 0, 0, 4, 8, 0, 4), box_room("high", 4, 0, 5, 8, 1, 4), box_room("pit", 5, 0, 8, 8, 0, 4)});
    join_all(file);
    file.things = {thing_at({6, 4})};
    const Rooms rooms(file);
    const Picture picture = rooms.look(look_from(rooms.map, {2, 4}, 1, 0));
    EXPECT_EQ(picture.id(32, 23), thing_id(rooms.map, ThingId(0u)));  // the eye is as high as the step
    EXPECT_NE(picture.id(32, 24), thing_id(rooms.map, ThingId(0u)));
}

}  // namespace
}  // namespace enfilade::test
