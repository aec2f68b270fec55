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

// What a linked portal does to a point on the point grid: carries the grid onto itself, one to one, so that whoever
// goes back comes to the very point he left, whatever the link's angle.

/// A turn and a shift of the point grid. Quarter turns are exact. What is left of the angle, at most 45 degrees, are
/// three shears, each rounded to the grid: x -= t y, y += s x, x -= t y with t = tan(angle / 2), s = sin(angle).
/// A rounded shear is taken back exactly by the opposite one, and the three of the opposite angle are those, backward.
/// Source: A. W. Paeth, "A Fast Algorithm for General Raster Rotation", 1986; rounded shears as in lossless coding:
/// F. A. M. L. Bruekers, A. W. M. van den Enden, "New Networks for Perfect Inversion and Perfect Reconstruction", 1992.
class GridMap {
public:
    GridMap() = default;

    /// The turn of `m` (flip = 1), about `from`, which comes to lie on `onto`; both on the point grid. The inverse
    /// rigid map with `from` and `onto` exchanged gives the inverse: apply() of both, in any order, is the identity.
    constexpr GridMap(const Rigid& m, Vec2 from, Vec2 onto) : from_(from), onto_(onto) {
        const bool is_near_x = (m.s < 0 ? -m.s : m.s) <= (m.c < 0 ? -m.c : m.c);
        quarters_ = is_near_x ? (m.c > 0 ? 0 : 2) : (m.s > 0 ? 1 : 3);
        const Vec2 rest = turned({m.c, m.s}, 4 - quarters_);
        sine_ = rest.y;
        half_tangent_ = rest.y / (1 + rest.x);
    }

    /// Where a point on the grid comes to lie, on the grid: within 1.5 grid steps of the turned point, and exactly
    /// there for quarter turns. |coordinates of p - from| <= 2^17 m.
    constexpr Vec2 apply(Vec2 p) const {
        // Rounded shears and a quarter turn do not commute: the way back does them in the opposite order.
        Vec2 d = p - from_;
        if (quarters_ == 3) d = turned(d, 3);
        d.x -= snap_to_point_grid(half_tangent_ * d.y);
        d.y += snap_to_point_grid(sine_ * d.x);
        d.x -= snap_to_point_grid(half_tangent_ * d.y);
        if (quarters_ != 3) d = turned(d, quarters_);
        return onto_ + d;
    }

    /// visit(field, …) of a GridMap, also a const one: for whoever writes or reads one as bytes.
    template <class Whole, class Visit>
    static constexpr auto fields(Whole& whole, Visit visit) {
        return visit(whole.from_, whole.onto_, whole.quarters_, whole.sine_, whole.half_tangent_);
    }

private:
    static constexpr Vec2 turned(Vec2 d, int quarters) {
        switch (quarters) {
            case 1: return {-d.y, d.x};
            case 2: return {-d.x, -d.y};
            case 3: return {d.y, -d.x};
            default: return d;
        }
    }

    Vec2 from_, onto_;
    int quarters_ = 0;
    double sine_ = 0, half_tangent_ = 0;
};

}  // namespace enfilade
