// Doom's own texel positions: as far off as was measured of them elsewhere.
#include "render/column/vanilla.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/angle.h"

namespace enfilade::column {
namespace {

struct Errors {
    std::vector<double> sorted;
    double mean = 0;

    explicit Errors(std::vector<double> of) : sorted(std::move(of)) {
        std::ranges::sort(sorted);
        for (const double error : sorted) mean += error / static_cast<double>(sorted.size());
    }
    double at(double part) const { return sorted[static_cast<std::size_t>(part * double(sorted.size() - 1))]; }
};

constexpr VanillaScreen kScreen{1280, 640};
constexpr double kVanillaRows = 720;

/// A wall from 50 to 1000 units ahead, 128 high, seen at half its height.
Errors errors_of_slanted_wall() {
    const Vec2 left{-40, 50}, right{900, 1000}, along = right - left;
    const VanillaWall wall(kScreen, left, right);
    std::vector<double> errors;
    for (int x = 128; x < 1216; ++x) {
        const double slope = (x - 640) / 640.0;  // of the column's left edge, which the tables are of
        const double part = (slope * left.y - left.x) / (along.x - slope * along.y);
        const double per_row = (left.y + part * along.y) / 640;
        const double u = std::fabs(part * std::sqrt(dot(along, along)) - wall.along_at(x));
        for (double row = -kVanillaRows / 2; row < kVanillaRows / 2; ++row)
            if (std::fabs(row * per_row) <= 64)
                errors.push_back(std::max(u, std::fabs(row * (per_row - wall.per_row_at(x)))));
    }
    return Errors(errors);
}

/// A floor 41 units under the eye, up to 4096 ahead.
Errors errors_of_floor(double radians) {
    const Vec2 forward = direction(Angle::from_radians(radians));
    const VanillaFlat flat(kScreen, 41, forward, 1);
    std::vector<double> errors;
    for (double rows = 0.5; rows < kVanillaRows / 2; ++rows) {
        const double depth = 41 * 640 / rows;
        for (int x = 0; x < 1280 && depth <= 4096; ++x) {
            const Vec2 exact = (forward + right_of(forward) * ((x + 0.5 - 640) / 640)) * depth;
            const Vec2 off = flat.at(x, rows, 640) - exact;
            errors.push_back(std::max(std::fabs(off.x), std::fabs(off.y)));
        }
    }
    return Errors(errors);
}

// Measured by a prototype of the same formulas: 0.17, 9.1 and 16.4 texels.
TEST(VanillaWall, IsAsFarOffAsMeasuredElsewhere) {
    const Errors errors = errors_of_slanted_wall();
    EXPECT_NEAR(errors.mean, 0.17, 0.017);
    EXPECT_NEAR(errors.at(0.999), 9.1, 0.91);
    EXPECT_NEAR(errors.at(1), 16.4, 1.64);
}

// 3.3, 61 and 77 texels for one view; how far a step across the screen is cut off depends on where it goes.
TEST(VanillaFlat, IsAsFarOffAsMeasuredElsewhere) {
    double mean = 0, most = 0;
    for (const double radians : {0.3, 0.7, 1.1, 2.3, 3.9, 5.2}) {
        const Errors errors = errors_of_floor(radians);
        mean = std::max(mean, errors.mean);
        most = std::max(most, errors.at(1));
    }
    EXPECT_NEAR(mean, 3.3, 0.33);
    EXPECT_NEAR(most, 77, 8);
}

TEST(VanillaFlat, LiesTheOtherWayRoundInAMirror) {
    const Vec2 forward{1, 0};
    const VanillaFlat plain(kScreen, 41, forward, 1), mirrored(kScreen, 41, forward, -1);
    for (const int x : {100, 640, 1200}) {
        EXPECT_NEAR(plain.at(x, 100, 640).x, mirrored.at(x, 100, 640).x, 2);
        EXPECT_NEAR(plain.at(x, 100, 640).y, -mirrored.at(x, 100, 640).y, 2);
    }
}

}  // namespace
}  // namespace enfilade::column
