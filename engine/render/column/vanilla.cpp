#include "render/column/texel_dials.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace enfilade::column {
namespace {

constexpr std::uint32_t kQuarterTurn = 1u << 30;
constexpr int kFineShift = 19;     // 8192 angles a turn
constexpr int kSlopeSteps = 2048;  // of tangents from 0 to 1
constexpr Fixed kOne = 1 << 16;
constexpr Fixed kMostScale = 64 * kOne, kLeastScale = 256;
constexpr Angle kAhead{kQuarterTurn};

Fixed fixed(double number) {
    constexpr double kMost = std::numeric_limits<Fixed>::max();
    return static_cast<Fixed>(std::clamp(std::floor(number * kOne), -kMost, kMost));
}
double real(Fixed number) { return number / 65536.0; }

Fixed product(Fixed a, Fixed b) { return static_cast<Fixed>((std::int64_t{a} * b) >> 16); }

Fixed quotient(Fixed a, Fixed b) {
    constexpr int kSpare = 14;  // bits, beyond which the quotient may not fit
    if (std::abs(std::int64_t{a}) >> kSpare >= std::abs(std::int64_t{b}))
        return (a ^ b) < 0 ? std::numeric_limits<Fixed>::min() : std::numeric_limits<Fixed>::max();
    return static_cast<Fixed>((std::int64_t{a} << 16) / b);
}

/// The middle of the table's step.
Vec2 fine_direction(Angle angle) { return direction({(angle.steps >> kFineShift << kFineShift) + (1u << 18)}); }
Fixed fine_sine(Angle angle) { return fixed(fine_direction(angle).y); }
Fixed fine_cosine(Angle angle) { return fixed(fine_direction(angle).x); }

/// Of an angle from 0 to half a turn, less a quarter.
Fixed fine_tangent(Angle angle) {
    const Vec2 fine = fine_direction(angle - kAhead);
    return fixed(fine.y / fine.x);
}

/// 0 <= rise <= run.
Angle slope_angle(Fixed rise, Fixed run) {
    constexpr Fixed kShortest = 512;
    const std::int64_t slope =
        run < kShortest ? kSlopeSteps : std::min<std::int64_t>(kSlopeSteps, (std::int64_t{rise} << 3) / (run >> 8));
    return angle_of({double(kSlopeSteps), static_cast<double>(slope)});
}

/// Left of ahead, of a place `ahead` and so far to the left.
Angle angle_to(Fixed ahead, Fixed left) {
    const Fixed x = std::abs(ahead), y = std::abs(left);
    Angle angle = x > y ? slope_angle(y, x) : kAhead - slope_angle(x, y);
    if (ahead < 0) angle = kAhead + kAhead - angle;
    return left < 0 ? Angle{} - angle : angle;
}

Fixed distance_to(Fixed ahead, Fixed left) {
    const Fixed x = std::max(std::abs(ahead), std::abs(left)), y = std::min(std::abs(ahead), std::abs(left));
    constexpr int kSlopeShift = 5;  // from 65536 to kSlopeSteps
    const Angle angle = angle_of({double(kSlopeSteps), double(quotient(y, std::max(x, 1)) >> kSlopeShift)});
    return quotient(x, fine_sine(angle + kAhead));
}

/// The first column whose middle is not left of an end of a wall: in [0, width].
int column_from(const VanillaScreen& screen, Vec2 end, int behind) {
    if (end.y <= 0) return behind;
    const double column = screen.width() / 2.0 + screen.columns_per_slope() * end.x / end.y;
    return static_cast<int>(std::clamp(std::ceil(column - 0.5), 0.0, double(screen.width())));
}

}  // namespace

VanillaScreen::VanillaScreen(int width, double columns_per_slope)
    : width_(width), columns_per_slope_(columns_per_slope) {
    const Angle half = angle_of({columns_per_slope, width / 2.0});
    columns_per_tangent_ = (std::int64_t{fixed(width / 2.0)} << 16) / fine_tangent(kAhead + half);
}

/// Tangents are those of the middles of fine angles, and what the multiplication cuts off puts the edge of the screen
/// one fine angle farther out.
int VanillaScreen::first_column(Angle fine) const {
    const std::int64_t from_middle = (std::int64_t{fine_tangent(kAhead + fine)} * columns_per_tangent_) >> 16;
    return static_cast<int>((fixed(width_ / 2.0) - from_middle + (kOne - 1)) >> 16);
}

Angle VanillaScreen::column_angle(int x) const {
    constexpr std::uint32_t kFineStep = 1u << kFineShift;
    const Angle near = angle_of({double(columns_per_tangent_) / kOne, width_ / 2.0 - x});
    Angle fine{((near.steps >> kFineShift) - 1) << kFineShift};  // too far to the right by one or two
    while (first_column(fine) > x) fine.steps += kFineStep;
    return fine;
}

VanillaWall::VanillaWall(const VanillaScreen& screen, Vec2 left, Vec2 right) : screen_(screen) {
    constexpr int kWallAngleShift = 16;  // of the angles that maps were saved with
    const Fixed ahead = fixed(left.y), to_left = fixed(-left.x);
    const Vec2 along = right - left;
    const Angle exact = angle_of({along.y, -along.x});
    const Angle wall{(exact.steps + (1u << (kWallAngleShift - 1))) >> kWallAngleShift << kWallAngleShift};
    normal_ = wall + kAhead;
    const Angle to_end = normal_ - angle_to(ahead, to_left);
    const bool is_left = to_end.steps < 2 * kQuarterTurn;
    const Angle apart{std::min(is_left ? to_end.steps : -to_end.steps, kQuarterTurn)};
    const Fixed reach = distance_to(ahead, to_left);
    distance_ = product(reach, fine_sine(kAhead - apart));
    offset_ = product(reach, fine_sine(apart)) * (is_left ? -1 : 1);
    first_ = std::min(column_from(screen, left, 0), screen.width() - 1);
    const int last = column_from(screen, right, screen.width()) - 1;
    scale_ = scale_at(first_);
    if (last > first_) scale_step_ = (scale_at(last) - scale_) / (last - first_);
}

double VanillaWall::along_at(int x) const {
    const Angle angle = kAhead - normal_ + screen_.column_angle(x);
    return real(offset_) - real(product(fine_tangent(angle), distance_));
}

double VanillaWall::per_row_at(int x) const {
    const std::int64_t scale = scale_ + std::int64_t{x - first_} * scale_step_;
    return real(static_cast<Fixed>(0xFFFFFFFFu / std::max<std::int64_t>(scale, kLeastScale)));
}

Fixed VanillaWall::scale_at(int x) const {
    const Angle column = screen_.column_angle(x);
    const Fixed sine_ahead = fine_sine(kAhead + column), sine_wall = fine_sine(kAhead + column - normal_);
    const Fixed over = product(fixed(screen_.columns_per_slope()), sine_wall), under = product(distance_, sine_ahead);
    if (under <= over >> 16) return kMostScale;
    return std::clamp(quotient(over, under), kLeastScale, kMostScale);
}

VanillaFlat::VanillaFlat(const VanillaScreen& screen, double height, Vec2 forward, double flip)
    : height_(fixed(std::fabs(height))) {
    const Fixed columns = fixed(screen.columns_per_slope());
    const Angle ahead = angle_of(forward), across = flip < 0 ? ahead - kAhead : ahead + kAhead;
    const Angle start = screen.column_angle(0);
    const Angle turned = flip < 0 ? ahead + start : ahead - start;
    start_cos_ = fine_cosine(turned);
    start_sin_ = fine_sine(turned);
    start_length_ = quotient(kOne, std::abs(fine_cosine(start)));
    step_x_ = quotient(fine_cosine(across), columns);
    step_y_ = quotient(fine_sine(across), columns);
}

Vec2 VanillaFlat::at(int x, double rows, double rows_per_rise) const {
    const Fixed distance = product(height_, quotient(fixed(rows_per_rise), std::max(fixed(rows), 1)));
    const Fixed length = product(distance, start_length_);
    const auto place = [&](Fixed start, Fixed step) {
        return (product(start, length) + static_cast<double>(x) * product(distance, step)) / 65536.0;
    };
    return {place(start_cos_, step_x_), place(start_sin_, step_y_)};
}

}  // namespace enfilade::column
