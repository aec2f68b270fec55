// How the light of Doom's sectors changes, as this format's light effects.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §4.9.1; times as Doom has them (p_lights.c, 1993).
#pragma once
#include <cstdint>
#include <optional>

#include "formats/effect_records.h"

namespace enfilade::wadconv {

/// Flashes once a second from `dark` [0..255].
LightEffectRecord slow_strobe(int dark);

/// What a sector's special makes of its light, which is `light`, with `darkest` the darkest around it; none where it is
/// steady, or where there is nothing darker to go to.
std::optional<LightEffectRecord> light_effect_of(int special, int light, int darkest);

}  // namespace enfilade::wadconv
