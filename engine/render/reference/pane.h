// Pictures with holes that a ray goes through: fences, panels and things.
#pragma once
#include <vector>

#include "math/vec.h"
#include "render/reference/look.h"
#include "render/shade.h"

namespace enfilade {

/// A picture with holes, and how much of it hides what is behind.
struct Pane {
    Seen seen;
    std::uint32_t alpha = 0;  ///< 0: the ray goes through a hole, or past the picture
    bool ambiguous = false;
};

/// A pane at some depth [m].
struct MetPane {
    double depth = 0;
    Pane pane;
};

/// The stretch of a ray in one room: from where it comes in to the wall it meets.
struct RoomRay {
    const RayHit& hit;
    const RayCourse& course;
    double entry_depth;  ///< 0 in the eye's own room [m]
};

inline std::uint32_t texel(const Texture& texture, TilePlace u, TilePlace v) {
    return texture.at(texel_of(u, texture.width), texel_of(v, texture.height));
}

/// A texel's colour in this light, that of point lights and the map's fog; its alpha is kept.
inline std::uint32_t lit(const Scene& scene, std::uint32_t color, double light, double contrast, double depth,
                         LightCell glow) {
    const RenderRecord& render = scene.map.render;
    const std::uint32_t clear = lit(color, shade_at(render.light, light, contrast, depth), glow);
    return (color & 0xFF000000u) |
           (misted(clear, pixel_of(render.fog_color), mist_at(render.fog_reach, depth)) & 0x00FFFFFFu);
}

/// What point lights throw onto a place of a surface. grid: null: nothing.
inline LightCell glow_on(const LightGrid* grid, double u, double v) { return grid ? light_on(*grid, u, v) : 0; }

/// Would a shift of kAmbiguous show a hole instead of the picture, or the other way round, or more or less of what is
/// behind? size_m: of the picture.
bool is_at_rim_of_hole(const Texture& texture, TexelPosition at, Vec2 size_m);

}  // namespace enfilade
