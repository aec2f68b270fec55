// The reference renderer through linked portals and mirrors.
#include <gtest/gtest.h>

#include <cmath>

#include "render/reference/picture.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr double kLinkRounding = 1e-9;  ///< the eye is put onto a grid of 2^-32 behind each link [m]

/// A room and another behind it, to the west, as neighbours. An eye on the line between them is in the first room.
MapFile side_by_side(double far_floor) {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4, 0, 3), box_room("far", -4, 0, 0, 4, far_floor, far_floor + 2)});
    join_all(file);
    return file;
}

/// The same two rooms, the second turned by quarters, moved, and reached through a link.
MapFile far_apart(int quarters, Vec2 shift, double far_floor, double rise) {
    const auto moved = [&](Vec2 v) {
        for (int i = 0; i < quarters; ++i) v = right_of(v);
        return v + shift;
    };
    MapFile file = map_of(
        {box_room("near", 0, 0, 4, 4, 0, 3), room("far", {moved({-4, 0}), moved({0, 0}), moved({0, 4}), moved({-4, 4})},
                                                  far_floor + rise, far_floor + rise + 2)});
    link(file, "near", {0, 4}, {0, 0}, "far", moved({0, 0}), moved({0, 4}));
    wall(file, "near", {0, 4}, {0, 0}).rise = rise;
    return file;
}

void expect_same_ids_and_depths(const Picture& a, const Picture& b) {
    for (std::size_t i = 0; i < a.facts.ids.size(); ++i) {
        ASSERT_EQ(a.facts.ids[i], b.facts.ids[i]) << "pixel " << i;
        ASSERT_NEAR(a.facts.depths[i], b.facts.depths[i], kLinkRounding) << "pixel " << i;
    }
}

TEST(LookThroughPixel, FindsWhatTheWholePictureShowsThere) {
    const Rooms rooms(far_apart(1, {100, -50}, 0.5, 7.25));
    View view = look_from(rooms.map, {1.3, 1.7}, 1.4, 170);
    const Snapshot snapshot = at_rest(rooms.map);
    for (const bool tilted : {false, true}) {
        if (tilted) view.tilt = Tilt{direction(Angle::from_degrees(-20)), direction(Angle::from_degrees(5))};
        const Picture picture = rooms.look(view, 32, 24);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x) {
                const PixelFacts facts = look_through_pixel(rooms.map, rooms.textures, snapshot, view, 32, 24, x, y);
                ASSERT_EQ(facts.id, picture.id(x, y));
                ASSERT_EQ(facts.depth, picture.depth(x, y));
                ASSERT_EQ(facts.texel.u, picture.texel(x, y).u);
                ASSERT_EQ(facts.texel.v, picture.texel(x, y).v);
            }
    }
}

class LinkedPortal : public testing::TestWithParam<int> {};

// hard case I10
TEST_P(LinkedPortal, ShowsARoomThatWasMovedAwayAsIfItWereBehindTheDoor) {
    const Rooms near(side_by_side(0.5)), apart(far_apart(GetParam(), {100, -50}, 0.5, 0));
    for (double yaw : {140.0, 180.0, 193.0, 250.0}) {
        const View view = look_from(near.map, {1.3, 1.7}, 1.4, yaw);
        expect_same_ids_and_depths(near.look(view), apart.look(view));
    }
}

TEST_P(LinkedPortal, ShowsARoomThatWasRaisedAsIfItWereNot) {
    const Rooms near(side_by_side(0.5)), apart(far_apart(GetParam(), {100, -50}, 0.5, 7.25));
    const View view = look_from(near.map, {1.3, 1.7}, 1.4, 185);
    expect_same_ids_and_depths(near.look(view), apart.look(view));
}

// hard case R4
TEST_P(LinkedPortal, IsLookedThroughFromItsVeryLine) {
    const Rooms near(side_by_side(0.5)), apart(far_apart(GetParam(), {100, -50}, 0.5, 0));
    for (double yaw : {140.0, 180.0, 193.0, 250.0}) {
        const View view = look_from(near.map, {0, 1.7}, 1.4, yaw);
        expect_same_ids_and_depths(near.look(view), apart.look(view));
    }
}

INSTANTIATE_TEST_SUITE_P(Quarters, LinkedPortal, testing::Range(0, 4));

/// A room whose wall at x = 0 is a mirror, and the room twice as long that one believes to see in it.
class Mirror : public testing::Test {
protected:
    static MapFile with_mirror() {
        MapFile file = map_of({box_room("room", 0, 0, 4, 4, 0, 3)});
        wall(file, "room", {0, 4}, {0, 0}).mirror = true;
        return file;
    }
    const Rooms mirrored_{with_mirror()};
    const Rooms doubled_{map_of({box_room("room", -4, 0, 4, 4, 0, 3)})};
    const View view_ = look_from(mirrored_.map, {1.3, 1.7}, 1.4, 200);
};

TEST_F(Mirror, ShowsEverythingAsFarAwayAsInARoomTwiceAsLong) {
    const Picture in_mirror = mirrored_.look(view_), in_room = doubled_.look(view_);
    for (std::size_t i = 0; i < in_mirror.facts.depths.size(); ++i)
        ASSERT_NEAR(in_mirror.facts.depths[i], in_room.facts.depths[i], kLinkRounding) << "pixel " << i;
}

TEST_F(Mirror, ShowsTheWallBehindTheEyeStraightAhead) {
    const WallId behind = wall_between(mirrored_.map, SectorId(0u), {4, 0}, {4, 4});
    const View view = look_from(mirrored_.map, {1.3, 1.7}, 1.4, 180);
    EXPECT_EQ(mirrored_.look(view).id(32, 24), wall_id(mirrored_.map, behind, WallPart::middle));
}

// hard case R28
TEST_F(Mirror, SwapsLeftAndRightOfWhatItShows) {
    const View view = look_from(mirrored_.map, {1.3, 1.7}, 1.4, 180);
    const Picture picture = mirrored_.look(view);
    // Looking west, right is north: a little right of the middle one sees a little less than y = 1.7, in a mirror that
    // faces east as well as in the plain view. The wall behind runs from y = 0 to y = 4.
    const double depth = 1.3 + 4, slope = 1 / 64.0;
    EXPECT_NEAR(picture.texel(32, 24).u, 1.7 - slope * depth - 1, 1e-6);  // a float's precision
}

// hard case R4
TEST_F(Mirror, IsLookedIntoFromItsVeryPlane) {
    const View view = look_from(mirrored_.map, {0, 1.7}, 1.4, 200);
    const Picture in_mirror = mirrored_.look(view), in_room = doubled_.look(view);
    for (std::size_t i = 0; i < in_mirror.facts.depths.size(); ++i)
        ASSERT_NEAR(in_mirror.facts.depths[i], in_room.facts.depths[i], kLinkRounding) << "pixel " << i;
}

/// Two mirrors that face each other.
// hard case R23
TEST(ChainOfLinks, EndsInTheRecursionColorAtTheLargestDepth) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4, 0, 3)});
    wall(file, "room", {4, 0}, {4, 4}).mirror = true;
    wall(file, "room", {0, 4}, {0, 0}).mirror = true;
    file.render.max_depth = 5;
    file.render.recursion_color = 0x123456;
    const Rooms rooms(file);
    const Picture picture = rooms.look(look_from(rooms.map, {1.25, 2.03}, 1.4, 0));
    EXPECT_EQ(picture.id(32, 24), kRecursionEnd);
    EXPECT_EQ(picture.frame.pixels[picture.at(32, 24)], 0xFF563412u);
    EXPECT_NEAR(picture.depth(32, 24), 2.75 + 5 * 4, kLinkRounding);  // five mirrors were looked into, the sixth not
}

TEST(ChainOfLinks, OfNoLengthShowsNothingBehindALink) {
    MapFile file = far_apart(0, {100, 0}, 0, 0);
    file.render.max_depth = 0;
    const Rooms rooms(file);
    EXPECT_EQ(rooms.look(look_from(rooms.map, {1.3, 1.7}, 1.4, 180)).id(32, 24), kRecursionEnd);
}

}  // namespace
}  // namespace enfilade::test
