// Doom's own texel positions: as far off as was measured of them elsewhere.
#include "render/column/texel_dials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/angle.h"

namespace enfilade::column {
namespace {

/// Of the places that pixels show, how far off they are [texels] and how many are on another texel [%].
struct Figures {
    double mean = 0, per_mille = 0, largest = 0, wrong = 0;
};

class Errors {
public:
    void add(Vec2 drawn, Vec2 exact) {
        const Vec2 off = drawn - exact;
        errors_.push_back(std::max(std::fabs(off.x), std::fabs(off.y)));
        wrong_ += std::floor(drawn.x) != std::floor(exact.x) || std::floor(drawn.y) != std::floor(exact.y);
    }
    std::size_t count() const { return errors_.size(); }

    Figures figures() {
        std::ranges::sort(errors_);
        const double count = double(errors_.size());
        Figures figures{0, errors_[static_cast<std::size_t>(0.999 * (count - 1))], errors_.back(),
                        100 * wrong_ / count};
        for (const double error : errors_) figures.mean += error / count;
        return figures;
    }

private:
    std::vector<double> errors_;
    double wrong_ = 0;
};

/// Screens with a field of view of 90 degrees.
struct Size {
    int width, height;
    double columns_per_slope() const { return width / 2.0; }
    VanillaScreen screen() const { return {width, columns_per_slope()}; }
};
constexpr Size kLarge{1280, 720}, kOld{320, 200};
constexpr double kEyeHeight = 41, kWallHeight = 128;

void expect_within_a_tenth(double measured, double elsewhere) { EXPECT_NEAR(measured, elsewhere, 0.1 * elsewhere); }

/// A wall that stands on the floor, ends in view space. Its rows are counted from the horizon, as they were.
Errors errors_of_wall(const Size& size, Vec2 left, Vec2 right) {
    const double focus = size.columns_per_slope(), middle = size.width / 2.0, top = kWallHeight - kEyeHeight;
    const Vec2 along = right - left;
    const VanillaWall wall(size.screen(), left, right);
    Errors errors;
    for (int x = 0; x < size.width; ++x) {
        const double slope = (x + 0.5 - middle) / focus;
        const double part = (slope * left.y - left.x) / (along.x - slope * along.y);
        if (part < 0 || part >= 1) continue;
        const double per_row = (left.y + part * along.y) / focus, u = part * std::sqrt(dot(along, along));
        for (int row = -size.height / 2; row < size.height / 2; ++row) {
            const double v = top + (row + 0.5) * per_row;
            if (0 <= v && v <= kWallHeight) errors.add({wall.along_at(x), top + row * wall.per_row_at(x)}, {u, v});
        }
    }
    return errors;
}

/// From 50 to 1000 units ahead, in columns 128 to 1216 of 1280; its ends moved by parts of such a column.
Errors errors_of_slanted_wall(const Size& size, double left_moved = 0, double right_moved = 0) {
    return errors_of_wall(size, {(-512 + left_moved) / 640 * 50, 50}, {(576 + right_moved) / 640 * 1000, 1000});
}
/// From 1600 to 2600 units ahead, in columns 128 to 1220: with 45154 pixels there, 45150 here.
Errors errors_of_far_wall() { return errors_of_wall(kLarge, {-512.0 / 640 * 1600, 1600}, {580.0 / 640 * 2600, 2600}); }

/// The floor up to 4096 units ahead, from the place and by the look of those measurements: there y goes up.
Errors errors_of_floor(const Size& size) {
    const Vec2 eye{1000.37, 777.21}, forward = direction(Angle::from_radians(-0.3));
    const double focus = size.columns_per_slope();
    const VanillaFlat flat(size.screen(), kEyeHeight, forward, 1);
    Errors errors;
    for (double rows = 0.5; rows < size.height / 2; ++rows) {
        const double depth = kEyeHeight * focus / rows;
        for (int x = 0; x < size.width && depth <= 4096; ++x) {
            const Vec2 ray = forward + right_of(forward) * ((x + 0.5 - focus) / focus);
            errors.add(eye + flat.at(x, rows, focus), eye + ray * depth);
        }
    }
    return errors;
}

/// The range of a figure over walls whose ends are up to half a column beside where they are said to be.
struct Range {
    double least = 1e9, most = 0;
    void add(double figure) {
        least = std::min(least, figure);
        most = std::max(most, figure);
    }
    bool holds(double figure) const { return least <= figure && figure <= most; }
};

template <class Measure>
Range range_of(Measure measure) {
    Range range;
    for (const double left : {-0.4, -0.2, 0.0, 0.2, 0.4})
        for (const double right : {-0.4, -0.2, 0.0, 0.2, 0.4}) range.add(measure(left, right));
    return range;
}

// Measured by a prototype of the same formulas. Walls: 9.1 and 16.4 texels, 27 % wrong; on the old screen 50 and 57 %;
// far away 4.8 texels, all wrong.
TEST(VanillaWall, IsAsFarOffAsMeasuredElsewhere) {
    Errors large = errors_of_slanted_wall(kLarge);
    EXPECT_EQ(large.count(), 614193u);  // pixels, there as here
    expect_within_a_tenth(large.figures().per_mille, 9.1);
    expect_within_a_tenth(large.figures().largest, 16.4);
    expect_within_a_tenth(large.figures().wrong, 27);
    const Figures old = errors_of_slanted_wall(kOld).figures();
    expect_within_a_tenth(old.largest, 50);
    expect_within_a_tenth(old.wrong, 57);
    expect_within_a_tenth(errors_of_far_wall().figures().largest, 4.8);
    expect_within_a_tenth(errors_of_far_wall().figures().wrong, 100);
}

// A mean of 0.17 and of 0.80 texels: by which fine angle a wall is drawn depends on parts of a column in its ends,
// which are not told.
TEST(VanillaWall, IsOffByMoreOrLessWithPartsOfAColumn) {
    EXPECT_TRUE(range_of([](double left, double right) {
                    return errors_of_slanted_wall(kLarge, left, right).figures().mean;
                }).holds(0.17));
    EXPECT_TRUE(range_of([](double left, double right) {
                    return errors_of_slanted_wall(kOld, left, right).figures().mean;
                }).holds(0.80));
}

// 3.3, 61 and 77 texels, 92 % wrong; on the old screen 1.5, 17 and 17 texels, 78 %.
TEST(VanillaFlat, IsAsFarOffAsMeasuredElsewhere) {
    const Figures large = errors_of_floor(kLarge).figures(), old = errors_of_floor(kOld).figures();
    expect_within_a_tenth(large.mean, 3.3);
    expect_within_a_tenth(large.per_mille, 61);
    expect_within_a_tenth(large.largest, 77);
    expect_within_a_tenth(large.wrong, 92);
    expect_within_a_tenth(old.mean, 1.5);
    expect_within_a_tenth(old.per_mille, 17);
    expect_within_a_tenth(old.largest, 17);
    expect_within_a_tenth(old.wrong, 78);
}

// The tables put the edge of a screen of 90 degrees one fine angle farther out than 45 degrees.
TEST(VanillaScreen, LooksOneFineAngleTooFarOutAtItsEdge) {
    constexpr std::uint32_t kFineStep = 1u << 19;
    for (const Size& size : {kLarge, kOld}) {
        EXPECT_EQ(size.screen().column_angle(0).steps, 1025 * kFineStep);
        EXPECT_EQ(size.screen().column_angle(size.width / 2).steps, 0u);
    }
}

TEST(VanillaScreen, LooksWhereItShouldByAnyFieldOfView) {
    constexpr double kFineAngles = 8192;
    for (const double degrees : {1.0, 60.0, 90.0, 120.0}) {
        const double focus = 640 / tangent(Angle::from_degrees(degrees / 2));
        const VanillaScreen screen(1280, focus);
        for (int x = 0; x <= 1280; x += 16) {
            const Angle off = screen.column_angle(x) - angle_of({focus, 640.0 - x});
            EXPECT_LE(std::fabs(static_cast<std::int32_t>(off.steps) / 4294967296.0), 1.5 / kFineAngles)
                << degrees << " degrees, column " << x;
        }
    }
}

TEST(VanillaScreen, NeverTurnsBackByTheWidestFieldOfView) {
    const VanillaScreen screen(1280, 640 / tangent(Angle::from_degrees(179.0 / 2)));
    for (int x = 0; x < 1280; ++x) {
        const Angle step = screen.column_angle(x) - screen.column_angle(x + 1);
        EXPECT_LT(step.steps, 1u << 31) << "column " << x;
    }
}

TEST(VanillaFlat, LiesTheOtherWayRoundInAMirror) {
    const Vec2 forward{1, 0};
    const VanillaFlat plain(kLarge.screen(), 41, forward, 1), mirrored(kLarge.screen(), 41, forward, -1);
    for (const int x : {100, 640, 1200}) {
        EXPECT_NEAR(plain.at(x, 100, 640).x, mirrored.at(x, 100, 640).x, 2);
        EXPECT_NEAR(plain.at(x, 100, 640).y, -mirrored.at(x, 100, 640).y, 2);
    }
}

}  // namespace
}  // namespace enfilade::column
