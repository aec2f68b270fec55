#include "render/reference/pane.h"

namespace enfilade {
namespace {

/// What a texel does to what is behind it: hides it, shows it, or mixes with it, each colour in its own way.
std::uint32_t effect_of(const Texture& texture, double u, double v) {
    const std::uint32_t color = texel(texture, place_on_tile(u), place_on_tile(v)).color;
    const std::uint32_t alpha = color & 0xFF000000u;
    return alpha == 0 || alpha == 0xFF000000u ? alpha : color;
}

}  // namespace

bool is_at_rim_of_hole(const Texture& texture, TexelPosition at, Vec2 size_m) {
    constexpr double kFloatError = 0x1p-24;  // of the position [tiles]
    const double u = static_cast<double>(at.u), du = kAmbiguous / size_m.x + kFloatError;
    const double v = static_cast<double>(at.v), dv = kAmbiguous / size_m.y + kFloatError;
    const std::uint32_t effect = effect_of(texture, u - du, v - dv);
    return effect_of(texture, u + du, v - dv) != effect || effect_of(texture, u - du, v + dv) != effect ||
           effect_of(texture, u + du, v + dv) != effect;
}

}  // namespace enfilade
