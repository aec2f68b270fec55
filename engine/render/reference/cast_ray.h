// What one ray sees: which surface, how far away, which texel, in which colour.
#pragma once
#include <cstdint>

#include "map/textures.h"
#include "render/frame.h"
#include "render/light_grids.h"
#include "render/reference/ray_path.h"
#include "world/snapshot.h"

namespace enfilade {

/// What there is to see.
struct ReferenceScene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    LightGrids* lights = nullptr;  ///< null: the map has no point lights
    bool is_tilted = false;        ///< the picture
};

/// What a ray ends on.
struct Seen {
    PixelSurface id = kNothing;
    double depth = 0;         ///< along the line of sight [m]; sky: infinity
    TexelPosition texel;      ///< 0, 0 at the end of a chain of links
    std::uint32_t color = 0;  ///< 0xAABBGGRR, shaded
    bool ambiguous = false;   ///< a decision on the way was closer than kAmbiguous
    bool cut_short = false;   ///< it ended because its budget was spent (render/look_budget.h)
};

/// Follows the ray with this path in the plane. path, course.quarters and course.slope belong together.
Seen cast_ray(const ReferenceScene& scene, RayPath& path, const RayCourse& course);

}  // namespace enfilade
