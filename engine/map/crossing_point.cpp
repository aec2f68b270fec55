#include "map/crossing_point.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "formats/number_text.h"
#include "math/grid.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

/// A fraction in lowest terms, denominator > 0.
struct Fraction {
    Int128 over;
    Int128 under;
};

Int128 size_of(Int128 x) { return x < 0 ? -x : x; }

Fraction lowest_terms(Int128 over, Int128 under) {
    Int128 a = size_of(over), b = size_of(under);
    while (b != 0) a = std::exchange(b, a % b);
    if (under < 0) a = -a;
    return {over / a, under / a};
}

std::string digits(Int128 x) {
    std::string text;
    for (Int128 rest = size_of(x); rest != 0 || text.empty(); rest /= 10)
        text += static_cast<char>('0' + static_cast<int>(rest % 10));
    if (x < 0) text += '-';
    std::reverse(text.begin(), text.end());
    return text;
}

double value(Fraction f) { return static_cast<double>(f.over) / static_cast<double>(f.under); }

/// True where a decimal with the digits of a double says it exactly: the denominator is a power of two, and both fit.
bool is_decimal(Fraction f) {
    constexpr Int128 kExact = Int128{1} << 53;
    return (f.under & (f.under - 1)) == 0 && size_of(f.over) <= kExact && f.under <= kExact;
}

std::string exact(Fraction f) { return is_decimal(f) ? number_text(value(f)) : digits(f.over) + "/" + digits(f.under); }

/// To a thousandth: where to look on the drawing.
std::string about(Fraction f) {
    const double thousandths = value(f) * 1000;
    const auto whole = static_cast<std::int64_t>(thousandths < 0 ? thousandths - 0.5 : thousandths + 0.5);
    return number_text(static_cast<double>(whole) / 1000);
}

/// A coordinate in whole steps of the vertex grid.
Int128 steps(double x) { return static_cast<Int128>(x / kVertexGrid); }

}  // namespace

std::string crossing_text(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    // p = a + (b - a) t with t = cross(c - a, d - c) / cross(b - a, d - c): below 2^26 * 2^54 in steps.
    const Int128 ex = steps(b.x - a.x), ey = steps(b.y - a.y), fx = steps(d.x - c.x), fy = steps(d.y - c.y);
    const Int128 over = steps(c.x - a.x) * fy - steps(c.y - a.y) * fx, under = ex * fy - ey * fx;
    constexpr Int128 kStepsPerMetre = 1024;
    const Fraction x = lowest_terms(steps(a.x) * under + ex * over, under * kStepsPerMetre);
    const Fraction y = lowest_terms(steps(a.y) * under + ey * over, under * kStepsPerMetre);
    const std::string point = "(" + exact(x) + ", " + exact(y) + ")";
    if (is_decimal(x) && is_decimal(y)) return point;
    return point + ", about (" + about(x) + ", " + about(y) + ")";
}

}  // namespace enfilade
