#include "render/reference/pane.h"

namespace enfilade {
namespace {

bool is_solid(const Texture& texture, double u, double v) {
    return texel(texture, fraction(u), fraction(v)) >> 24 >= kSolidAlpha;
}

}  // namespace

bool is_at_rim_of_hole(const Texture& texture, TexelPosition at, Vec2 size_m) {
    constexpr double kFloatError = 0x1p-24;  // of the position [tiles]
    const double u = static_cast<double>(at.u), du = kAmbiguous / size_m.x + kFloatError;
    const double v = static_cast<double>(at.v), dv = kAmbiguous / size_m.y + kFloatError;
    const bool solid = is_solid(texture, u - du, v - dv);
    return is_solid(texture, u + du, v - dv) != solid || is_solid(texture, u - du, v + dv) != solid ||
           is_solid(texture, u + du, v + dv) != solid;
}

}  // namespace enfilade
