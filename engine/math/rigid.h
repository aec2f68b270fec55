// Rigid maps of the world: what a linked portal or a mirror does to whatever passes or looks through it.
#pragma once
#include "math/vec.h"

namespace enfilade {

/// Turn (and, with flip = -1, reflection), then shift, then rise: p -> M p + shift, z -> z + rise, with
/// M = [[c, -flip s], [s, flip c]]. Quarter turns and grid shifts are exact, because products with 0 and 1 are.
struct Rigid {
    double c = 1;
    double s = 0;
    double flip = 1;  ///< 1 keeps left and right, -1 swaps them
    Vec2 shift;       ///< [m]
    double rise = 0;  ///< [m]

    constexpr bool operator==(const Rigid&) const = default;
    constexpr bool is_identity() const { return *this == Rigid{}; }

    constexpr Vec2 turn(Vec2 d) const { return {c * d.x - flip * s * d.y, s * d.x + flip * c * d.y}; }
    constexpr Vec2 apply(Vec2 p) const { return turn(p) + shift; }
    constexpr double apply_height(double z) const { return z + rise; }
};

/// first, then second.
constexpr Rigid then(const Rigid& first, const Rigid& second) {
    return {second.c * first.c - second.flip * second.s * first.s,
            second.s * first.c + second.flip * second.c * first.s, first.flip * second.flip, second.apply(first.shift),
            first.rise + second.rise};
}

/// The way back. A reflection's matrix is its own inverse; a turn's is the turn by -s.
constexpr Rigid inverse(const Rigid& m) {
    Rigid back{m.c, m.flip > 0 ? -m.s : m.s, m.flip, {}, -m.rise};
    back.shift = -back.turn(m.shift);
    return back;
}

}  // namespace enfilade
