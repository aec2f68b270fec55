// Which steps of a portal are drawn: a rule of the world, shared by all renderers.
#pragma once
#include "map/map.h"
#include "render/built_in.h"

namespace enfilade {

/// A step without a texture is open: one sees past it. So is the upper step between two rooms under the sky, behind
/// which there would be nothing but sky.
inline bool has_upper_step(const Map& map, const Wall& portal) {
    const bool from_sky_to_sky = built_in::kSky && map[portal.sector].ceiling.sky && map[portal.behind].ceiling.sky;
    return map[portal.upper].texture && !from_sky_to_sky;
}

inline bool has_lower_step(const Map& map, const Wall& portal) { return static_cast<bool>(map[portal.lower].texture); }

}  // namespace enfilade
