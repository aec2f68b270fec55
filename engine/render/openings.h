// What one sees of a room and through its portals, by height and by row: shared by all renderers.
#pragma once
#include "map/map.h"
#include "render/built_in.h"

namespace enfilade {

/// Heights of a room, or of a part of a wall, above the eye [m].
struct RelativeHeights {
    double floor = 0;
    double ceiling = 0;

    bool is_empty() const { return floor >= ceiling; }
};

/// The rows [top, bottom) of one column that are still open: nothing has been drawn there yet.
struct OpenRows {
    int top = 0;
    int bottom = 0;  ///< top >= bottom: closed

    bool is_closed() const { return top >= bottom; }
};

/// A step without a texture is open: one sees past it. So is the upper step between two rooms under the sky, behind
/// which there would be nothing but sky.
inline bool has_upper_step(const Map& map, const Wall& portal) {
    const bool from_sky_to_sky = built_in::kSky && map[portal.sector].ceiling.sky && map[portal.behind].ceiling.sky;
    return map[portal.upper].texture && !from_sky_to_sky;
}

inline bool has_lower_step(const Map& map, const Wall& portal) { return static_cast<bool>(map[portal.lower].texture); }

}  // namespace enfilade
