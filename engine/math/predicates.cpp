#include "math/predicates.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>

#include "base/result.h"

namespace enfilade {
namespace {

__extension__ using UInt128 = unsigned __int128;

/// A vector in whole grid units: |components| <= 2^49.
struct GridVec {
    std::int64_t x;
    std::int64_t y;
};

GridVec difference(Vec2 to, Vec2 from) {
    return {to_grid_units(to.x) - to_grid_units(from.x), to_grid_units(to.y) - to_grid_units(from.y)};
}

/// <= 2^99 in size.
Int128 cross(GridVec a, GridVec b) { return Int128{a.x} * b.y - Int128{a.y} * b.x; }

template <class T>
int sign(T x) {
    return (x > 0) - (x < 0);
}

Int128 dot(GridVec a, GridVec b) { return Int128{a.x} * b.x + Int128{a.y} * b.y; }

/// The sign of d + d1 e + d2 e^2.
int sign_with_ties(Int128 d, Int128 d1, Int128 d2) {
    if (d != 0) return sign(d);
    return d1 != 0 ? sign(d1) : sign(d2);
}

/// A 256-bit product as two halves.
struct Wide {
    UInt128 high;
    UInt128 low;
    auto operator<=>(const Wide&) const = default;
};

Wide multiply(UInt128 a, UInt128 b) {
    constexpr UInt128 kMask = ~std::uint64_t{0};
    const UInt128 low = (a & kMask) * (b & kMask);
    const UInt128 mid_1 = (a >> 64) * (b & kMask) + (low >> 64);
    const UInt128 mid_2 = (a & kMask) * (b >> 64) + (mid_1 & kMask);
    return {(a >> 64) * (b >> 64) + (mid_1 >> 64) + (mid_2 >> 64), (mid_2 << 64) | (low & kMask)};
}

UInt128 magnitude(Int128 x) { return x < 0 ? -static_cast<UInt128>(x) : static_cast<UInt128>(x); }

}  // namespace

int side_of_line(Vec2 a, Vec2 b, Vec2 p) {
    const GridVec along = difference(b, a);
    const int side = sign_with_ties(cross(along, difference(p, a)), -Int128{along.y}, Int128{along.x});
    ENFILADE_DCHECK(side != 0);
    return side;
}

int side_of_path(Vec2 p, Vec2 q, Vec2 v) {
    const GridVec path = difference(q, p);
    const int side = sign_with_ties(cross(path, difference(v, p)), Int128{path.y}, -Int128{path.x});
    ENFILADE_DCHECK(side != 0);
    return side;
}

Int128 whole_cross(Vec2 a, Vec2 b, Vec2 p) { return cross(difference(b, a), difference(p, a)); }

double exact_cross(Vec2 a, Vec2 b, Vec2 p) { return static_cast<double>(whole_cross(a, b, p)) * 0x1p-64; }

PathFraction fraction_along_path(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
    const GridVec along = difference(b, a);
    const Int128 at_p = cross(along, difference(p, a));
    const Int128 at_q = cross(along, difference(q, a));
    const int flip = at_p > at_q ? 1 : -1;
    return {at_p * flip, (at_p - at_q) * flip, -Int128{along.y} * flip, Int128{along.x} * flip};
}

int compare(const PathFraction& s, const PathFraction& t) {
    if (int c = compare_products(s.numerator, t.denominator, t.numerator, s.denominator)) return c;
    if (int c = compare_products(s.tie_1, t.denominator, t.tie_1, s.denominator)) return c;
    return compare_products(s.tie_2, t.denominator, t.tie_2, s.denominator);
}

bool path_leaves_through(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
    // Where p == q the first two contradict each other, so side_of_path() is never asked about a point.
    return side_of_line(a, b, p) > 0 && side_of_line(a, b, q) < 0 && side_of_path(p, q, a) < 0 &&
           side_of_path(p, q, b) > 0;
}

namespace {

/// Whether the line through the start of `along` passes p nearer than r, if numbers of 53 bits tell.
std::optional<bool> is_line_clearly_nearer(GridVec along, GridVec to_p, std::int64_t r) {
    // More than all roundings here, as a part of what is rounded.
    constexpr double kDoubt = 0x1p-48;
    const double ax = static_cast<double>(along.x), ay = static_cast<double>(along.y), rr = static_cast<double>(r);
    const double left = ax * static_cast<double>(to_p.y), right = ay * static_cast<double>(to_p.x);
    const double area = std::fabs(left - right), doubt = (std::fabs(left) + std::fabs(right)) * kDoubt;
    const double most = rr * rr * (ax * ax + ay * ay);
    const double high = area + doubt, low = std::max(area - doubt, 0.0);
    if (high * high < most * (1 - kDoubt)) return true;
    if (low * low > most * (1 + kDoubt)) return false;
    return {};
}

}  // namespace

bool segment_is_nearer(Vec2 a, Vec2 b, Vec2 p, double radius) {
    if (radius <= 0) return false;
    const GridVec along = difference(b, a), to_p = difference(p, a);
    const std::int64_t r = to_grid_units(radius);
    const Int128 r_squared = Int128{r} * r;
    const Int128 length_squared = dot(along, along), foot = dot(along, to_p);
    if (foot <= 0) return dot(to_p, to_p) < r_squared;
    if (foot >= length_squared) return dot(difference(p, b), difference(p, b)) < r_squared;
    if (const auto is_nearer = is_line_clearly_nearer(along, to_p, r)) return *is_nearer;
    const Int128 area = cross(along, to_p);
    return compare_products(area, area, r_squared, length_squared) < 0;
}

int compare_products(Int128 a, Int128 b, Int128 c, Int128 d) {
    const int sign_1 = sign(a) * sign(b);
    const int sign_2 = sign(c) * sign(d);
    if (sign_1 != sign_2) return sign_1 < sign_2 ? -1 : 1;
    const Wide left = multiply(magnitude(a), magnitude(b));
    const Wide right = multiply(magnitude(c), magnitude(d));
    if (left == right) return 0;
    return (left < right) == (sign_1 > 0) ? -1 : 1;
}

}  // namespace enfilade
