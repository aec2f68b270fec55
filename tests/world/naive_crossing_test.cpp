// Rooms found by the place alone: right where no rooms lie over each other, wrong where some do, and never outside.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "world/game.h"
#include "world/replay.h"
#include "world/step.h"

namespace enfilade {
namespace {

using namespace test;

constexpr MotionDials kNaive{kUsualTickRate, CrossingMethod::naive};

/// A hall that opens into a yard in the west and into a loft in the north. The yard goes on north of the hall, where
/// the loft lies, too, and a little over the hall.
MapFile yard_hall_and_loft() {
    MapFile file = map_of({room("yard", {{0, -6}, {12, -6}, {12, 0.5}, {4, 0.5}, {4, 4}, {0, 4}}, 0, 3),
                           room("hall", {{4, 4}, {4, 0.5}, {4, 0}, {8, 0}, {8, 4}}, 0, 3),
                           room("loft", {{4, -4}, {8, -4}, {8, 0}, {4, 0}}, 0, 3)});
    join(file, "yard", "hall", {4, 0.5}, {4, 4});
    join(file, "hall", "loft", {4, 0}, {8, 0});
    place_player(file, "hall", {6, 2}, kEyeOnFloor, 270);
    return file;
}

TEST(NaiveCrossing, EndsInTheWrongOneOfTwoRoomsThatLieOverEachOther) {
    Game exact(yard_hall_and_loft()), naive(yard_hall_and_loft(), kNaive);
    exact.hold(kForward, 90);
    naive.hold(kForward, 90);
    ASSERT_LT(exact.point().y, -1);
    EXPECT_EQ(exact.room(), "loft");
    EXPECT_EQ(naive.room(), "yard");
    EXPECT_TRUE(naive.is_contained());
}

/// Two rooms that lie apart, joined by a link.
MapFile linked_rooms() {
    MapFile file = map_of({box_room("here", 0, 0, 4, 4, 0, 3), box_room("there", 20, 20, 24, 24, 0, 3)});
    link(file, "here", {4, 0}, {4, 4}, "there", {20, 24}, {20, 20});
    place_player(file, "here", {2, 2}, kEyeOnFloor, 0);
    return file;
}

TEST(NaiveCrossing, PassesLinksAsTheExactOneDoes) {
    Game exact(linked_rooms()), naive(linked_rooms(), kNaive);
    exact.hold(kForward, 60);
    naive.hold(kForward, 60);
    ASSERT_EQ(exact.room(), "there");
    EXPECT_EQ(naive.player().place, exact.player().place);
}

TEST(NaiveCrossing, IsRightWhereNoRoomsLieOverEachOther) {
    MapFile file;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            file.sectors.push_back(
                box_room(std::to_string(x) + "_" + std::to_string(y), 2 * x, 2 * y, 2 * x + 2, 2 * y + 2, 0, 3));
    join_all(file);
    place_player(file, "0_0", {1, 1}, kEyeOnFloor, 30);
    Game exact(file), naive(file, kNaive);
    Random random(5);
    for (int i = 0; i < 3000; ++i) {
        TickInput keys = kRunForward;
        keys.yaw_steps = static_cast<std::int32_t>(random.bits() >> 38);
        exact.hold(keys);
        naive.hold(keys);
        ASSERT_EQ(naive.player(), exact.player()) << i;
    }
    EXPECT_NE(hash(naive.world), hash(exact.world)) << "another kind of world";
}

TEST(NaiveCrossing, IsPlayedAgainFromATape) {
    Game naive(yard_hall_and_loft(), kNaive);
    const std::vector<TickInput> ticks(90, kForward);
    for (const TickInput& tick : ticks) naive.hold(tick);
    Tape tape{.map = "", .rate = 60, .is_naive = true, .ticks = ticks, .final_hash = hash(naive.world)};
    EXPECT_TRUE(replay(naive.map, tape).ok());
    tape.is_naive = false;
    EXPECT_FALSE(replay(naive.map, tape).ok());
}

}  // namespace
}  // namespace enfilade
