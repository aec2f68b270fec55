// What one ray sees: which surface, how far away, which texel, in which colour.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "formats/dials.h"
#include "map/textures.h"
#include "math/vec.h"
#include "render/frame.h"
#include "render/lighting.h"
#include "render/openings.h"
#include "render/reference/own_light.h"
#include "render/reference/ray_path.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "world/snapshot.h"

namespace enfilade {

/// Which texels pixels of walls, steps, floors and ceilings show, where it is not the nearest.
struct TexelSampling {
    Sampling kind;
    const MipChains* mips;    ///< where the kind needs smaller pictures
    double slope_per_column;  ///< of the picture's rays
    double focal_y;           ///< [px]
};

/// What there is to see.
struct ReferenceScene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    Lamplight lamplight{};                    ///< none: as if the map had no lamps and no suns
    bool is_tilted = false;                   ///< the picture
    const TexelSampling* sampling = nullptr;  ///< null: the nearest
};

/// What a ray ends on.
struct Seen {
    PixelSurface id = kNothing;
    double depth = 0;         ///< along the line of sight [m]; sky: infinity
    TexelPosition texel;      ///< 0, 0 at the end of a chain of links
    std::uint32_t color = 0;  ///< 0xAABBGGRR, shaded
    bool ambiguous = false;   ///< a decision on the way was closer than kAmbiguous
    bool cut_short = false;   ///< it ended because its budget was spent (render/openings.h)
};

/// Follows the ray with this path in the plane. path, course.quarters and course.slope belong together.
Seen cast_ray(const ReferenceScene& scene, RayPath& path, const RayCourse& course);

// What stands in one room, in the order in which a ray meets it.

// Pictures with holes that a ray goes through: fences, panels and things.

/// A picture with holes, and how much of it hides what is behind.
struct Pane {
    Seen seen;
    std::uint32_t alpha = 0;  ///< 0: the ray goes through a hole, or past the picture
    bool ambiguous = false;
};

/// What stands in the plane on the way of a ray, at some depth [m].
struct MetPane {
    double depth = 0;
    bool is_hit = false;  ///< else the ray passes above or below it
    Pane pane;            ///< where it is hit
};

/// The stretch of a ray in one room: from where it comes in to the wall it meets.
struct RoomRay {
    const RayHit& hit;
    const RayCourse& course;
    double entry_depth;  ///< 0 in the eye's own room [m]
    WallId entry;        ///< of the room; none in the eye's own
};

/// A texel as it is painted, and what its picture's color table, if it goes by one, calls it.
struct Texel {
    std::uint32_t color = 0;  ///< 0xAABBGGRR
    std::optional<std::uint8_t> number;
};

inline Texel texel(const Texture& texture, TilePlace u, TilePlace v) {
    const std::size_t x = texel_of(u, texture.width), y = texel_of(v, texture.height), i = x * texture.height + y;
    Texel texel{texture.pixels[i], {}};
    if (!texture.numbers.empty()) texel.number = texture.numbers[i];
    return texel;
}

/// A texel's colour in this light and that of point lights; its alpha is kept.
inline std::uint32_t lit(const ReferenceScene& scene, const Texel& texel, const Lighting& lighting, double depth,
                         LightCell lamplight) {
    const Shade shade = shade_at(lighting, depth);
    const std::uint32_t bright = texel.number
                                     ? lit_above(darkened_colors(scene.textures.color_table, shade)[*texel.number],
                                                 texel.color, shade, lamplight)
                                     : lit(texel.color, shade, lamplight);
    return (texel.color & 0xFF000000u) | (bright & 0x00FFFFFFu);
}

/// What a pixel shows of a picture.
struct TexelsSeen {
    TilePlace u, v;           ///< at its middle
    double texels_per_pixel;  ///< render/sampling.h
};

/// The colour of an opaque picture by scene.sampling, which is not null, in this light and that of point lights.
std::uint32_t several_texels(const ReferenceScene& scene, const Texture& picture, const TexelsSeen& seen,
                             const Lighting& lighting, double depth, LightCell lamplight);

/// The colour behind the map's fog; its alpha is kept.
inline std::uint32_t in_fog(const ReferenceScene& scene, std::uint32_t color, double depth) {
    const RenderRecord& render = scene.map.render;
    return fogged(color, pixel_of(render.fog_color), fog_part_at(render.fog_reach, depth));
}

/// Would a shift of kAmbiguous show a hole instead of the picture, or the other way round, or more or less of what is
/// behind? size_m: of the picture.
bool is_at_rim_of_hole(const Texture& texture, TexelPosition at, Vec2 size_m);

/// What a ray goes through on its way, the nearest first.
struct PanesMet {
    std::vector<Pane> panes;
    std::size_t passed = 0;  ///< pictures, at any height; of more than kMostPictures the farthest are left out
    bool ambiguous = false;  ///< a shift of kAmbiguous would have met something else, or in another order

    /// Whether what is behind is left out.
    bool is_full(const ReferenceScene& scene) const { return !scene.is_tilted && passed >= kMostPictures; }
};

/// Adds the things and panels that the ray goes through; of a thing and a panel at one depth, in steps
/// (render/sprite.h), the thing is the nearer.
void add_room_panes(const ReferenceScene& scene, const RoomRay& ray, PanesMet& met);

// The panels that a ray goes through on its way through one room.

/// Adds the panels that the ray passes, the nearest first. True where a shift of kAmbiguous would have met another one,
/// or missed one.
bool find_panels_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met);

// The pictures of things that a ray meets on its way through one room.

/// Whether a shift of kAmbiguous would have met another picture: whatever its height, or gone through another one.
struct ThingsCloseBy {
    bool passed = false, hit = false;
};

/// Adds the pictures that the ray passes, the nearest first, by the rules of render/sprite.h.
ThingsCloseBy find_things_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met);

}  // namespace enfilade
