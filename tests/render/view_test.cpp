// The one projection: from pixels to rays.
#include "render/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "render/sampling.h"

namespace enfilade {
namespace {

/// Of a tangent and a product [1].
constexpr double kRounding = 1e-15;

Projection projection(int width, int height, double fov_degrees = 90, double pitch_tangent = 0, double stretch = 1) {
    View view;
    view.fov_degrees = fov_degrees;
    view.pitch_tangent = pitch_tangent;
    view.stretch = stretch;
    return {view, width, height};
}

/// Rows whose centres see a wall `depth` away between two heights above the eye.
int rows_covered(const Projection& p, double depth, double low, double high) {
    int rows = 0;
    for (int y = 0; y < p.height(); ++y) {
        const double h = p.climb(y) * depth;
        rows += h >= low && h < high;
    }
    return rows;
}

TEST(Projection, ShowsAWallAsHighAsItIsFarAwayOverHalfTheWidthAt90Degrees) {
    EXPECT_EQ(rows_covered(projection(320, 320), 10, -5, 5), 160);
    EXPECT_EQ(rows_covered(projection(320, 320), 40, -5, 5), 40);
}

TEST(Projection, StretchesHeightsByTheGivenFactor) {
    EXPECT_EQ(rows_covered(projection(320, 320, 90, 0, 1.25), 10, -4, 4), 160);
}

TEST(Projection, HasSquarePixels) {
    const Projection p = projection(320, 200, 75);
    EXPECT_NEAR(p.slope(200) - p.slope(199), p.climb(99) - p.climb(100), kRounding);
}

TEST(Projection, EndsHalfAPixelBeyondTheOutermostRaysAtTheFieldOfView) {
    for (double fov : {1.0, 60.0, 90.0, 120.0, 179.0}) {
        const Projection p = projection(1000, 500, fov);
        const double edge = p.slope(999) + (p.slope(999) - p.slope(998)) / 2;
        EXPECT_NEAR(std::atan(edge) * 360 / std::numbers::pi, fov, 1e-6) << fov;  // an angle's step is 8.4e-8 degrees
    }
}

TEST(Projection, IsTheSameToTheLeftAndToTheRight) {
    for (int width : {1, 2, 117, 320, 7680}) {
        const Projection p = projection(width, 1, 73);
        for (int x = 0; x < width; ++x) ASSERT_EQ(p.slope(x), -p.slope(width - 1 - x)) << x << " of " << width;
    }
}

TEST(Projection, LooksThroughTheCornersOfPixelsWhereAMapSaysSo) {
    View view;
    view.ray_offset = ray_offset(RayPoint::corner);
    for (int size : {1, 2, 117, 320}) {
        const Projection corners(view, size, size), halves = projection(2 * size, 2 * size);
        for (int i = 1; i < size; ++i) {
            ASSERT_LT(corners.slope(i), halves.slope(2 * i)) << i << " of " << size;  // the middle of its left half
            ASSERT_GT(corners.slope(i), halves.slope(2 * i - 1)) << i << " of " << size;
            ASSERT_GT(corners.climb(i), halves.climb(2 * i)) << i << " of " << size;
            ASSERT_LT(corners.climb(i), halves.climb(2 * i - 1)) << i << " of " << size;
        }
        EXPECT_EQ(corners.slope(0), -corners.half_fov_tangent());
    }
    EXPECT_EQ(Projection(view, 320, 200).slope(160), 0);
    EXPECT_EQ(Projection(view, 320, 200).climb(100), 0);
}

TEST(Projection, HasTheRayOfAPixelAmongThoseOfItsParts) {
    View view;
    view.ray_offset = ray_offset(RayPoint::corner);
    const Projection one(view, 320, 200), parts(finer(view, 3), 3 * 320, 3 * 200);
    for (int x = 0; x < 320; ++x) ASSERT_EQ(parts.slope(3 * x + 1), one.slope(x)) << x;
    for (int y = 0; y < 200; ++y) ASSERT_DOUBLE_EQ(parts.climb(3 * y + 1), one.climb(y)) << y;
}

TEST(Projection, LooksExactlyAheadInTheMiddleColumnOfAnOddWidth) { EXPECT_EQ(projection(117, 83).slope(58), 0); }

TEST(Projection, LooksExactlyLevelInTheMiddleRowOfAnOddHeight) { EXPECT_EQ(projection(117, 83).climb(41), 0); }

TEST(Projection, HasNoLevelRowInAnEvenHeight) {
    const Projection p = projection(320, 200);
    EXPECT_GT(p.climb(99), 0);
    EXPECT_EQ(p.climb(99), -p.climb(100));
}

// hard case I9
TEST(Projection, KeepsColumnsBitEqualInAPictureThreeTimesAsWide) {
    for (double fov : {1.0, 53.0, 90.0, 179.0})
        for (int width : {1, 2, 117, 320}) {
            const Projection one = projection(width, 1, fov), three = projection(3 * width, 3, fov);
            for (int x = 0; x < width; ++x) ASSERT_EQ(three.slope(3 * x + 1), one.slope(x)) << x << " of " << width;
        }
}

TEST(Projection, ShearsThePictureByThePitch) {
    // Pitch 45 degrees up at fov 90: the horizon moves down by half the width.
    const Projection level = projection(320, 200), up = projection(320, 200, 90, 1);
    EXPECT_NEAR(up.horizon() - level.horizon(), 160, 1e-12);
    for (int y : {0, 77, 199}) EXPECT_NEAR(up.climb(y) - level.climb(y), 1, kRounding) << y;
}

TEST(Projection, ClimbsByTheRowsAboveTheHorizonOverTheFocalLength) {
    const Projection p = projection(320, 200, 60, 0.3, 1.2);
    for (int y : {0, 99, 199}) EXPECT_EQ(p.climb(y), p.row_from_horizon(y) / p.focal_y()) << y;
}

// hard cases R12, I14
TEST(Projection, StaysFiniteAtTheLargestPictureAndTheWidestAndNarrowestField) {
    for (double fov : {kMinFov, kMaxFov})
        for (double pitch : {-20.0, 20.0}) {
            const Projection p = projection(kMaxPictureSide, kMaxPictureSide, fov, pitch);
            EXPECT_TRUE(std::isfinite(p.slope(0)) && std::isfinite(p.climb(0)) && std::isfinite(p.horizon())) << fov;
        }
}

// hard case G13
TEST(ProjectionDeathTest, RefusesAFieldOfViewOutOfRange) {
    EXPECT_DEATH(projection(320, 200, 180), "broken contract");
    EXPECT_DEATH(projection(320, 200, 0), "broken contract");
    EXPECT_DEATH(projection(320, 200, std::numeric_limits<double>::quiet_NaN()), "broken contract");
}

TEST(ProjectionDeathTest, RefusesAPictureWithoutPixels) {
    EXPECT_DEATH(projection(0, 200), "broken contract");
    EXPECT_DEATH(projection(320, kMaxPictureSide + 1), "broken contract");
}

Tilt tilt_of(double pitch_degrees, double roll_degrees) {
    return {direction(Angle::from_degrees(pitch_degrees)), direction(Angle::from_degrees(roll_degrees))};
}

/// The ray through the middle of a picture, and the one a pixel to its right.
std::pair<Ray, Ray> rays_in_the_middle(const Tilt& tilt) {
    View view;
    view.tilt = tilt;
    const Projection p(view, 3, 3);
    return {p.ray(1, 1), p.ray(2, 1)};
}

TEST(TiltedProjection, HasTheSameRaysWhereItIsTiltedByNothing) {
    View view;
    view.fov_degrees = 77;
    const Projection upright(view, 31, 17);
    view.tilt = Tilt{};
    const Projection tilted(view, 31, 17);
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 31; ++x) {
            const Ray ray = tilted.ray(x, y);
            EXPECT_EQ(ray.ahead, 1);
            EXPECT_EQ(ray.right, upright.slope(x));
            EXPECT_EQ(ray.up, upright.climb(y));
        }
}

TEST(TiltedProjection, LooksStraightUp) {
    const Ray middle = rays_in_the_middle(tilt_of(90, 0)).first;
    EXPECT_EQ(middle.ahead, 0);
    EXPECT_EQ(middle.right, 0);
    EXPECT_EQ(middle.up, 1);
}

TEST(TiltedProjection, ShowsTheGroundToTheRightOfAHeadThatLeansRight) {
    const Ray right = rays_in_the_middle(tilt_of(0, 90)).second;
    EXPECT_EQ(right.right, 0);
    EXPECT_LT(right.up, 0);
}

TEST(TiltedProjection, KeepsTheRayInTheMiddleALengthOfOne) {
    const Ray middle = rays_in_the_middle(tilt_of(30, 50)).first;
    EXPECT_NEAR(middle.ahead * middle.ahead + middle.right * middle.right + middle.up * middle.up, 1, kRounding);
}

}  // namespace
}  // namespace enfilade
