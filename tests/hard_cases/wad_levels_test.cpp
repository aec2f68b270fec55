// Levels of Doom that made other engines show nothing: steps without texture, deep water, doors that begin to open.
#include <gtest/gtest.h>

#include "hard_cases/world.h"
#include "wadconv/converted.h"
#include "world/step.h"

namespace enfilade::test {
namespace {

using wadconv::test::Converted;
using wadconv::test::Level;

constexpr PictureSize kLevelSize{96, 60};

/// A hall with a pool and a platform, no step of which has a texture; in the pool a ring of lines with the pool on both
/// sides, and one with the hall on both.
Level deep_water() {
    Level level;
    const int hall = level.sector(0, 128), pool = level.sector(-48, 128), platform = level.sector(24, 96);
    level.box(0, 0, 512, 512, hall);
    level.ring({{64, 64}, {64, 256}, {256, 256}, {256, 64}}, pool, hall);
    level.ring({{320, 320}, {320, 448}, {448, 448}, {448, 320}}, platform, hall);
    level.ring({{96, 96}, {96, 160}, {160, 160}, {160, 96}}, pool, pool);
    level.ring({{320, 96}, {320, 160}, {384, 160}, {384, 96}}, hall, hall);
    level.thing(32, 32, 1);
    return level;
}

// hard cases I2, W2, W3
TEST(WadLevel, WithDeepWaterAndStepsWithoutTextureShowsNoPixelOfNothing) {
    const Converted converted(deep_water());
    const MadeWorld world(converted.file);
    for (const PoseKind kind : {PoseKind::random, PoseKind::lattice}) {
        const Comparison sum = compare_poses(world.subject(), kind, 100, kLevelSize, 3);
        EXPECT_TRUE(sum.is_faultless()) << describe(sum);
    }
}

/// Two rooms and a door between them that is shut: its ceiling lies on its floor.
Level shut_door() {
    Level level;
    const int hall = level.sector(0, 128), door = level.sector(0, 0), yard = level.sector(-8, 160);
    level.line({0, 0}, {0, 256}, hall);
    level.line({0, 256}, {256, 256}, hall);
    const int front = level.line({256, 256}, {256, 0}, hall, door);
    level.line({256, 0}, {0, 0}, hall);
    level.line({256, 256}, {272, 256}, door);
    const int back = level.line({272, 0}, {272, 256}, yard, door);
    level.line({272, 0}, {256, 0}, door);
    level.line({272, 256}, {512, 256}, yard);
    level.line({512, 256}, {512, 0}, yard);
    level.line({512, 0}, {272, 0}, yard);
    for (const int line : {front, back}) {
        level.map.lines[static_cast<std::size_t>(line)].special = 1;
        level.map.sides[level.map.lines[static_cast<std::size_t>(line)].right].upper = "WALL";
    }
    level.thing(236, 128, 1);
    return level;
}

View seen_by(const World& state) {
    View view;
    view.sector = state.player.place.sector;
    view.eye = state.player.place.point;
    view.eye_z = state.player.eye_z;
    view.forward = direction(state.player.yaw);
    return view;
}

// hard cases I2, W11
TEST(WadDoor, IsDrawnRightInEveryTickFromShutToOpen) {
    const Converted converted(shut_door());
    MadeWorld world(converted.file);
    World state = *start_of(world.map);
    View beyond = seen_by(state);
    beyond.sector = locate(world.map, {12, -4});
    beyond.eye = {12, -4};
    beyond.forward = {-1, 0};
    double ceiling_z = 0;
    for (int tick = 0; tick < 150; ++tick) {
        for (const View& view : {seen_by(state), beyond}) {
            const Comparison result = compare(world.subject(), world.snapshot, view, kLevelSize);
            ASSERT_TRUE(result.is_faultless()) << "tick " << tick << ": " << describe(result);
        }
        step(world.map, state, {.buttons = static_cast<std::uint8_t>(tick == 3 ? kButtonUse : 0)});
        show(now(world.map, state), world.snapshot);
        ceiling_z = world.snapshot.sectors[1].ceiling_z;
    }
    EXPECT_GT(ceiling_z, 3.5);
    count_trials(150, "ticks");
}

}  // namespace
}  // namespace enfilade::test
