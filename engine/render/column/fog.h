// Fog before a surface: decided once for each surface, so that a map without fog has none in its loops.
#pragma once
#include "render/built_in.h"
#include "render/column/scene.h"

namespace enfilade::column {

/// The fog of a map; none where this build knows none.
inline Fog fog_of(const Map& map) {
    if (!built_in::kFog || map.render.fog_reach == 0) return {};
    return {map.render.fog_reach, pixel_of(map.render.fog_color)};
}

inline bool is_there(const Fog& fog) { return built_in::kFog && fog.reach > 0; }

}  // namespace enfilade::column
