// The reference renderer at doorways: steps, doors, skies, and lines that are not there to be seen.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/reference/picture.h"
#include "render/shade.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr double kRounding = 1e-12;  ///< of sums and products of a few numbers below 100 [m]

/// Two rooms of 4 m x 4 m in a row along x, the first from 0 to 3 m high.
MapFile two_rooms(double second_floor, double second_ceiling) {
    MapFile file =
        map_of({box_room("near", 0, 0, 4, 4, 0, 3), box_room("far", 4, 0, 8, 4, second_floor, second_ceiling)});
    join_all(file);
    return file;
}

/// Seen from the middle of the first room towards the second, with the doorway 2 m and the last wall 6 m ahead.
class Doorway : public testing::Test {
protected:
    static constexpr int kWidth = 64, kHeight = 96;
    static constexpr int kMiddle = kWidth / 2;  ///< a column that sees straight through
    static constexpr double kEyeZ = 1.5, kDoorDepth = 2, kLastDepth = 6;

    static Picture look(const Rooms& rooms) {
        return rooms.look(look_from(rooms.map, {2, 2.015625}, kEyeZ, 0), kWidth, kHeight);
    }
    static double climb(int y) { return (kHeight / 2.0 - y - 0.5) / (kWidth / 2.0); }
    static double height(int y, double depth) { return kEyeZ + climb(y) * depth; }
    static PixelSurface step(const Rooms& rooms, WallPart part) {
        return wall_id(rooms.map, wall_between(rooms.map, SectorId(0u), {4, 0}, {4, 4}), part);
    }
    static PixelSurface last_wall(const Rooms& rooms) {
        return wall_id(rooms.map, wall_between(rooms.map, SectorId(1u), {8, 0}, {8, 4}), WallPart::middle);
    }
};

TEST_F(Doorway, ShowsBothStepsAndTheRoomBetweenThem) {
    const Rooms rooms(two_rooms(1, 2));
    const Picture picture = look(rooms);
    for (int y = 0; y < kHeight; ++y) {
        const double at_door = height(y, kDoorDepth), at_end = height(y, kLastDepth);
        const PixelSurface expected = at_door >= 3   ? ceiling_id(SectorId(0u))
                                      : at_door < 0  ? floor_id(SectorId(0u))
                                      : at_door >= 2 ? step(rooms, WallPart::upper)
                                      : at_door < 1  ? step(rooms, WallPart::lower)
                                      : at_end >= 2  ? ceiling_id(SectorId(1u))
                                      : at_end < 1   ? floor_id(SectorId(1u))
                                                     : last_wall(rooms);
        ASSERT_EQ(picture.id(kMiddle, y), expected) << y;
    }
}

TEST_F(Doorway, LetsAPictureRunThroughItsPlace) {
    MapFile file = two_rooms(0, 3);
    WallRecord& door = wall(file, "near", {4, 0}, {4, 4});
    door.middle = spec("fall");
    door.middle->tile_m = {1, 3};
    door.scroll = {0, -1.25};
    const Rooms rooms(file);
    const Picture picture = rooms.look_at(1, look_from(rooms.map, {2, 2.015625}, kEyeZ, 0), kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        const double at_door = height(y, kDoorDepth);
        if (at_door <= 0 || at_door >= 3) continue;
        ASSERT_EQ(picture.id(kMiddle, y), step(rooms, WallPart::middle)) << y;
    }
}

TEST_F(Doorway, StandsTheLowerStepOnItsTopEdgeAndHangsTheUpperFromTheOpening) {
    const Rooms rooms(two_rooms(1, 2));
    const Picture picture = look(rooms);
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (picture.id(kMiddle, y) == step(rooms, WallPart::lower)) {
            ASSERT_NEAR(picture.texel(kMiddle, y).v, fraction(1 - h), kRounding) << y;
        }
        if (picture.id(kMiddle, y) == step(rooms, WallPart::upper)) {
            ASSERT_NEAR(picture.texel(kMiddle, y).v, fraction(2 - h), kRounding) << y;
        }
    }
}

// hard case W3
TEST_F(Doorway, SeesTheCeilingBeyondOverAnOpenStepAsIfItWentOn) {
    MapFile file = two_rooms(0, 2);
    wall(file, "near", {4, 0}, {4, 4}).upper = spec("-");
    const Picture picture = look(Rooms(file));
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (h < 2 || h >= 3) continue;
        ASSERT_EQ(picture.id(kMiddle, y), ceiling_id(SectorId(1u))) << y;
        ASSERT_NEAR(picture.depth(kMiddle, y), (2 - kEyeZ) / climb(y), kRounding) << y;  // nearer than the doorway
    }
}

// hard case W3
TEST_F(Doorway, SeesTheFloorBeyondUnderAnOpenStepAsIfItWentOn) {
    MapFile file = two_rooms(1, 3);
    wall(file, "near", {4, 0}, {4, 4}).lower = spec("-");
    const Picture picture = look(Rooms(file));
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (h < 0 || h >= 1) continue;
        ASSERT_EQ(picture.id(kMiddle, y), floor_id(SectorId(1u))) << y;
        ASSERT_NEAR(picture.depth(kMiddle, y), (1 - kEyeZ) / climb(y), kRounding) << y;
    }
}

// hard case W4
TEST_F(Doorway, ShowsNoStepBetweenTwoSkies) {
    MapFile file = two_rooms(0, 2);
    for (SectorRecord& s : file.sectors) s.ceiling.parallax = true;
    const Picture picture = look(Rooms(file));
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (h < 2 || h >= 3) continue;
        ASSERT_EQ(picture.id(kMiddle, y), ceiling_id(SectorId(1u))) << y;
        ASSERT_EQ(picture.depth(kMiddle, y), std::numeric_limits<double>::infinity()) << y;
    }
}

// hard case W4
TEST_F(Doorway, ShowsTheStepBetweenASkyAndACeiling) {
    MapFile file = two_rooms(0, 2);
    file.sectors[0].ceiling.parallax = true;
    const Rooms rooms(file);
    const Picture picture = look(rooms);
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (h >= 2 && h < 3) {
            ASSERT_EQ(picture.id(kMiddle, y), step(rooms, WallPart::upper)) << y;
        }
    }
}

// hard case R18
TEST_F(Doorway, ShowsAClosedDoorAsItsTwoSteps) {
    const Rooms rooms(two_rooms(1, 1));
    const Picture picture = look(rooms);
    for (int y = 0; y < kHeight; ++y) {
        const double h = height(y, kDoorDepth);
        if (h < 0 || h >= 3) continue;
        ASSERT_EQ(picture.id(kMiddle, y), step(rooms, h >= 1 ? WallPart::upper : WallPart::lower)) << y;
    }
}

// hard case R18
TEST_F(Doorway, SeesNothingOfARoomWithoutHeightFromInsideButItsFlats) {
    const Rooms rooms(two_rooms(1, 1));
    const Picture picture = rooms.look(look_from(rooms.map, {6, 2.015625}, 1, 0), kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        ASSERT_EQ(picture.id(kMiddle, y), y < kHeight / 2 ? ceiling_id(SectorId(1u)) : floor_id(SectorId(1u))) << y;
}

TEST_F(Doorway, ShowsTheSkyInItsDirectionWhereverTheEyeIs) {
    MapFile file = two_rooms(0, 2);
    for (SectorRecord& s : file.sectors) {
        s.ceiling.z = 2;
        s.ceiling.texture = spec("sky");
        s.ceiling.texture->tile_m = Vec2{4, 1.5};
        s.ceiling.parallax = true;
    }
    const Rooms rooms(file);
    const Picture here = rooms.look(look_from(rooms.map, {1.25, 1}, 1, 20), kWidth, kHeight);
    const Picture there = rooms.look(look_from(rooms.map, {2.75, 3}, 0.5, 20), kWidth, kHeight);
    int both = 0;
    for (std::size_t i = 0; i < here.facts.ids.size(); ++i) {
        if (std::isfinite(here.facts.depths[i]) || std::isfinite(there.facts.depths[i])) continue;
        ASSERT_EQ(here.frame.pixels[i], there.frame.pixels[i]);
        ++both;
    }
    EXPECT_GT(both, kWidth * kHeight / 8);
}

/// The same floor plan with and without lines that lead from a room into an equal one. Texture tiles are 1 m, so those
/// of walls that were cut at whole metres go on as if nothing had happened.
class InvisibleLine : public testing::Test {
protected:
    /// All four parts meet in one vertex, which lies off every lattice of texels.
    static constexpr Vec2 kCross{4 + 307 / 1024.0, 3 + 211 / 1024.0};

    static MapFile whole() { return map_of({room("whole", {{0, 0}, {8, 0}, {8, 6}, {0, 6}}, 0, 3)}); }
    static MapFile cut() {
        const Vec2 c = kCross;
        MapFile file =
            map_of({room("a", {{0, 0}, {4, 0}, c, {0, 3}}, 0, 3), room("b", {{4, 0}, {8, 0}, {8, 3}, c}, 0, 3),
                    room("c", {c, {8, 3}, {8, 6}, {4, 6}}, 0, 3), room("d", {{0, 3}, c, {4, 6}, {0, 6}}, 0, 3)});
        join_all(file);
        return file;
    }

    static void expect_same_picture(Vec2 eye, double eye_z, double yaw_degrees, int width) {
        const Rooms one(whole()), four(cut());
        const Picture seamless = one.look(look_from(one.map, eye, eye_z, yaw_degrees), width, 48);
        const Picture cut_up = four.look(look_from(four.map, eye, eye_z, yaw_degrees), width, 48);
        EXPECT_EQ(seamless.frame.pixels, cut_up.frame.pixels) << eye.x << "," << eye.y << " yaw " << yaw_degrees;
        for (std::size_t i = 0; i < seamless.facts.depths.size(); ++i)
            ASSERT_NEAR(seamless.facts.depths[i], cut_up.facts.depths[i], kRounding);
    }
};

// hard case R20
TEST_F(InvisibleLine, ChangesNothingSeenFromAfar) {
    for (int yaw = 0; yaw < 360; yaw += 15) expect_same_picture({1.28, 2.17}, 1.61, yaw, 64);
}

// hard case R20
TEST_F(InvisibleLine, ChangesNothingSeenFromTheLineItself) {
    const Vec2 on_line = (Vec2{4, 0} + kCross) * 0.5;
    for (int yaw = 0; yaw < 360; yaw += 15) expect_same_picture(on_line, 1.61, yaw, 65);
}

// hard case R20
TEST_F(InvisibleLine, ChangesNothingSeenFromAVertexWhereFourRoomsMeet) {
    for (int yaw = 0; yaw < 360; yaw += 15) expect_same_picture(kCross, 1.61, yaw, 65);
}

}  // namespace
}  // namespace enfilade::test
