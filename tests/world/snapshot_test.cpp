// Things at an instant: where they stand, and which picture of their animation they show.
#include "world/snapshot.h"

#include <gtest/gtest.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

/// Frames of 0.25, 0.5 and 0.25 s.
ThingRecord torch() {
    ThingRecord thing;
    thing.position = {1, 1};
    thing.frames = {{"a", 0.25, {}}, {"b", 0.5, {}}, {"c", 0.25, {}}};
    return thing;
}

Map room_with(const ThingRecord& thing) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4, 1, 4)});
    file.sectors[0].light = 0.5;
    file.things = {thing};
    return built(file);
}

std::size_t frame_of_torch(double time_s) { return frame_at(room_with(torch()).sprites[0], time_s); }

TEST(Animation, ShowsEachFrameForItsTime) {
    EXPECT_EQ(frame_of_torch(0), 0u);
    EXPECT_EQ(frame_of_torch(0.24), 0u);
    EXPECT_EQ(frame_of_torch(0.25), 1u);
    EXPECT_EQ(frame_of_torch(0.74), 1u);
    EXPECT_EQ(frame_of_torch(0.75), 2u);
}

TEST(Animation, StartsAnew) {
    EXPECT_EQ(frame_of_torch(1), 0u);
    EXPECT_EQ(frame_of_torch(1.25), 1u);
}

// hard case C24
TEST(Animation, IsAsExactAfterAYear) {
    constexpr double kYear = 31'536'000;  // [s]
    EXPECT_EQ(frame_of_torch(kYear + 0.75), 2u);
    EXPECT_EQ(frame_of_torch(kYear + 1), 0u);
}

TEST(Animation, BeforeTheStartShowsTheFirstFrame) { EXPECT_EQ(frame_of_torch(-3), 0u); }

TEST(Animation, StopsAtAFrameThatStays) {
    ThingRecord gate = torch();
    gate.frames[1].seconds = 0;
    const Map map = room_with(gate);
    EXPECT_EQ(frame_at(map.sprites[0], 0.1), 0u);
    EXPECT_EQ(frame_at(map.sprites[0], 1e9), 1u);
}

TEST(ThingSnapshot, StandsOnTheFloorOfTheMoment) {
    const Map map = room_with(torch());
    Snapshot snapshot = at_rest(map);
    snapshot.sectors[0].floor_z = 2.5;
    EXPECT_EQ(thing_at(map, snapshot, ThingId(0u)).z, 2.5);
}

TEST(ThingSnapshot, HangsUnderTheCeilingOfTheMoment) {
    ThingRecord lamp = torch();
    lamp.hanging = true;
    lamp.height = 0.5;
    const Map map = room_with(lamp);
    Snapshot snapshot = at_rest(map);
    snapshot.sectors[0].ceiling_z = 3;
    EXPECT_EQ(thing_at(map, snapshot, ThingId(0u)).z, 2.5);
}

TEST(ThingSnapshot, FloatsWhereItWasPut) {
    ThingRecord cloud = torch();
    cloud.z = 2;
    const Map map = room_with(cloud);
    Snapshot snapshot = at_rest(map);
    snapshot.sectors[0].floor_z = 0;
    snapshot.sectors[0].ceiling_z = 10;
    EXPECT_EQ(thing_at(map, snapshot, ThingId(0u)).z, 2);
}

TEST(ThingSnapshot, IsLitByItsRoomUnlessItShines) {
    EXPECT_EQ(thing_at(room_with(torch()), at_rest(room_with(torch())), ThingId(0u)).light, 0.5);
    ThingRecord lamp = torch();
    lamp.light = 1;
    EXPECT_EQ(thing_at(room_with(lamp), at_rest(room_with(lamp)), ThingId(0u)).light, 1);
}

TEST(ThingSnapshot, ShowsTheFrameOfTheSnapshotsTime) {
    const Map map = room_with(torch());
    Snapshot snapshot = at_rest(map);
    snapshot.time_s = 0.3;
    EXPECT_EQ(thing_at(map, snapshot, ThingId(0u)).frame, 1u);
}

}  // namespace
}  // namespace enfilade
