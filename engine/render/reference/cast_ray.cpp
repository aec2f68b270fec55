#include "render/reference/cast_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "render/openings.h"
#include "render/shade.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

/// A sector's heights as seen from the eye [m above the eye], in the space where the eye has that height.
struct HeightsFromEye {
    double floor;
    double ceiling;
};

/// A ray at the moment it has reached a wall.
struct Arrival {
    const ReferenceScene& scene;
    const RayHit& hit;
    const Wall& wall;
    WallKind kind;  ///< now
    const Sector& sector;
    const RayCourse& course;
    HeightsFromEye own;
    HeightsFromEye behind;  ///< portal: the neighbour's, else own
};

HeightsFromEye opening_of(const ReferenceScene& scene, SectorId sector, double eye_z) {
    const Heights heights = heights_at(scene.snapshot, sector);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

/// Is the ray at `height` above the eye, or higher, where it meets the wall?
bool reaches(const Arrival& at, double height) { return reaches(at.course.tied_climb, at.hit.depth, height); }

constexpr std::uint32_t kAlpha = 0xFF000000u;

/// Whether the picture of a wall's middle is shown once. A scrolled one runs through its place, over and over.
enum class Repeat : std::uint8_t { over_and_over, once };

/// How a surface lies in the picture, for those ways of sampling that ask for it: how far the place on it moves along
/// its two sides from one column, or row, to the next, whichever is more [m]. Null: the nearest texel is shown.
using Movement = std::optional<Vec2>;

double texels_per_pixel(Vec2 moves_m, const Surface& surface, const Texture& picture) {
    return std::max(moves_m.x / surface.tile_m.x * picture.width, moves_m.y / surface.tile_m.y * picture.height);
}

/// Before fog. ahead: how far, along the course [m]. lamplight: of point lights.
Seen painted(const Arrival& at, const Surface& surface, PixelSurface id, double u, double v, double contrast,
             double ahead, LightCell lamplight, Repeat shown, const Movement& moves) {
    const double depth = ahead * at.course.depth_scale;
    Seen seen{id, depth, {}, 0};
    u -= surface.offset_tiles.x;
    v -= surface.offset_tiles.y;
    const double tile_u = fraction(u), tile_v = shown == Repeat::once ? std::clamp(v, 0.0, 1.0) : fraction(v);
    const TilePlace v_place = shown == Repeat::once ? place_on_picture(tile_v) : place_on_tile(v);
    const Texture& picture = at.scene.textures[surface.texture];
    const SectorId sector = at.hit.sector;
    const Lighting lighting = lighting_in(at.scene.map, sector, light_at(at.scene.snapshot, sector), contrast);
    seen.texel = {tile_u, tile_v};
    if (moves && !picture.has_holes)
        seen.color =
            several_texels(at.scene, picture, {place_on_tile(u), v_place, texels_per_pixel(*moves, surface, picture)},
                           lighting, depth, lamplight);
    else  // a pane still needs its alpha
        seen.color = lit(at.scene, texel(picture, place_on_tile(u), v_place), lighting, depth, lamplight);
    return seen;
}

SkyRows rows_of_sky(const Arrival& at) { return sky_rows(at.scene.map.render, at.scene.is_tilted); }

/// Where on the picture the ray looks.
SkyTexel sky_texel_of(const Arrival& at, const Surface& surface) {
    const double ground = rows_of_sky(at) == SkyRows::round ? std::sqrt(1 + at.course.slope * at.course.slope) : 1;
    const double elevation = at.course.climb / ground;
    const double turns = turn_of(at.hit.space.direction(at.course.slope));
    return sky_texel(surface.tile_m, surface.offset_tiles, turns, elevation, rows_of_sky(at));
}

std::uint32_t sky_color(const Arrival& at, const Surface& surface, const SkyTexel& place) {
    return texel(at.scene.textures[surface.texture], place_on_tile(place.u),
                 place_on_sky(place.v, last_of_sky(rows_of_sky(at))))
        .color;
}

Seen sky(const Arrival& at, const FlatNow& flat, PixelSurface id) {
    const SkyTexel base = sky_texel_of(at, flat.surface);
    Seen seen{id, std::numeric_limits<double>::infinity(), {}, 0};
    seen.texel = {base.u, base.v};
    seen.color = sky_color(at, flat.surface, base) | kAlpha;
    for (std::uint32_t i = 0; i < flat.layer_count; ++i) {
        const Surface layer = layer_now(at.scene.map, at.scene.snapshot, flat, i);
        seen.color = laid_over(seen.color, sky_color(at, layer, sky_texel_of(at, layer)));
    }
    return seen;
}

/// A place on a floor or ceiling.
struct FlatPlace {
    Vec2 from_origin;     ///< of its picture [m]
    double ahead;         ///< along the course [m]
    LightCell lamplight;  ///< of point lights
};

Seen painted(const Arrival& at, const Surface& surface, PixelSurface id, const FlatPlace& place,
             const Movement& moves) {
    const Vec2 tiles{place.from_origin.x / surface.tile_m.x, place.from_origin.y / surface.tile_m.y};
    return painted(at, surface, id, tiles.x, tiles.y, 1, place.ahead, place.lamplight, Repeat::over_and_over, moves);
}

/// Of a floor or ceiling `height` above the eye, `ahead` along the course. One on its wrong side counts as near.
Movement flat_moves(const Arrival& at, PixelSurface id, double height, double ahead) {
    const TexelSampling* const sampling = at.scene.sampling;
    if (!sampling) return {};
    const bool is_ceiling = id == ceiling_id(at.hit.sector), is_above = height > 0;
    if (height == 0 || is_ceiling != is_above) return Vec2{};
    const double depth = ahead * at.course.depth_scale;
    const double right_m = depth * sampling->slope_per_column;
    const double ahead_m = depth * depth / std::fabs(height) / sampling->focal_y;
    Vec2 ahead_of = at.hit.space.forward, right_of_it = right_of(ahead_of);
    if (at.course.quarters % 2 == 1) std::swap(ahead_of, right_of_it);  // the view's, not the course's
    return Vec2{std::max(std::fabs(right_of_it.x) * right_m, std::fabs(ahead_of.x) * ahead_m),
                std::max(std::fabs(right_of_it.y) * right_m, std::fabs(ahead_of.y) * ahead_m)};
}

/// Of a wall, along and down it.
Movement wall_moves(const Arrival& at) {
    const TexelSampling* const sampling = at.scene.sampling;
    if (!sampling) return {};
    const double depth = at.hit.depth.value * at.course.depth_scale;
    const double from_line =
        std::fabs(dot(right_of(at.wall.b - at.wall.a), at.hit.space.eye - at.wall.a)) / at.wall.length;
    const double along_m = from_line > 0 ? depth * depth / from_line * sampling->slope_per_column : 0;
    return Vec2{along_m, depth / sampling->focal_y};
}

/// `height` above the eye. Of a flat that is seen extended, or from its wrong side, the part that is nearest to where
/// the ray really crosses its height.
Seen flat(const Arrival& at, const FlatNow& flat, double height,
          LightCell (Lamplight::*lamplight_on)(SectorId, Vec2) const, PixelSurface id) {
    if (flat.sky) return sky(at, flat, id);
    const double crossed = depth_on_plane(at.course.climb, at.course.tied_climb, height);
    const double depth = std::clamp(crossed, 0.0, at.hit.depth.value);
    const Vec2 spot = at.hit.space.eye + at.hit.space.direction(at.course.slope) * depth;
    const FlatPlace place{spot - flat.origin, depth, (at.scene.lamplight.*lamplight_on)(at.hit.sector, spot)};
    Seen seen = painted(at, flat.surface, id, place, flat_moves(at, id, height, depth));
    for (std::uint32_t i = 0; i < flat.layer_count; ++i) {
        const Surface layer = layer_now(at.scene.map, at.scene.snapshot, flat, i);
        seen.color = laid_over(seen.color, painted(at, layer, id, place, {}).color);
    }
    seen.color = in_fog(at.scene, seen.color, seen.depth);
    return seen;
}

/// Height above the eye that the texture hangs from.
double peg_height(const Arrival& at, Peg peg) {
    switch (peg) {
        case Peg::ceiling: return at.own.ceiling;
        case Peg::floor: return at.own.floor;
        case Peg::opening_top: return std::min(at.own.ceiling, at.behind.ceiling);
        case Peg::opening_bottom: return std::max(at.own.floor, at.behind.floor);
    }
    return at.own.ceiling;
}

/// peg: height above the eye that the texture hangs from.
Seen wall(const Arrival& at, SurfaceId at_rest, double peg, WallPart part, Repeat shown = Repeat::over_and_over) {
    const Surface surface = picture_now(at.scene.map, at.scene.snapshot, at.hit.wall, at_rest);
    const double u = at.hit.along * at.wall.length / surface.tile_m.x;
    const double v = (peg - at.course.climb * at.hit.depth.value) / surface.tile_m.y;
    const double z = at.hit.space.eye_z + at.course.climb * at.hit.depth.value;
    const LightCell lamplight = at.scene.lamplight.on_wall(at.hit.wall, at.hit.along * at.wall.length, z);
    const bool is_pane = part == WallPart::middle && at.kind == WallKind::portal;
    Seen seen = painted(at, surface, wall_id(at.scene.map, at.hit.wall, part), u, v, at.wall.contrast,
                        at.hit.depth.value, lamplight, shown, is_pane ? Movement() : wall_moves(at));
    seen.color = in_fog(at.scene, seen.color, seen.depth);
    return seen;
}

Seen wall(const Arrival& at, SurfaceId surface, WallPart part) {
    return wall(at, surface, peg_height(at, at.scene.map[surface].peg), part);
}

/// The picture with holes in a portal, shown once from top to bottom; a scrolled one runs through its place.
Pane pane(const Arrival& at) {
    const Surface surface = picture_now(at.scene.map, at.scene.snapshot, at.hit.wall, at.wall.middle);
    const bool stands = surface.peg == Peg::floor || surface.peg == Peg::opening_bottom;
    const double top = peg_height(at, surface.peg) + (stands ? surface.tile_m.y : 0);
    const double picture_top = top - at.scene.map[at.wall.middle].offset_tiles.y * surface.tile_m.y;
    const double picture_bottom = picture_top - surface.tile_m.y;
    Pane pane;
    if (reaches(at, picture_top) || !reaches(at, picture_bottom)) return pane;
    const Repeat shown = surface.scroll.y == 0 ? Repeat::once : Repeat::over_and_over;
    pane.seen = wall(at, at.wall.middle, top, WallPart::middle, shown);
    pane.alpha = pane.seen.color >> 24;
    return pane;
}

/// What is seen through panes, the nearest first: the farthest of them is laid over it first. It shows the nearest
/// surface that hides more than half of what is behind.
Seen through_panes(const std::vector<Pane>& panes, Seen seen) {
    seen.color |= kAlpha;
    for (auto pane = panes.rbegin(); pane != panes.rend(); ++pane) {
        const std::uint32_t color = laid_over(seen.color, pane->seen.color);
        if (pane->alpha >= kSolidAlpha) seen = pane->seen;
        seen.color = color;
    }
    return seen;
}

bool is_spent(const Arrival& at) { return at.hit.spent >= kLookBudget; }

Seen end_of_chain(const Arrival& at) {
    return {kRecursionEnd,
            at.hit.depth.value * at.course.depth_scale,
            {},
            pixel_of(at.scene.map.render.recursion_color),
            is_spent(at)};
}

/// Where the ray ends if it ends at this wall: on the flats before it, on the wall, on a step, or because it has
/// followed as many links as it may, spent its budget, or comes round to where it was.
std::optional<Seen> end_of_ray(const Arrival& at) {
    const SectorId sector = at.hit.sector;
    if (reaches(at, at.own.ceiling))
        return flat(at, ceiling_now(at.scene.map, at.scene.snapshot, sector), at.own.ceiling, &Lamplight::on_ceiling,
                    ceiling_id(sector));
    if (!reaches(at, at.own.floor))
        return flat(at, floor_now(at.scene.map, at.scene.snapshot, sector), at.own.floor, &Lamplight::on_floor,
                    floor_id(sector));
    if (at.kind == WallKind::solid) return wall(at, at.wall.texture, WallPart::middle);
    if (at.kind == WallKind::portal) {
        const bool above = reaches(at, at.behind.ceiling), below = !above && !reaches(at, at.behind.floor);
        if (above && has_upper_step(at.scene.map, at.wall)) return wall(at, at.wall.upper, WallPart::upper);
        if (below && has_lower_step(at.scene.map, at.wall)) return wall(at, at.wall.lower, WallPart::lower);
    }
    const bool is_linked = at.wall.link != Wall::kNoLink;
    const bool is_too_deep = is_linked && at.hit.space.links >= at.scene.map.render.max_depth;
    if (is_too_deep || is_spent(at) || at.hit.comes_round) return end_of_chain(at);
    return std::nullopt;
}

Arrival arrive(const ReferenceScene& scene, const RayHit& hit, const RayCourse& course) {
    const Wall& met = scene.map[hit.wall];
    const HeightsFromEye own = opening_of(scene, hit.sector, hit.space.eye_z);
    Arrival at{scene, hit, met, kind_now(scene.map, scene.snapshot, hit.wall), scene.map[hit.sector], course, own, own};
    if (at.kind == WallKind::portal)
        at.behind = opening_of(scene, met.behind, scene.map.passage(met).apply_height(hit.space.eye_z));
    return at;
}

}  // namespace

Seen cast_ray(const ReferenceScene& scene, RayPath& path, const RayCourse& course) {
    PanesMet met;
    std::int64_t entry_steps = 0;
    WallId entry;
    for (std::size_t i = 0;; ++i) {
        const Arrival at = arrive(scene, path[i], course);
        if (!scene.snapshot.things.in(at.hit.sector).empty() || !at.hit.panels.empty())
            add_room_panes(scene, {at.hit, course, entry_steps, entry}, met);
        entry_steps = depth_steps(at.hit.depth);
        entry = at.wall.kind == WallKind::mirror ? at.hit.wall : at.wall.exit;
        if (const std::optional<Seen> end = end_of_ray(at)) {
            return through_panes(met.panes, *end);
        }
        if (at.kind != WallKind::portal || !scene.map[at.wall.middle].texture) continue;
        if (met.is_full(scene)) continue;
        ++met.passed;
        met.panes.push_back(pane(at));
    }
}

}  // namespace enfilade
