// Tapes: the same inputs give the same world, and a tape that does not fit says so.
#include "world/replay.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;

Map two_rooms() {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 1, 9, 3, 0.5, 4)});
    split_and_join(file);
    place_player(file, "a", {2, 2}, kEyeOnFloor, 20);
    return built(file);
}

std::vector<TickInput> some_inputs(int count) {
    Random random(11);
    std::vector<TickInput> inputs;
    for (int i = 0; i < count; ++i)
        inputs.push_back({.forward = static_cast<std::int8_t>(random.below(255) - 127),
                          .strafe = static_cast<std::int8_t>(random.below(255) - 127),
                          .yaw_steps = static_cast<std::int32_t>(random.bits()) / 16,
                          .buttons = static_cast<std::uint8_t>(random.below(4))});
    return inputs;
}

Tape recorded(const Map& map) {
    Tape tape;
    tape.map = "two_rooms.toml";
    tape.ticks = some_inputs(300);
    tape.final_hash = hash(play(map, tape.ticks)->end);
    return tape;
}

TEST(Replay, EndsAsItWasRecorded) {
    const Map map = two_rooms();
    EXPECT_TRUE(replay(map, recorded(map)).ok());
}

TEST(Replay, GoesThroughTheSameStates) {
    const Map map = two_rooms();
    const auto inputs = some_inputs(300);
    EXPECT_FALSE(first_difference(play(map, inputs)->hashes, play(map, inputs)->hashes).has_value());
}

TEST(Replay, FindsTheFirstTickThatDiffers) {
    const Map map = two_rooms();
    const auto inputs = some_inputs(300);
    auto others = inputs;
    others[123].forward = static_cast<std::int8_t>(others[123].forward ^ 64);
    EXPECT_EQ(first_difference(play(map, inputs)->hashes, play(map, others)->hashes), 123u);
}

TEST(Replay, CountsAMissingTickAsADifference) {
    const std::vector<std::uint64_t> longer{1, 2, 3}, shorter{1, 2};
    EXPECT_EQ(first_difference(longer, shorter), 2u);
}

TEST(Replay, RefusesATapeThatEndsElsewhere) {
    const Map map = two_rooms();
    Tape tape = recorded(map);
    *tape.final_hash ^= 1;
    ASSERT_FALSE(replay(map, tape).ok());
    EXPECT_NE(replay(map, tape).error().what.find("after 300 ticks"), std::string::npos);
}

TEST(Replay, RefusesATapeOfARateThatNoWorldHas) {
    const Map map = two_rooms();
    Tape tape = recorded(map);
    tape.rate = 50;
    ASSERT_FALSE(replay(map, tape).ok());
    EXPECT_NE(replay(map, tape).error().what.find("expected 60, 35 or 140 ticks a second, found 50"),
              std::string::npos);
}

TEST(Replay, RefusesAMapWithoutAStart) {
    const Map map = two_rooms();
    Map nobody = map;
    nobody.player.reset();
    EXPECT_FALSE(replay(nobody, recorded(map)).ok());
}

}  // namespace
}  // namespace enfilade
