// Where one wall stands on the screen: between which columns, how far away, and where its heights are drawn.
#pragma once
#include <optional>

#include "map/map.h"
#include "render/stencil/eye.h"
#include "render/view.h"

namespace enfilade::stencil {

/// From slopes and heights to pixels, as real numbers: column x has its centre at x + 1/2.
struct Screen {
    int width = 0, height = 0;
    double slope_per_px = 1;
    double focal_y = 1;  ///< [px]
    double horizon = 0;  ///< [px] from the top

    explicit Screen(const Projection& projection);

    double px_of(double slope) const { return slope / slope_per_px + width * 0.5; }
    double slope_at(double px) const { return (px - width * 0.5) * slope_per_px; }
};

/// How far beyond the picture's edges shapes are kept [px].
inline constexpr double kMargin = 1;

/// Edges are drawn this much aside [px]: graphics cards put vertices on a grid of 1/256 px or finer, so what goes
/// exactly through a pixel's centre, as often happens where maps and players are lined up, falls on the side that the
/// other renderers' tie rule says.
inline constexpr double kTieShift = 1.0 / 256;

/// A wall that faces the eye. With e_V(s) = s V.y - V.x (V in view space: x right, y depth) the ray with slope s runs
/// to the right of its left end L and to the left of its right end R where e_L(s) > 0 > e_R(s). Neighbours share a
/// vertex and compute its column from it alone, so that they meet exactly; there is no near plane, and nothing special
/// when the eye stands on the wall's line.
struct WallOnScreen {
    WallId wall;
    Vec2 left_v, right_v;  ///< L and R
    double cross = 0;      ///< cross(L, R), >= 0: exactly 0 where the eye is on the wall's line [m^2]
    double begin_px = 0;   ///< where it is drawn: columns [begin_px, end_px), within the margin of the picture
    double end_px = 0;
    bool swapped = false;  ///< L is the wall's b: it is seen in a mirror

    /// e_L - e_R: positive where the wall is seen.
    double span(double slope) const { return slope * (left_v.y - right_v.y) - (left_v.x - right_v.x); }

    /// 1 / depth, linear in the slope; finite but beyond all bounds where the eye is on the wall's line [1/m].
    double inverse_depth(double slope) const;

    double nearest() const;  ///< bounds of its depth anywhere [m], >= 0
    double farthest() const;
};

/// none: the wall does not face the eye (decided exactly), or is seen at no slope of the picture.
std::optional<WallOnScreen> on_screen(const Map& map, WallId wall, const Eye& eye, const Screen& screen);

/// Row of a height above the eye on the wall [px], real, what lies exactly on it counting as above; may lie far outside
/// of the picture, but is always finite.
double row_of(const Screen& screen, const WallOnScreen& wall, double height, double px);

/// Takes away what lies before the line of `entry`, the wall one looks in through: of walls of the same space only what
/// is on its right. Exact for walls that end on the line. False where nothing is left.
bool cut_at_entry(const Map& map, const Wall& entry, const Eye& eye, const Screen& screen, WallOnScreen& wall);

/// True where `wall` is beyond `entry`, the wall of the same sector through which the look came in: both cover a
/// common column and do not cross. Exact.
bool is_beyond(const Wall& wall, const Wall& entry);

}  // namespace enfilade::stencil
