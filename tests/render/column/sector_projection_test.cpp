// Where walls stand on the screen: neighbours meet exactly, also where vertices fall on pixel centres.
#include "render/column/sector_projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "math/predicates.h"
#include "support/count_allocations.h"
#include "support/trials.h"

namespace enfilade::column {
namespace {

/// One sector with one outline, clockwise on the drawing.
Map room(const std::vector<Vec2>& outline) {
    Map map;
    map.sectors.push_back({});
    map.sectors[0].wall_count = static_cast<std::uint32_t>(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Wall wall;
        wall.a = outline[i];
        wall.b = outline[(i + 1) % outline.size()];
        wall.length = std::sqrt(dot(wall.b - wall.a, wall.b - wall.a));
        wall.sector = SectorId(0u);
        map.walls.push_back(wall);
    }
    return map;
}

RayTables screen_of(int width, double fov_degrees = 90) {
    View view;
    view.fov_degrees = fov_degrees;
    RayTables screen;
    screen.set(Projection(view, width, 200));
    return screen;
}

Pose pose_at(Vec2 eye, Angle yaw) {
    View view;
    view.eye = eye;
    view.forward = direction(yaw);
    return pose_of(view);
}

/// How many walls of the room cover each column.
std::vector<int> coverage(const Map& map, const Pose& pose, const RayTables& screen) {
    std::vector<ProjectedWall> walls;
    project(map, SectorId(0u), pose, screen, walls);
    test::count_trials(static_cast<std::uint64_t>(screen.width), "columns");
    std::vector<int> count(static_cast<std::size_t>(screen.width));
    for (const ProjectedWall& wall : walls)
        for (int x = wall.begin; x < wall.end; ++x) ++count[static_cast<std::size_t>(x)];
    return count;
}

bool all_ones(const std::vector<int>& counts) {
    return std::all_of(counts.begin(), counts.end(), [](int n) { return n == 1; });
}

/// A room that every place near its middle sees as a whole: vertices on a square ring, in order of angle.
std::vector<Vec2> ring(int half, int step) {
    std::vector<Vec2> outline;
    for (int x = -half; x < half; x += step) outline.push_back({double(x), double(-half)});
    for (int y = -half; y < half; y += step) outline.push_back({double(half), double(y)});
    for (int x = half; x > -half; x -= step) outline.push_back({double(x), double(half)});
    for (int y = half; y > -half; y -= step) outline.push_back({double(-half), double(y)});
    return outline;
}

// Width 1920 and fov 90 make the focal length 960, so a vertex 1920 ahead and an odd number aside falls on a pixel
// centre. Every column of every straight look has one: 1920 x 536 / 2 of the looks are straight, half a
// million ties.
// hard cases R2, I4
TEST(Project, MeetsAtEveryVertexThatFallsOnAPixelCentre) {
    const Map map = room(ring(1920, 1));
    const RayTables screen = screen_of(1920);
    for (int trial = 0; trial < 536; ++trial) {
        const Angle yaw{static_cast<std::uint32_t>(trial % 8) << 29};
        const Pose pose = pose_at({double(trial / 8 % 4), double(trial / 32)}, yaw);
        ASSERT_TRUE(all_ones(coverage(map, pose, screen))) << "trial " << trial;
    }
}

// hard cases R1, I4
TEST(Project, CoversEachColumnOnceFromRandomPlacesInAConvexRoom) {
    const Map map = room({{-7, -5}, {3, -6}, {9, 0}, {4, 8}, {-6, 6}});
    Random random(11);
    for (int trial = 0; trial < 3000; ++trial) {
        const RayTables screen = screen_of(1 + static_cast<int>(random.below(700)), random.uniform(1, 179));
        const Pose pose = pose_at(snap_to_point_grid(Vec2{random.uniform(-4, 4), random.uniform(-4, 4)}),
                                  Angle{static_cast<std::uint32_t>(random.bits())});
        ASSERT_TRUE(all_ones(coverage(map, pose, screen))) << "trial " << trial;
    }
}

// hard case I4
TEST(Project, CoversEachColumnOnceFromWallsAndVertices) {
    const std::vector<Vec2> outline{{-4, -4}, {0, -4}, {4, -4}, {4, 4}, {-2, 4}, {-4, 2}};
    const Map map = room(outline);
    for (int width : {320, 117})  // an odd width has a ray straight ahead, along the wall the eye stands on
        for (std::size_t i = 0; i < outline.size(); ++i)
            for (Vec2 eye : {outline[i], (outline[i] + outline[(i + 1) % outline.size()]) * 0.5})
                for (std::uint32_t eighth = 0; eighth < 8; ++eighth) {
                    // Under the tie rule an eye on a wall is in the room or not; only inside has it a full view.
                    const Pose pose = pose_at(eye, Angle{eighth << 29});
                    const RayTables screen = screen_of(width);
                    int winding_right = 0;
                    for (const Wall& wall : map.walls) winding_right += side_of_line(wall.a, wall.b, eye) > 0;
                    if (winding_right != static_cast<int>(map.walls.size())) continue;
                    EXPECT_TRUE(all_ones(coverage(map, pose, screen))) << eye.x << "," << eye.y << " eighth " << eighth;
                }
}

// hard case R9
TEST(Hit, NeverLeavesTheWallHoweverGrazingTheLook) {
    // A wall 4096 m long seen at 1e-6 rad, far to one side of a narrow room.
    const Map map = room({{-1, -1}, {4096, -0.0078125}, {4096, 1}, {-1, 1}});
    const RayTables screen = screen_of(7680);
    std::vector<ProjectedWall> walls;
    project(map, SectorId(0u), pose_at({0, 0}, Angle{}), screen, walls);
    for (const ProjectedWall& wall : walls)
        for (int x = wall.begin; x < wall.end; ++x) {
            const WallHit look = hit(wall, screen.slopes[x]);
            EXPECT_GE(look.along, 0);
            EXPECT_LE(look.along, 1);
            EXPECT_GE(look.depth, wall.nearest);
            EXPECT_LE(look.depth, wall.farthest);
        }
}

TEST(Hit, FindsDepthAndPlaceOnALevelWall) {
    const Map map = room({{3, -2}, {3, 2}, {-3, 2}, {-3, -2}});
    const RayTables screen = screen_of(3);  // slopes -2/3, 0, 2/3
    std::vector<ProjectedWall> walls;
    project(map, SectorId(0u), pose_at({0, 0}, Angle{}), screen, walls);
    const auto ahead = std::find_if(walls.begin(), walls.end(), [](const auto& w) { return w.wall == WallId(0u); });
    ASSERT_NE(ahead, walls.end());
    EXPECT_DOUBLE_EQ(hit(*ahead, screen.slopes[1]).depth, 3);
    EXPECT_DOUBLE_EQ(hit(*ahead, screen.slopes[1]).along, 0.5);
    EXPECT_DOUBLE_EQ(inverse_depth(*ahead, screen.slopes[1]), 1.0 / 3);
}

// hard case R21
TEST(IsNearer, TellsWallsApartThatShareAVertex) {
    // Seen from the left: the wall from the vertex towards the eye is nearer than the one that leads away.
    Wall towards, away;
    towards.a = {2, 0}, towards.b = {1, 1};
    away.a = {2, 0}, away.b = {3, 1};
    EXPECT_TRUE(is_nearer(away, towards) != is_nearer(towards, away));
}

// hard case R27
TEST(IsBeyond, LeavesTheEntrysOwnPlaneToTheRoomBefore) {
    Wall entry, coplanar, beyond, before;
    entry.a = {0, 2}, entry.b = {0, -2};  // entered looking along +x: the sector lies on its right, at x > 0
    coplanar.a = {0, -2}, coplanar.b = {0, -4};
    beyond.a = {3, -1}, beyond.b = {3, 1};
    before.a = {-1, -5}, before.b = {0, -2};
    ASSERT_GT(corner(entry.a, entry.b, beyond.a), 0);
    EXPECT_TRUE(is_beyond(beyond, entry));
    EXPECT_FALSE(is_beyond(coplanar, entry));
    EXPECT_FALSE(is_beyond(before, entry));
}

TEST(ProjectionCache, ForgetsWhatTakesTooMuchMemory) {
    std::vector<Vec2> outline;
    for (int i = 0; i <= 1000; ++i) outline.push_back({i * 0.25, 0});
    for (const Vec2 far : {Vec2{250, 400}, Vec2{0, 400}}) outline.push_back(far);
    const Map map = room(outline);
    const RayTables screen = screen_of(640);
    const Pose pose = pose_at({125.0625, 200}, Angle::from_degrees(-90));
    ProjectionCache cache;
    const std::size_t first = cache.get(map, SectorId(0u), 0, pose, screen).size();
    const std::size_t before = test::restart_peak();
    constexpr int kPoses = 12'000;
    for (int i = 1; i < kPoses; ++i) ASSERT_EQ(cache.get(map, SectorId(0u), i, pose, screen).size(), first);
    EXPECT_GT(first * sizeof(ProjectedWall) * kPoses, std::size_t{300} << 20);  // there is something to forget
    EXPECT_LT(test::peak_bytes() - before, std::size_t{300} << 20);
    EXPECT_EQ(cache.get(map, SectorId(0u), 0, pose, screen).size(), first);
}

}  // namespace
}  // namespace enfilade::column
