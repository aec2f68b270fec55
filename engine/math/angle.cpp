#include "math/angle.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace enfilade {
namespace {

constexpr std::uint32_t kQuarter = 1u << 30;
constexpr std::uint32_t kEighth = 1u << 29;

/// Taylor series; at x <= pi/4 the first term left out is below 2^-56.
double sine_up_to_eighth(double x) {
    const double q = x * x;
    double sum = -1.0 / 1307674368000.0;
    for (double c : {1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0, -1.0 / 5040.0, 1.0 / 120.0, -1.0 / 6.0})
        sum = sum * q + c;
    return x + x * (q * sum);
}

double cosine_up_to_eighth(double x) {
    const double q = x * x;
    double sum = 1.0 / 20922789888000.0;
    for (double c :
         {-1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0, 1.0 / 40320.0, -1.0 / 720.0, 1.0 / 24.0})
        sum = sum * q + c;
    return 1.0 - (0.5 * q - q * (q * sum));
}

/// (cos, sin) for steps in [0, kQuarter).
Vec2 first_quadrant(std::uint32_t steps) {
    constexpr double kRadiansPerStep = std::numbers::pi / 2147483648.0;
    if (steps == kEighth) return {std::sqrt(0.5), std::sqrt(0.5)};
    if (steps < kEighth) {
        const double x = steps * kRadiansPerStep;
        return {cosine_up_to_eighth(x), sine_up_to_eighth(x)};
    }
    const double x = (kQuarter - steps) * kRadiansPerStep;
    return {sine_up_to_eighth(x), cosine_up_to_eighth(x)};
}

/// atan(t) / (2 pi) for t in [0, 1]. Above tan(pi/8) the argument is turned back by an eighth, so that the series
/// runs over |t| <= 0.4143, where the first term left out is below 1e-14.
double turn_of_slope(double t) {
    const bool turned = t > 0.41421356237309503;
    if (turned) t = (t - 1) / (t + 1);
    const double q = t * t;
    double sum = 0;
    for (int k = 33; k >= 1; k -= 2) sum = 1.0 / k - q * sum;
    return (turned ? 0.125 : 0.0) + t * sum * (0.5 / std::numbers::pi);
}

}  // namespace

Angle Angle::from_degrees(double degrees) {
    const double turn = std::fmod(degrees, 360.0) / 360.0;  // fmod is exact, on every machine: so are whole turns
    const double fraction = turn < 0 ? turn + 1 : turn;
    return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(fraction * 4294967296.0 + 0.5))};
}

Angle Angle::from_radians(double radians) { return from_degrees(radians * (180.0 / std::numbers::pi)); }

Vec2 direction(Angle angle) {
    const Vec2 d = first_quadrant(angle.steps & (kQuarter - 1));
    switch (angle.steps >> 30) {
        case 0: return d;
        case 1: return {-d.y, d.x};
        case 2: return {-d.x, -d.y};
        default: return {d.y, -d.x};
    }
}

double tangent(Angle angle) {
    const Vec2 d = direction(angle);
    return d.y / d.x;
}

double turn_of(Vec2 v) {
    const double ax = std::fabs(v.x), ay = std::fabs(v.y);
    if (ax == 0 && ay == 0) return 0;
    double turn = ax >= ay ? turn_of_slope(ay / ax) : 0.25 - turn_of_slope(ax / ay);
    if (v.x < 0) turn = 0.5 - turn;
    if (v.y < 0) turn = 1 - turn;
    return turn >= 1 ? 0 : turn;
}

Angle angle_of(Vec2 v) {
    return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(turn_of(v) * 4294967296.0 + 0.5))};
}

std::uint64_t fine_turn_of(Vec2 unit) {
    if (unit.y < 0) return 0 - fine_turn_of({unit.x, -unit.y});
    constexpr double kStepsPerRadian = 0x1p63 / std::numbers::pi;
    const Angle nearest = angle_of(unit);
    const Vec2 d = direction(nearest);
    const double sine_of_rest = unit.y * d.x - unit.x * d.y;  // below 1e-9: as good as the angle itself
    const auto rest = static_cast<std::int64_t>(sine_of_rest * kStepsPerRadian);
    return (std::uint64_t{nearest.steps} << 32) + static_cast<std::uint64_t>(rest);
}

}  // namespace enfilade
