// How the light of a room falls on a surface of it, shared by all renderers: chosen once for each surface.
#pragma once
#include <algorithm>

#include "map/map.h"
#include "render/dimming.h"

namespace enfilade {

/// What shade_at() asks of a surface.
struct Lighting {
    LightModel model = LightModel::smooth;
    double light = 1;     ///< 0..1
    double contrast = 1;  ///< as Wall::contrast
};

/// Of a surface in a sector that has this light, 0..1. contrast: Wall::contrast, 1 for flats and things.
inline Lighting lighting_in(const Map& map, SectorId sector, double light, double contrast) {
    if (!map[sector].unlit) return {map.render.light, light, contrast};
    // Full smooth light does not fall off; what contrast leaves of it is then all that is left of the colours.
    return {LightModel::smooth, 1, std::clamp(light, 0.0, 1.0)};
}

inline Dimming dimming_of(const Lighting& lighting) { return {lighting.model, lighting.light, lighting.contrast}; }

/// depth: >= 0 [m], infinity allowed.
inline Shade shade_at(const Lighting& lighting, double depth) {
    return shade_at(lighting.model, lighting.light, lighting.contrast, depth);
}

}  // namespace enfilade
