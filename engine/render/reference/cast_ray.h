// What one ray sees: which surface, how far away, which texel, in which colour.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "formats/dials.h"
#include "map/map.h"
#include "map/textures.h"
#include "math/vec.h"
#include "render/frame.h"
#include "render/lighting.h"
#include "render/openings.h"
#include "render/reference/ray_path.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "world/snapshot.h"

namespace enfilade {

// What lamps and suns throw onto the places that rays meet: from the grids that all renderers share
// (render/lighting.h), or worked out anew for each place, by sight lines, so that grids can be held against it.

// Straight ways of light from lamps to places. They share the map and the predicates (math/predicates.h) with the ways
// of render/light_patch.h, and nothing else: no grid, no search, no path.

/// A lamp as one sector sees it: in its own place or, through links, somewhere else.
struct SeenLamp {
    std::uint32_t lamp = 0;  ///< index into Map::lights
    Rigid passage;           ///< from the space of the lamp's sector into that of this one
    Vec2 place;              ///< where it seems to be, on the point grid
    double z = 0;            ///< [m]
};

/// Most looks into rooms for one lamp: what folds space so often that it has more within a lamp's reach gets the light
/// of the first.
inline constexpr std::size_t kMostLampRooms = 1u << 12;

/// By sector: every lamp that might shine there by a straight way, whatever the heights. Rooms are entered through
/// portals that face the lamp and are within its reach; whether a straight way passes them all is not asked here.
/// One lamp is there once for each place and each direction in which its space is turned there.
/// Cost: the walls of the sectors within reach.
std::vector<std::vector<SeenLamp>> seen_lamps(const Map& map);

/// Nearer to each other than this, two places of one lamp are one: chains of links that lead to the same room agree
/// but for rounding [m].
inline constexpr double kSameLampPlace = 0x1p-10;

/// A place that light may fall on, in the space of its sector.
struct LitPlace {
    SectorId sector;
    Vec2 place;   ///< [m]
    double z;     ///< [m]
    WallId wall;  ///< of the sector, and faces the lamp: the place is on it; none: it is in the sector, or on a panel
};

/// Whether the lamp's light comes to the place: every portal on the straight way there is open at the height at which
/// the way passes, and nothing else is on it. A portal is open above both floors and below both ceilings; where both
/// rooms are under the sky, nothing is above. The lamp must be in its room.
///
/// Which walls the way crosses is decided in whole numbers, with the place rounded to the point grid, and once more
/// behind each link. What is within a ten-millionth of a metre of the way's end does not stand before it.
/// Cost: the walls of the sectors passed.
bool is_lit(const Map& map, const Snapshot& snapshot, const SeenLamp& lamp, const LitPlace& at);

// The light that comes by them.

/// The light at single places, by the rules of maps/FORMAT.md (A light, A sun): no grid, nothing between places.
/// Shared with grids are the lamps' colours at the moment, those of suns, and the units of LightCell.
class OwnLight {
public:
    /// Of one moment. Both outlive this. Cost: seen_lamps().
    OwnLight(const Map& map, const Snapshot& snapshot);

    // Cost: a look at each lamp that may reach the sector, and the walls on the straight way from each that is near.

    /// along: from the wall's or panel's a [m]. z: [m]
    LightCell on_wall(WallId wall, double along, double z) const;
    LightCell on_panel(PanelId panel, double along, double z) const;
    /// place: in the sector [m]
    LightCell on_floor(SectorId sector, Vec2 place) const;
    LightCell on_ceiling(SectorId sector, Vec2 place) const;
    /// The same everywhere on its picture: what arrives in the middle of its body.
    LightCell on_thing(ThingId thing) const;

private:
    LightCell on_flat(const LitPlace& at, const LampColor& sun) const;
    template <class NormalWay>
    LightCell sum_at(const LitPlace& at, const LampColor& sun, NormalWay normal_way) const;

    const Map& map_;
    const Snapshot& snapshot_;
    std::vector<std::vector<SeenLamp>> seen_;  ///< by sector
    std::vector<LampColor> colors_;            ///< by lamp, at the moment
};

/// Either way to know the light. Where the map has neither lamps nor suns, nothing is asked.
class Lamplight {
public:
    Lamplight() = default;
    /// All outlive this. own: null: grids are asked. grids: of the map.
    Lamplight(const Snapshot& snapshot, LightGrids& grids, const OwnLight* own)
        : snapshot_(&snapshot), grids_(grids.where_lit()), own_(own) {}

    LightCell on_wall(WallId wall, double along, double z) const;
    LightCell on_panel(PanelId panel, double along, double z) const;
    LightCell on_floor(SectorId sector, Vec2 place) const;
    LightCell on_ceiling(SectorId sector, Vec2 place) const;
    LightCell on_thing(ThingId thing) const;

private:
    const Snapshot* snapshot_ = nullptr;
    LightGrids* grids_ = nullptr;  ///< null: there is no such light
    const OwnLight* own_ = nullptr;
};

// The ray.

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
};

/// What stands in the plane on the way of a ray.
struct MetPane {
    std::int64_t steps = 0;  ///< of its depth (render/exact_ray.h)
    bool is_hit = false;     ///< else the ray passes above or below it
    Pane pane;               ///< where it is hit
};

/// The stretch of a ray in one room: from where it comes in to the wall it meets.
struct RoomRay {
    const RayHit& hit;
    const RayCourse& course;
    std::int64_t entry_steps;  ///< of the depth; 0 in the eye's own room
    WallId entry;              ///< of the room; none in the eye's own
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
    return fogged(color, pixel_of(render.fog_color), fog_part_at(render.fog_reach, depth, render.fog_step));
}

/// What a ray goes through on its way, the nearest first.
struct PanesMet {
    std::vector<Pane> panes;
    std::size_t passed = 0;  ///< pictures, at any height; of more than kMostPictures the farthest are left out

    /// Whether what is behind is left out.
    bool is_full(const ReferenceScene& scene) const { return !scene.is_tilted && passed >= kMostPictures; }
};

/// Adds the things and panels that the ray goes through; of a thing and a panel at one depth, in steps
/// (render/exact_ray.h), the thing is the nearer.
void add_room_panes(const ReferenceScene& scene, const RoomRay& ray, PanesMet& met);

// The panels that a ray goes through on its way through one room.

/// Adds the panels that the ray passes, the nearest first.
void find_panels_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met);

// The pictures of things that a ray meets on its way through one room.

/// Adds the pictures that the ray passes, the nearest first, by the rules of render/sprite.h.
void find_things_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met);

}  // namespace enfilade
