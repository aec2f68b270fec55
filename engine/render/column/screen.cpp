#include "render/column/screen.h"

namespace enfilade::column {

void Screen::set(const Projection& projection) {
    width = projection.width();
    height = projection.height();
    focal_y = projection.focal_y();
    horizon = projection.horizon();
    slopes.resize(static_cast<std::size_t>(width));
    row_rises.resize(static_cast<std::size_t>(height));
    tied_rises.resize(static_cast<std::size_t>(height));
    row_depths.resize(static_cast<std::size_t>(height));
    for (int x = 0; x < width; ++x) slopes[x] = projection.slope(x);
    for (int y = 0; y < height; ++y) {
        row_rises[y] = projection.row_from_horizon(y);
        tied_rises[y] = row_rises[y] + kTieClimb * focal_y;
        row_depths[y] = focal_y / row_rises[y];
    }
    column_scale = width / (2 * projection.half_fov_tangent());
}

}  // namespace enfilade::column
