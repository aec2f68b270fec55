// Eyes, vertices and rays that coincide.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hard_cases/scenes.h"
#include "hard_cases/world.h"
#include "math/vec.h"
#include "space/trace.h"
#include "support/looks.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kSmallEven{64, 40}, kSmallOdd{65, 41};  ///< an odd side has a ray exactly along the look

View view_of(SectorId sector, Vec2 eye, double eye_z, Vec2 forward) {
    View view;
    view.sector = sector;
    view.eye = eye;
    view.eye_z = eye_z;
    view.forward = forward;
    return view;
}

/// From one place at one height, every eighth of a turn.
void expect_agreement_all_around(const MadeWorld& world, Vec2 eye, double eye_z) {
    const SectorId sector = locate(world.map, eye);
    if (!sector) return;  // on the outer side of an outer wall, under the tie rule
    for (std::uint32_t eighth = 0; eighth < 8; ++eighth)
        for (PictureSize size : {kSmallEven, kSmallOdd}) {
            const Comparison result =
                world.compare_with_reference(view_of(sector, eye, eye_z, direction(Angle{eighth << 29})), size);
            ASSERT_TRUE(result.is_faultless()) << describe(result);
        }
}

double head_height(const MadeWorld& world, Vec2 eye) {
    const SectorId sector = locate(world.map, eye);
    return sector ? world.map[sector].floor.z + 1.25 : 0;
}

// hard cases R1, I1
TEST(VertexOfManyWalls, IsLeftToExactlyOneOfThemInEveryColumn) {
    std::vector<Vec2> circle;
    for (int i = 0; i < 1000; ++i) {
        const double angle = i * (2 * std::numbers::pi / 1000);
        circle.push_back(snap_to_vertex_grid(Vec2{50 * std::cos(angle), 50 * std::sin(angle)}));
    }
    const MadeWorld world(map_of({room("round", circle)}));
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        const Drawn drawn = world.draw(random_pose(world.map, random), {1920, 2});
        ASSERT_TRUE(std::all_of(drawn.facts.writes.begin(), drawn.facts.writes.end(), [](int n) { return n == 1; }));
    }
}

// hard case R2: focal length 960, depth 1920, an odd number aside
TEST(VertexOnAPixelsCentre, IsLeftToExactlyOneOfItsWalls) {
    std::vector<Vec2> outline{{-8, 1920}, {-8, -1920}};
    for (int y = -1920; y <= 1920; ++y) outline.push_back({1920, static_cast<double>(y)});
    const MadeWorld world(map_of({room("wall", outline)}));
    for (int y = -40; y < 40; ++y) {
        const View view = view_of(SectorId(0u), {0, static_cast<double>(y)}, 1, {1, 0});
        const Drawn drawn = world.draw(view, {1920, 2});
        ASSERT_TRUE(std::all_of(drawn.facts.writes.begin(), drawn.facts.writes.end(), [](int n) { return n == 1; }));
    }
}

// hard case R4
TEST(EyeOnAPortalsLine, SeesWhatTheReferenceSees) {
    const MadeWorld world(stepped_rooms());
    for (const Wall& wall : world.map.walls) {
        const Vec2 middle = (wall.a + wall.b) * 0.5;
        if (wall.kind == WallKind::portal) expect_agreement_all_around(world, middle, head_height(world, middle));
    }
}

// hard case R5
TEST(EyeBesideAPortalsLine, SeesWhatTheReferenceSees) {
    const MadeWorld world(stepped_rooms());
    for (const Wall& wall : world.map.walls) {
        const Vec2 aside = right_of(wall.b - wall.a) * (0.01 / wall.length);
        const Vec2 eye = snap_to_point_grid((wall.a + wall.b) * 0.5 + aside);
        if (wall.kind == WallKind::portal) expect_agreement_all_around(world, eye, head_height(world, eye));
    }
}

// hard case R6
TEST(EyeOnAVertex, SeesWhatTheReferenceSees) {
    const MadeWorld world(stepped_rooms());
    for (const Wall& wall : world.map.walls) expect_agreement_all_around(world, wall.a, head_height(world, wall.a));
}

// hard case R6
TEST(EyeOnTheHubOfAWheel, SeesWhatTheReferenceSees) {
    const MadeWorld world(wheel());
    expect_agreement_all_around(world, {0, 0}, 1.25);
}

// hard case R6
TEST(EyeWherePillarsTouch, SeesWhatTheReferenceSees) {
    const MadeWorld world(pinched_room());
    for (const Wall& wall : world.map.walls) expect_agreement_all_around(world, wall.a, 1.25);
}

// hard case R7
TEST(EyeAtTheHeightOfAFlat, SeesWhatTheReferenceSeesAlsoFromAPortalsLine) {
    const MadeWorld world(stepped_rooms());
    for (const Wall& wall : world.map.walls) {
        if (wall.kind != WallKind::portal) continue;
        const Vec2 middle = (wall.a + wall.b) * 0.5;
        for (SectorId sector : {wall.sector, wall.behind}) {
            expect_agreement_all_around(world, middle, world.map[sector].floor.z);
            expect_agreement_all_around(world, middle, world.map[sector].ceiling.z);
        }
    }
}

/// Columns in which the wall is seen.
int columns_of(const Drawn& drawn, PixelSurface wall) {
    int columns = 0;
    for (int x = 0; x < drawn.frame.width; ++x) {
        bool seen = false;
        for (int y = 0; y < drawn.frame.height; ++y)
            seen |= drawn.facts.ids[static_cast<std::size_t>(y * drawn.frame.width + x)] == wall;
        columns += seen;
    }
    return columns;
}

// hard case R8
TEST(WallSeenOnEdge, CoversNoColumn) {
    // L-shaped rooms: of the wall from x = 4 to 8 at y = 2, an eye at (2, 2) sees the edge.
    const MadeWorld above(map_of({room("L", {{0, 0}, {8, 0}, {8, 2}, {4, 2}, {4, 4}, {0, 4}})}));
    const MadeWorld below(map_of({room("L", {{0, 0}, {4, 0}, {4, 2}, {8, 2}, {8, 4}, {0, 4}})}));
    const WallId edge_above = wall_between(above.map, SectorId(0u), {8, 2}, {4, 2});
    const WallId edge_below = wall_between(below.map, SectorId(0u), {4, 2}, {8, 2});
    for (PictureSize size : {kSmallEven, kSmallOdd}) {
        const View view = view_of(SectorId(0u), {2, 2}, 1, {1, 0});
        EXPECT_EQ(columns_of(above.draw(view, size), wall_id(above.map, edge_above, WallPart::middle)), 0);
        EXPECT_EQ(columns_of(below.draw(view, size), wall_id(below.map, edge_below, WallPart::middle)), 0);
        expect_agreement_all_around(above, {2, 2}, 1);
        expect_agreement_all_around(below, {2, 2}, 1);
    }
}

// hard case R9
TEST(WallSeenAlmostOnEdge, CoversOneColumnAtMostAndStaysWithinItself) {
    // The eye is 2^-16 m off the line of a wall that runs from 1 m to 4097 m ahead.
    const MadeWorld world(map_of({room("street", {{0, 0}, {1, 0}, {4097, 0}, {4097, 8}, {0, 8}})}));
    const PixelSurface wall =
        wall_id(world.map, wall_between(world.map, SectorId(0u), {1, 0}, {4097, 0}), WallPart::middle);
    for (std::uint32_t steps : {3u, 5u, 17u, 100u, 1000u, 9000u}) {  // of yaw to the left, 1.5e-9 rad each
        const View view = view_of(SectorId(0u), {0.5, 0x1p-16}, 1, direction(Angle{0u - steps}));
        for (int width : {117, 319, 1921}) {
            const Drawn drawn = world.draw(view, {width, 41});
            EXPECT_LE(columns_of(drawn, wall), 1) << steps << " steps, width " << width;
            const Comparison result = world.compare_with_reference(view, {width, 41});
            EXPECT_TRUE(result.is_faultless()) << describe(result);
        }
    }
}

// hard case R26
TEST(TwoDoorsThatShareAVertex, ShareNoColumnAndMissNone) {
    // The doors of "hub" meet in (29, 29) and (0, 29) and lead elsewhere, by different turns. From z = width / 64 away
    // a vertex that is aside by an odd number of 64ths is on a pixel's centre.
    const MadeWorld world(linked_rooms());
    for (Vec2 vertex : {Vec2{29, 29}, Vec2{0, 29}})
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
            for (int column = 1; column < 64; column += 2) {
                const Vec2 forward = direction(Angle{quarter << 30});
                const Vec2 eye = vertex - forward - right_of(forward) * ((2 * column + 1 - 64) / 64.0);
                if (!contains(world.map, SectorId(0u), eye)) continue;
                const Comparison result =
                    world.compare_with_reference(view_of(SectorId(0u), eye, 1.25, forward), {64, 40});
                ASSERT_TRUE(result.is_faultless()) << describe(result);
            }
}

}  // namespace
}  // namespace enfilade::test
