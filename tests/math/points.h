// Points for the tests of exact geometry: random ones on either grid, and triples that are as close to a line as
// grid points can be.
#pragma once
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/hash.h"
#include "math/vec.h"

namespace enfilade::test {

/// A corner of a triangle a, b, c.
struct Triple {
    Vec2 a, b, c;
};

/// A random multiple of grid with size below limit; small numbers are as likely as large ones.
inline double random_coordinate(Random& random, double grid, double limit) {
    const double size =
        std::ldexp(limit, -static_cast<int>(random.below(static_cast<std::uint64_t>(std::ilogb(limit / grid)))));
    return std::trunc(random.uniform(-size, size) / grid) * grid;
}

inline Vec2 random_point(Random& random, double grid, double limit = kWorldLimit) {
    return {random_coordinate(random, grid, limit), random_coordinate(random, grid, limit)};
}

/// Coefficients x, y with a x - b y = 1, for coprime a, b > 0; 0 <= x <= b, 0 <= y <= a (extended Euclid).
inline std::pair<std::int64_t, std::int64_t> bezout(std::int64_t a, std::int64_t b) {
    std::int64_t r0 = a, r1 = b, x0 = 1, x1 = 0;
    while (r1 != 0) {
        const std::int64_t q = r0 / r1;
        r0 = std::exchange(r1, r0 - q * r1);
        x0 = std::exchange(x1, x0 - q * x1);
    }
    const std::int64_t x = x0 > 0 ? x0 : x0 + b;
    __extension__ const auto y = static_cast<std::int64_t>((static_cast<__int128>(a) * x - 1) / b);
    return {x, y};
}

/// Three points whose determinant cross(b - a, c - a) is one unit (grid^2), or minus one, at the full range of the
/// world: the least that is not zero, so the hardest that is not a tie.
inline Triple nearly_straight(Random& random, double grid) {
    const auto whole = static_cast<std::uint64_t>(2 * kWorldLimit / grid);
    std::int64_t u = 0, v = 0;
    do {
        u = static_cast<std::int64_t>(1 + random.below(whole - 1));
        v = static_cast<std::int64_t>(1 + random.below(whole - 1));
    } while (std::gcd(u, v) != 1);
    const auto [x, y] = bezout(u, v);  // u x - v y = 1: cross((u, v), (y, x)) = u x - v y
    const Vec2 corner{-kWorldLimit, -kWorldLimit};
    Triple t{corner, corner + Vec2{static_cast<double>(u), static_cast<double>(v)} * grid,
             corner + Vec2{static_cast<double>(y), static_cast<double>(x)} * grid};
    if (random.below(2)) std::swap(t.b, t.c);
    return t;
}

/// Three points on one line, in any order; two of them may coincide, but not a and b.
inline Triple straight(Random& random, double grid) {
    const auto small = [&] { return static_cast<double>(random.below(41)) - 20; };
    const Vec2 origin = random_point(random, grid, kWorldLimit / 2);
    Vec2 step{small(), small()};
    if (step == Vec2{}) step.x = 1;
    const double reach = std::trunc(random.uniform(1, kWorldLimit / 2 / 20 / grid));
    const double at_b = random.below(2) ? reach : 1;
    const double at_c = std::trunc(random.uniform(-reach, reach + 1));
    return {origin, origin + step * (at_b * grid), origin + step * (at_c * grid)};
}

}  // namespace enfilade::test
