// Rooms of awkward shape, and a camera that creeps.
#include <gtest/gtest.h>

#include <cmath>

#include "hard_cases/scenes.h"
#include "hard_cases/world.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

void expect_agreement(const MadeWorld& world, const View& view, PictureSize size) {
    const Comparison result = world.compare_with_reference(view, size);
    ASSERT_TRUE(result.is_faultless()) << describe(result);
}

// hard case R21
TEST(RoomLikeAU, ShowsTheNearerOfItsOwnWalls) {
    const MadeWorld world(crooked_rooms());
    for (Vec2 eye : {Vec2{1, 7.5}, Vec2{7, 7}, Vec2{1.01, 1.02}, Vec2{4, 3}})
        for (double yaw = 0; yaw < 360; yaw += 9)
            expect_agreement(world, look_from(world.map, eye, 1.1, yaw), {96, 60});
}

// hard case R22
TEST(RoomOfSeveralParts, IsSeenPartByPart) {
    // One sector: a square ring, inside its hole an island with a pillar, and a third part far away.
    MapFile file = map_of({box_room("ring", 0, 0, 20, 20)});
    SectorRecord& ring = file.sectors[0];
    cut_pillar(ring, 4, 4, 16, 16);
    ring.loops.push_back(loop_of({{6, 6}, {14, 6}, {14, 14}, {6, 14}}));
    cut_pillar(ring, 9, 9, 11, 10);
    ring.loops.push_back(loop_of({{30, 0}, {40, 0}, {35, 9}}));
    const MadeWorld world(file);
    for (Vec2 eye : {Vec2{2, 2}, Vec2{7, 8}, Vec2{12.5, 13}, Vec2{35, 3}})
        for (double yaw = 0; yaw < 360; yaw += 9)
            expect_agreement(world, look_from(world.map, eye, 1.1, yaw), {96, 60});
}

/// Rows of a ledge's edge in one column of a picture, while the eye moves.
class CreepingCamera : public testing::Test {
protected:
    static constexpr int kFrames = 256;
    static constexpr PictureSize kSize{320, 200};

    static MapFile ledge() {
        MapFile file = map_of({box_room("hall", 0, 0, 8, 8, 0, 4), box_room("ledge", 8, 0, 12, 8, 1.1, 3)});
        join_all(file);
        return file;
    }

    const MadeWorld world_{ledge()};
};

// hard case R31: 1/64 of a pixel a frame
TEST_F(CreepingCamera, MovesEveryEdgeExactlyAsTheTruthMoves) {
    // The ledge's front is 6 m away: sideways by 6 m / focal length / 64, the focal length being 160 pixels.
    const double step = 6.0 / 160 / 64;
    for (int frame = 0; frame < kFrames; frame += 3)
        expect_agreement(world_, look_from(world_.map, {2, 3.3 + frame * step}, 1.7, 8), kSize);
}

// hard case R10: "wiggle"
TEST_F(CreepingCamera, LowersALedgeInEveryColumnWithoutEverTurningBack) {
    // Walking towards a ledge below the eye moves its edge down the screen, never up.
    const PixelSurface step =
        wall_id(world_.map, wall_between(world_.map, SectorId(0u), {8, 0}, {8, 8}), WallPart::lower);
    std::vector<int> last(static_cast<std::size_t>(kSize.width), 0);
    for (int frame = 0; frame < 64; ++frame) {
        const Drawn drawn = world_.draw(look_from(world_.map, {4 + frame / 64.0, 3.3}, 1.7, 0), kSize);
        for (int x = 0; x < kSize.width; ++x) {
            int top = 0;
            while (top < kSize.height && drawn.facts.ids[static_cast<std::size_t>(top * kSize.width + x)] != step)
                ++top;
            if (top == kSize.height) continue;
            ASSERT_GE(top, last[static_cast<std::size_t>(x)]) << "column " << x << " of frame " << frame;
            last[static_cast<std::size_t>(x)] = top;
        }
    }
}

// hard case R10
TEST_F(CreepingCamera, DrawsALedgeWithinHalfAPixelOfWhereItIs) {
    constexpr double kRounding = 1e-9;  // of a product and a quotient [px]
    const PixelSurface step =
        wall_id(world_.map, wall_between(world_.map, SectorId(0u), {8, 0}, {8, 8}), WallPart::lower);
    for (int frame = 0; frame < 64; ++frame) {
        const double depth = 4 - frame / 64.0;
        const Drawn drawn = world_.draw(look_from(world_.map, {8 - depth, 3.3}, 1.7, 0), kSize);
        const double edge_px = 100 + (1.7 - 1.1) / depth * 160;
        int top = 0;
        while (drawn.facts.ids[static_cast<std::size_t>(top * kSize.width + 160)] != step) ++top;
        ASSERT_LE(std::fabs(top - edge_px), 0.5 + kRounding) << frame;
    }
}

}  // namespace
}  // namespace enfilade::test
