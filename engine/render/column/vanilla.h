// Texel positions by the tables and the 16.16 numbers that Doom's renderer had (id Software, "Doom source code", 1997:
// r_main, r_segs, r_plane, r_draw): angles are cut to 8192 a turn, slopes to 2048 an eighth, a wall's scale is stepped
// from one end of it to the other. For comparison only: which surface a pixel shows stays exact.
//
// Lengths are in texels along the width of the surface's picture, as they were on Doom's maps.
#pragma once
#include <cstdint>

#include "math/angle.h"
#include "math/vec.h"

namespace enfilade::column {

/// 1/65536.
using Fixed = std::int32_t;

/// The screen as those formulas know it.
class VanillaScreen {
public:
    /// columns_per_slope: half the width, where the field of view is 90 degrees.
    VanillaScreen(int width, double columns_per_slope);

    int width() const { return width_; }
    double columns_per_slope() const { return columns_per_slope_; }
    /// Where the left edge of column x looks, left of ahead: the first fine angle that the tables put there or farther.
    Angle column_angle(int x) const;

private:
    int first_column(Angle fine) const;

    int width_;  ///< [px]
    double columns_per_slope_;
    std::int64_t columns_per_tangent_;  ///< the same by the table of tangents [1/65536]
};

/// A wall that faces the eye.
class VanillaWall {
public:
    /// left, right: its ends in view space, x right, y ahead.
    VanillaWall(const VanillaScreen& screen, Vec2 left, Vec2 right);

    /// From the left end, of what column x shows.
    double along_at(int x) const;
    /// From a row of column x to the next.
    double per_row_at(int x) const;

private:
    Fixed scale_at(int x) const;

    VanillaScreen screen_;
    Angle normal_;  ///< from the eye to the wall, left of ahead
    Fixed distance_ = 0, offset_ = 0;
    int first_ = 0;  ///< of its columns
    Fixed scale_ = 0, scale_step_ = 0;
};

/// A floor or ceiling.
class VanillaFlat {
public:
    /// height: above or below the eye. forward: of the view. flip: -1 in a mirror.
    VanillaFlat(const VanillaScreen& screen, double height, Vec2 forward, double flip);

    /// From the place under the eye, of what column x shows. rows_per_rise: how many rows the flat is farther from the
    /// horizon for each texel of height, at a depth of one texel; rows: from the horizon, > 0.
    Vec2 at(int x, double rows, double rows_per_rise) const;

private:
    Fixed height_ = 0;
    Fixed start_cos_ = 0, start_sin_ = 0, start_length_ = 0;  ///< of column 0, per unit of distance
    Fixed step_x_ = 0, step_y_ = 0;                           ///< from a column to the next, per unit of distance
};

}  // namespace enfilade::column
