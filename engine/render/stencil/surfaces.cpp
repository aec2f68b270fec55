#include "render/stencil/surfaces.h"

#include <algorithm>

#include "render/picture_now.h"
#include "render/shade.h"

namespace enfilade::stencil {
namespace {

/// What hangs in a portal is before the portal's own depth by more than the roundings of both [1].
constexpr float kBeforePortal = 1 - 0x1p-20f;

float f(double x) { return static_cast<float>(x); }

/// A function that is linear in the slope, as value at look.from_px and change per column.
struct Linear {
    double at_start, per_px;
};

/// slope * of_slope - constant.
Linear linear(const Screen& screen, const Look& look, double of_slope, double constant) {
    return {screen.slope_at(static_cast<double>(look.from_px)) * of_slope - constant, screen.slope_per_px * of_slope};
}

void set_picture(Look& look, const Scene& scene, TextureId texture, SurfaceId id, Paint paint) {
    const Texture& picture = scene.textures[texture];
    look.id_and_paint = id | static_cast<std::uint32_t>(paint) << 24;
    look.texels = scene.store.place_of(texture);
    look.width = picture.width;
    look.height = picture.height;
}

void set_light(Look& look, double light, double contrast) {
    look.light = f(std::clamp(light, 0.0, 1.0));
    look.contrast = f(contrast);
}

/// Where along the wall from its a, in tiles: e_L / span, or -e_R / span where a is the right end.
void set_along(Look& look, const Scene& scene, const WallOnScreen& place, double tiles, double offset) {
    const Vec2 a_v = place.swapped ? place.right_v : place.left_v;
    const double sign = place.swapped ? -1 : 1;
    const Linear along = linear(scene.screen, look, sign * a_v.y, sign * a_v.x);
    look.a[0] = f(along.at_start);
    look.a[1] = f(along.per_px);
    look.a[2] = f(tiles);
    look.a[3] = f(offset);
}

/// The ray's direction in the plane, its components divided by those of `unit`.
void set_direction(Look& look, const Scene& scene, const Eye& eye, Vec2 unit) {
    const Linear x = linear(scene.screen, look, eye.right.x / unit.x, -eye.forward.x / unit.x);
    const Linear y = linear(scene.screen, look, eye.right.y / unit.y, -eye.forward.y / unit.y);
    look.a[0] = f(x.at_start);
    look.a[1] = f(y.at_start);
    look.a[2] = f(x.per_px);
    look.a[3] = f(y.per_px);
}

Look sky_look(const Scene& scene, const SeenWall& wall, const Surface& surface, SurfaceId id) {
    Look look = plain_look(scene, wall.place);
    set_picture(look, scene, surface.texture, id, Paint::sky);
    set_direction(look, scene, wall.eye, {1, 1});
    look.b[0] = f(surface.tile_m.x);
    look.b[1] = f(surface.tile_m.y);
    look.b[2] = f(surface.offset_tiles.x);
    look.b[3] = f(surface.offset_tiles.y);
    return look;
}

}  // namespace

Look plain_look(const Scene& scene, const WallOnScreen& place) {
    Look look;
    const double middle = (place.begin_px + place.end_px) / 2;
    look.from_px = f(static_cast<int>(middle));
    const Linear span = linear(scene.screen, look, place.left_v.y - place.right_v.y, place.left_v.x - place.right_v.x);
    look.cross = f(place.cross);
    look.span[0] = f(span.at_start);
    look.span[1] = f(span.per_px);
    look.nearest = f(place.nearest());
    look.farthest = f(place.farthest());
    return look;
}

Look wall_look(const Scene& scene, const SeenWall& wall, const Surface& at_rest, WallPart part) {
    const Wall& w = scene.map[wall.place.wall];
    const Surface surface = picture_now(scene.map, scene.snapshot, wall.place.wall, at_rest);
    Look look = plain_look(scene, wall.place);
    set_picture(look, scene, surface.texture, wall_id(scene.map, wall.place.wall, part), Paint::wall);
    set_light(look, light_at(scene.snapshot, w.sector), w.contrast);
    set_along(look, scene, wall.place, w.length / surface.tile_m.x, surface.offset_tiles.x);
    look.b[0] = f(fraction(peg_height(wall.parts, surface.peg) / surface.tile_m.y - surface.offset_tiles.y));
    look.b[1] = f(1 / surface.tile_m.y);
    return look;
}

Look pane_look(const Scene& scene, const SeenWall& wall, double top) {
    const WallId id = wall.place.wall;
    const Surface surface = picture_now(scene.map, scene.snapshot, id, scene.map[id].middle);
    Look look = wall_look(scene, wall, scene.map[id].middle, WallPart::middle);
    set_picture(look, scene, surface.texture, wall_id(scene.map, id, WallPart::middle), Paint::picture);
    look.cross *= kBeforePortal;
    look.nearest *= kBeforePortal;
    look.b[0] = f(top / surface.tile_m.y);
    return look;
}

Look thing_look(const Scene& scene, const ThingOnScreen& thing) {
    Look look = plain_look(scene, thing.place);
    set_picture(look, scene, thing.texture, thing.id, Paint::picture);
    set_light(look, thing.light, 1);
    set_along(look, scene, thing.place, 1, 0);
    look.farthest = f(thing.place.cross / (thing.place.right_v.x - thing.place.left_v.x));
    look.b[0] = f(thing.top / thing.height);
    look.b[1] = f(1 / thing.height);
    return look;
}

Look flat_look(const Scene& scene, const SeenWall& wall, const Flat& flat, double height, SurfaceId id) {
    const Surface& surface = flat.surface;
    if (flat.sky) return sky_look(scene, wall, surface, id);
    Look look = plain_look(scene, wall.place);
    set_picture(look, scene, surface.texture, id, Paint::flat);
    set_light(look, light_at(scene.snapshot, scene.map[wall.place.wall].sector), 1);
    set_direction(look, scene, wall.eye, surface.tile_m);
    const Vec2 from_origin = wall.eye.place - flat.origin;
    look.b[0] = f(fraction(from_origin.x / surface.tile_m.x - surface.offset_tiles.x));
    look.b[1] = f(fraction(from_origin.y / surface.tile_m.y - surface.offset_tiles.y));
    look.b[2] = f(height);
    return look;
}

Look end_look(const Scene& scene, const SeenWall& wall) {
    Look look = plain_look(scene, wall.place);
    const std::uint32_t rgb = scene.map.render.recursion_color;
    look.id_and_paint = kRecursionEnd | static_cast<std::uint32_t>(Paint::color) << 24;
    look.texels = (rgb & 0xFFu) << 16 | (rgb & 0xFF00u) | rgb >> 16;
    return look;
}

double peg_height(const WallParts& parts, Peg peg) {
    switch (peg) {
        case Peg::ceiling: return parts.room.ceiling;
        case Peg::floor: return parts.room.floor;
        case Peg::opening_top: return std::min(parts.room.ceiling, parts.behind.ceiling);
        case Peg::opening_bottom: return std::max(parts.room.floor, parts.behind.floor);
    }
    return parts.room.ceiling;
}

}  // namespace enfilade::stencil
