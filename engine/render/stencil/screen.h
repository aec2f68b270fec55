// The columns and rows that a picture is planned in.
#pragma once
#include <vector>

#include "render/view.h"

namespace enfilade::stencil {

/// From slopes and heights to columns and rows, as real numbers: column x reaches from x to x + 1.
struct Screen {
    int width = 0, height = 0;
    std::vector<double> slopes;  ///< [width] of the columns' middles
    double slope_per_px = 1;
    double focal_y = 1;  ///< [px]
    double horizon = 0;  ///< [px] from the top
    /// False: these are the picture's own columns and rows, each one with a ray in its middle. True: each stands for
    /// all rays that are in it (panorama.h), and what may be seen by any of them is planned.
    bool has_ranges = false;

    Screen() = default;
    explicit Screen(const Projection& projection);

    double per_slope() const { return 1 / slope_per_px; }
    double px_of(double slope) const { return slope / slope_per_px + width * 0.5; }
    double slope_at(double px) const { return (px - width * 0.5) * slope_per_px; }
};

/// Graphics cards put vertices on a grid of 1/256 px or finer. Edges between rows are drawn this much lower [px], so
/// that what goes exactly through a pixel's centre, as often happens where maps and players are lined up, falls on the
/// side that the other renderers' rule says. Between columns nothing is left to the card.
inline constexpr double kTieShift = 1.0 / 256;

}  // namespace enfilade::stencil
