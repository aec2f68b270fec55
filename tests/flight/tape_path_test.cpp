// Recorded walks, played again.
#include "flight/flight.h"

#include <gtest/gtest.h>

#include "flight/scenes.h"
#include "world/input.h"
#include "world/step.h"
#include "world/world.h"

namespace enfilade {
namespace {

/// Walks around the hall: every tick forward, turning.
std::vector<TickInput> some_walk(std::size_t ticks) {
    std::vector<TickInput> inputs(ticks);
    for (std::size_t i = 0; i < ticks; ++i) {
        inputs[i].forward = 100;
        inputs[i].yaw_steps = i % 50 < 20 ? 20'000'000 : -1'000'000;
        inputs[i].pitch_steps = i < 30 ? 3'000'000 : 0;
    }
    return inputs;
}

Tape tape_of(const Map& map, const std::vector<TickInput>& inputs) {
    World world = *start_of(map);
    for (const TickInput& input : inputs) step(map, world, input);
    return {"hall.toml", 0, kTickRate, false, inputs, hash(world)};
}

class TapePathInHall : public ::testing::Test {
protected:
    /// The player's eye after so many ticks, as it was when it was played.
    Eye eye_after(std::size_t ticks) const {
        World world = *start_of(map_);
        for (std::size_t i = 0; i < ticks; ++i) step(map_, world, inputs_[i]);
        return eye_between_ticks(map_, world, 1);
    }

    Map map_ = test::built(test::hall_file());
    std::vector<TickInput> inputs_ = some_walk(200);
    Tape tape_ = tape_of(map_, inputs_);
};

TEST_F(TapePathInHall, ShowsWhatThePlayerSawAfterEachTick) {
    const TapePath path = TapePath::plan(map_, tape_).value();
    for (const int tick : {0, 1, 31, 32, 33, 64, 150, 199, 200}) {
        const CameraPose pose = path.pose_at(map_, {tick, kTickRate});
        const Eye eye = eye_after(static_cast<std::size_t>(tick));
        EXPECT_EQ(pose.place, eye.place) << "tick " << tick;
        EXPECT_EQ(pose.eye_z, eye.z) << "tick " << tick;
        EXPECT_EQ(pose.yaw, eye.yaw) << "tick " << tick;
        EXPECT_EQ(Angle::from_degrees(pose.pitch_degrees).steps, static_cast<std::uint32_t>(eye.pitch_steps));
    }
}

TEST_F(TapePathInHall, GoesBetweenTicksWhereThePictureIsBetween) {
    const TapePath path = TapePath::plan(map_, tape_).value();
    const double at_10 = path.pose_at(map_, {20, 120}).place.point.x,
                 at_11 = path.pose_at(map_, {22, 120}).place.point.x;
    EXPECT_NEAR(path.pose_at(map_, {21, 120}).place.point.x, (at_10 + at_11) / 2, 1e-9);  // point-grid steps are 2e-10
}

TEST_F(TapePathInHall, StaysAtTheEnd) {
    const TapePath path = TapePath::plan(map_, tape_).value();
    EXPECT_EQ(path.pose_at(map_, {100'000, 60}).place, eye_after(200).place);
}

TEST_F(TapePathInHall, IsAsLongAsItsTicks) { EXPECT_EQ(TapePath::plan(map_, tape_).value().length_us(), 3'333'333); }

TEST_F(TapePathInHall, GoesAtTheRateOfTheTape) {
    World world = *start_of(map_, TickRate::hz35);
    for (const TickInput& input : inputs_) step(map_, world, input);
    const Tape tape{"hall.toml", 0, 35, false, inputs_, hash(world)};
    const TapePath path = TapePath::plan(map_, tape).value();
    EXPECT_EQ(path.length_us(), 200 * 1'000'000 / 35);
    EXPECT_EQ(path.pose_at(map_, {200, 35}).place, world.player.place);
}

TEST_F(TapePathInHall, ShowsTheStartOfAnEmptyTape) {
    const Tape empty = tape_of(map_, {});
    EXPECT_EQ(TapePath::plan(map_, empty).value().pose_at(map_, {0, 30}).place, eye_after(0).place);
}

TEST_F(TapePathInHall, RefusesAWalkThatEndsElsewhere) {
    *tape_.final_hash ^= 1;
    EXPECT_FALSE(TapePath::plan(map_, tape_).ok());
}

TEST_F(TapePathInHall, RefusesARateThatNoWorldHas) {
    tape_.rate = 50;
    EXPECT_EQ(TapePath::plan(map_, tape_).error().what, "expected a tape of 60, 35 or 140 ticks a second; found 50");
}

TEST_F(TapePathInHall, RefusesAMapWithoutPlayer) {
    map_.player.reset();
    EXPECT_FALSE(TapePath::plan(map_, tape_).ok());
}

}  // namespace
}  // namespace enfilade
