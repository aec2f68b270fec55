// What a ray meets, where all is tied or all but tied, against whole numbers of any size.
#include "render/exact_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/points.h"
#include "render/segment.h"
#include "support/exact.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

Pose pose_at(Vec2 eye, Vec2 forward, double flip = 1) {
    View view;
    view.eye = eye;
    view.forward = forward;
    view.flip = flip;
    return pose_of(view);
}

/// A unit vector, so turned that the ray of `slope` goes along +x but for rounding, and then some quarters on.
Vec2 look_with_ray_along_an_axis(double slope, std::uint64_t quarters) {
    const double length = std::sqrt(1 + slope * slope);
    Vec2 forward{1 / length, -slope / length};
    for (; quarters > 0; --quarters) forward = right_of(forward);
    return forward;
}

/// Of a picture 81 columns wide and 90 degrees across.
std::vector<double> slopes_of_a_picture() {
    std::vector<double> slopes;
    for (int x = 0; x < 81; ++x) slopes.push_back((x - 40) / 40.5);
    return slopes;
}

/// A pose aimed at ties: at a vertex or beside it, one column's ray along an axis up to rounding.
struct TiedPose {
    Pose pose;
    Vec2 vertex;

    TiedPose(Random& random, const std::vector<double>& slopes)
        : vertex(snap_to_vertex_grid(Vec2{random.uniform(-9, 9), random.uniform(-9, 9)})) {
        const Vec2 aside{kPointGrid * (double(random.below(3)) - 1), kPointGrid * (double(random.below(3)) - 1)};
        const double slope = slopes[random.below(slopes.size())];
        pose =
            pose_at(vertex + aside, look_with_ray_along_an_axis(slope, random.below(4)), random.below(4) == 0 ? -1 : 1);
    }

    /// On the line of that ray, or a step of the vertex grid beside it; mostly a vertex of its own.
    Vec2 other_vertex(Random& random) const {
        const Vec2 axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        const double far = double(1 + random.below(9)), beside = kVertexGrid * (double(random.below(3)) - 1);
        const Vec2 ahead = axes[random.below(4)];
        return vertex + ahead * far + right_of(ahead) * beside;
    }
};

bool is_right_by_oracle(const RayNormal& ray, Vec2 vertex, Vec2 eye) {
    const ExactPoint way = exact(vertex) - exact_moved(eye);
    return (Integer(ray.x) * way.x + Integer(ray.y) * way.y).sign() > 0;
}

// hard cases R4, R6
TEST(RunsRightOf, IsWhatWholeNumbersSayOfAnEyeThatIsMovedALittle) {
    const std::vector<double> slopes = slopes_of_a_picture();
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const TiedPose tied(random, slopes);
        const RayNormal ray = ray_normal(tied.pose, slopes[random.below(slopes.size())]);
        const Vec2 vertex = random.below(2) == 0 ? tied.vertex : tied.other_vertex(random);
        ASSERT_EQ(runs_right_of(ray, vertex, tied.pose.eye), is_right_by_oracle(ray, vertex, tied.pose.eye)) << i;
    }
}

// hard cases R1, R6, I4
TEST(CoveredColumns, AreThoseWhoseRaysRunBetweenTheEndsWhereAllIsTied) {
    const std::vector<double> slopes = slopes_of_a_picture();
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const TiedPose tied(random, slopes);
        Segment wall(tied.vertex, tied.other_vertex(random));
        if (side_of_line(wall.a, wall.b, tied.pose.eye) < 0) wall = Segment(wall.b, wall.a);
        const FacingWall facing = facing_wall(wall, tied.pose);
        const CoveredColumns covered = covered_columns(facing, tied.pose, {slopes, 40.5});
        for (int x = 0; x < 81; ++x) {
            const RayNormal ray = ray_normal(tied.pose, slopes[static_cast<std::size_t>(x)]);
            const bool is_covered =
                runs_right_of(ray, facing.left, tied.pose.eye) && !runs_right_of(ray, facing.right, tied.pose.eye);
            ASSERT_EQ(x >= covered.begin && x < covered.end, is_covered) << i << ", column " << x;
        }
        count_trials(81, "columns");
    }
}

/// A ray and a wall that it meets.
struct MetWall {
    RayDepth depth;

    MetWall(Random& random, Vec2 forward) {
        const Pose pose = pose_at({}, forward);
        const Vec2 right = pose.right, ahead = snap_to_vertex_grid(forward * random.uniform(1, 99));
        const Vec2 a = snap_to_vertex_grid(ahead - right * random.uniform(0.5, 9));
        const Vec2 b = snap_to_vertex_grid(ahead + right * random.uniform(0.5, 9));
        depth = depth_on_wall(a, b, pose, ray_normal(pose, random.uniform(-1e-3, 1e-3)));
    }
};

Integer whole(Int128 x) {
    const auto low = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) & 0xFFFFFFFFu);
    return (Integer(static_cast<std::int64_t>(x >> 32)) << 32) + Integer(low);
}

constexpr int kUnits = 200;  ///< of rises and heights: 2^-200

/// rise * cross 2^23 - height * run * across.
int rise_beyond(const RowClimb& climb, const RayDepth& depth, double height) {
    const Integer risen = whole(depth.cross) * Integer::scaled(climb.rise, kUnits) << 23 + kUnits;
    const Integer asked = whole(depth.across) * Integer::scaled(height, kUnits) * Integer::scaled(climb.run, kUnits);
    return (risen - asked).sign();
}

// hard case R13
TEST(Reaches, IsWhatWholeNumbersSayToTheLastBitOfAHeight) {
    Random random(3);
    int ties = 0;
    for (int i = 0; i < 20'000; ++i) {
        const bool is_straight = random.below(2) == 0;
        const MetWall met(random, is_straight ? Vec2{1, 0} : direction(Angle::from_degrees(random.uniform(0, 360))));
        const RowClimb climb{std::ldexp(double(random.below(400)) - 200 + 0.5, -1), random.below(2) ? 320 : 277.128};
        double height = climb.rise * met.depth.value / climb.run;
        const int beside = static_cast<int>(random.below(9)) - 4;
        for (int k = 0; k < std::abs(beside); ++k) height = std::nextafter(height, beside < 0 ? -1e9 : 1e9);
        const int beyond = rise_beyond(climb, met.depth, height);
        ties += beyond == 0;
        ASSERT_EQ(reaches(climb, met.depth, height), beyond >= 0) << i;
    }
    EXPECT_GT(ties, 0);
}

TEST(Reaches, MeetsAWallThroughTheEyeAnInstantAfterTheStart) {
    const RayDepth here{0, 0, 1};
    EXPECT_TRUE(reaches({1e-9, 1}, here, 0));
    EXPECT_TRUE(reaches({0, 1}, here, 0));
    EXPECT_FALSE(reaches({-1e-9, 1}, here, 0));
    EXPECT_FALSE(reaches({100, 1}, here, 1e-9));
    EXPECT_TRUE(reaches({-100, 1}, here, -1e-9));
}

TEST(DepthSteps, OfAnExactDepthAreCountedFromItsVeryMiddle) {
    // 3.5 steps, and a hair less and more.
    const Int128 across = Int128{1} << 107, half = across * 7 >> 44;
    const auto steps = [&](Int128 cross) {
        return depth_steps(RayDepth{static_cast<double>(cross) / static_cast<double>(across) * 0x1p23, cross, across});
    };
    EXPECT_EQ(steps(half), 4);
    EXPECT_EQ(steps(half - 1), 3);
    EXPECT_EQ(steps(half + 1), 4);
    EXPECT_EQ(depth_steps(3.5 * kDepthStep), 4);
}

TEST(SureDepthSteps, LeaveAChoiceOnlyAtTheMiddleBetweenTwo) {
    EXPECT_EQ(sure_depth_steps(3.4 * kDepthStep), 3);
    EXPECT_EQ(sure_depth_steps(3.6 * kDepthStep), 4);
    EXPECT_EQ(sure_depth_steps(3.5 * kDepthStep), std::nullopt);
    EXPECT_EQ(sure_depth_steps(3.5 * kDepthStep * (1 + kDepthDoubt)), std::nullopt);
    EXPECT_EQ(sure_depth_steps(0), 0);
}

}  // namespace
}  // namespace enfilade
