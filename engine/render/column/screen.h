// The numbers of one picture size and look, worked out once a frame for every column and row.
#pragma once
#include <vector>

#include "render/view.h"

namespace enfilade::column {

/// Rays by index: what Projection computes, kept in tables.
struct Screen {
    int width = 0;
    int height = 0;
    double focal_y = 1;              ///< [px]
    double horizon = 0;              ///< [px]
    double column_scale = 1;         ///< columns per unit of slope
    std::vector<double> slopes;      ///< [width] tangent right of the middle
    std::vector<double> row_rises;   ///< [height] rows above the horizon [px]
    std::vector<double> tied_rises;  ///< [height] the same by the tie rule: of these is asked what a row passes
    std::vector<double> row_depths;  ///< [height] depth at which a ray has climbed 1 m; infinite on the horizon [m/m]

    void set(const Projection& projection);
};

}  // namespace enfilade::column
