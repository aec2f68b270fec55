#include "render/stencil/ray_field.h"

namespace enfilade::stencil {

RayField::RayField(const View& view, const Projection& projection)
    : width(projection.width()), height(projection.height()), is_tilted(view.tilt.has_value()) {
    const double tangent = projection.half_fov_tangent(), focal_y = projection.focal_y();
    const Ray corner = projection.tilted({1, -tangent, projection.horizon() / focal_y});
    const Ray per_x = projection.tilted({0, 2 * tangent / width, 0});
    const Ray per_y = projection.tilted({0, 0, -1 / focal_y});
    ahead = {corner.ahead, per_x.ahead, per_y.ahead};
    right = {corner.right, per_x.right, per_y.right};
    up = {corner.up, per_x.up, per_y.up};
}

}  // namespace enfilade::stencil
