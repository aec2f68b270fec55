#include "render/stencil/screen.h"

namespace enfilade::stencil {

Screen::Screen(const Projection& projection)
    : width(projection.width()),
      height(projection.height()),
      slope_per_px(2 * projection.half_fov_tangent() / projection.width()),
      focal_y(projection.focal_y()),
      horizon(projection.horizon()) {
    for (int x = 0; x < width; ++x) slopes.push_back(projection.slope(x));
}

}  // namespace enfilade::stencil
