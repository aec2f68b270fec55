#include "render/stencil/surfaces.h"

#include <algorithm>

#include "render/lighting.h"
#include "render/shade.h"
#include "render/sprite.h"
#include "render/stencil/outline.h"

namespace enfilade::stencil {
namespace {

/// What the depth buffer is told of a wall: the nearer the larger, in numbers that a float has; there are far fewer
/// ranks than visits (plan.cpp), and no more than walls and things. What stands or hangs before a wall comes between
/// it and the one before that.
float order_of(const WallOnScreen& place) {
    constexpr float kStep = 0x1p-24f;
    return 1 - static_cast<float>(2 * place.rank + (place.is_pane ? 0 : 1)) * kStep;
}

/// Tilted, depth is measured along the line of sight, and a wall's ends say nothing about it. What is farther than this
/// is as good as at the horizon [m].
constexpr float kFarthest = 0x1p30f;

/// A picture that is shown once ends before its left edge would begin again [tiles].
constexpr double kBelowOne = 1 - 0x1p-24;

float f(double x) { return static_cast<float>(x); }

/// As the shader wants it: at look.from and per pixel.
void set(float (&three)[3], const Look& look, const Even& number) {
    three[0] = f(number.at(static_cast<double>(look.from[0]), static_cast<double>(look.from[1])));
    three[1] = f(number.per_x);
    three[2] = f(number.per_y);
}
void set(float (&four)[4], const Look& look, const Even& number, double fourth) {
    float three[3];
    set(three, look, number);
    std::copy(three, three + 3, four);
    four[3] = f(fourth);
}

void set_picture(Look& look, const Scene& scene, TextureId texture, SurfaceId id, Paint paint) {
    const Texture& picture = scene.input.textures[texture];
    const std::uint32_t way = paint != Paint::sky && !picture.numbers.empty() ? kByTable : 0u;
    look.id_and_paint = (look.id_and_paint & kClassicLight) | id | static_cast<std::uint32_t>(paint) << 24 | way;
    look.texels = scene.store.place_of(texture);
    look.size = size_of(picture);
}

void set_light(Look& look, const Lighting& lighting) {
    look.light = f(std::clamp(lighting.light, 0.0, 1.0));
    look.contrast = f(lighting.contrast);
    if (lighting.model == LightModel::classic) look.id_and_paint |= kClassicLight;
}

/// Where along the wall from its a, as a part of span: e_L, or -e_R where a is the right end.
Even from_a(const RayField& rays, const WallOnScreen& place) {
    if (place.missed) return span(rays, place) * place.missed->along;
    return place.swapped ? edge(rays, place.right_v) * -1 : edge(rays, place.left_v);
}

void set_along(Look& look, const Scene& scene, const WallOnScreen& place, double tiles, double offset) {
    set(look.a, look, from_a(scene.rays, place), tiles);
    look.b[0] = f(offset);
}

/// The surface of a wall or panel that hangs from `peg` above the eye.
void set_surface(Look& look, const Scene& scene, const WallOnScreen& place, const Surface& surface, double length,
                 double peg, SurfaceId id) {
    set_picture(look, scene, surface.texture, id, Paint::wall);
    set_along(look, scene, place, length / surface.tile_m.x, surface.offset_tiles.x);
    look.b[1] = f(fraction(peg / surface.tile_m.y - surface.offset_tiles.y));
    look.b[2] = f(1 / surface.tile_m.y);
}

/// Point lights on a wall or panel. length: of it [m].
void set_glow(Look& look, const Scene& scene, const LightGrid* grid, double length, double eye_z) {
    if (!grid) return;
    look.record = scene.records.glow(*grid, Vec2{length, 1} * (1 / kLightCell),
                                     Vec2{-grid->u, eye_z - grid->v} * (1 / kLightCell));
}

/// The ray's direction in the plane, its components divided by those of `unit`.
void set_direction(Look& look, const RayField& rays, const Pose& pose, Vec2 unit) {
    set(look.a, look, (rays.ahead * pose.forward.x + rays.right * pose.right.x) * (1 / unit.x), 0);
    set(look.b, look, (rays.ahead * pose.forward.y + rays.right * pose.right.y) * (1 / unit.y), 0);
}

LayerSource layers_from(const Scene& scene) {
    return {scene.map(), scene.input.snapshot, scene.input.textures, scene.store};
}

Look sky_look(const Scene& scene, const SeenWall& wall, const FlatNow& flat, SurfaceId id) {
    const Surface& surface = flat.surface;
    Look look = plain_look(scene, wall.place);
    set_picture(look, scene, surface.texture, id, Paint::sky);
    set_direction(look, scene.rays, wall.pose, {1, 1});
    look.c[0] = f(surface.tile_m.x);
    look.c[1] = f(surface.tile_m.y);
    look.c[2] = f(surface.offset_tiles.x);
    look.c[3] = f(surface.offset_tiles.y);
    look.record = scene.records.sky(layers_from(scene), flat);
    return look;
}

void set_tilted(Look& look, const RayField& rays, const WallOnScreen& place) {
    look.from[0] = f(rays.width / 2);
    look.from[1] = f(rays.height / 2);
    look.nearest = 0;
    look.farthest = kFarthest;
    const Look corner;
    if (!place.is_open_left) set(look.left_edge, corner, edge(rays, place.shown_left_v));
    if (!place.is_open_right) set(look.right_edge, corner, edge(rays, place.shown_right_v));
}

}  // namespace

Look plain_look(const Scene& scene, const WallOnScreen& place) {
    Look look;
    look.from[0] = f((place.begin + place.end) / 2);
    look.order = order_of(place);
    look.nearest = f(place.nearest());
    look.farthest = f(place.farthest());
    if (scene.rays.is_tilted) set_tilted(look, scene.rays, place);
    look.cross = f(depth_factor(place));
    set(look.span, look, span(scene.rays, place));
    return look;
}

Look wall_look(const Scene& scene, const SeenWall& wall, LayId at_rest, WallPart part) {
    const Wall& w = scene.map()[wall.place.wall];
    const Surface surface = picture_now(scene.map(), scene.input.snapshot, wall.place.wall, at_rest);
    Look look = plain_look(scene, wall.place);
    set_light(look, lighting_in(scene.map(), w.sector, light_at(scene.input.snapshot, w.sector), w.contrast));
    set_surface(look, scene, wall.place, surface, w.length, peg_height(wall.parts, surface.peg),
                wall_id(scene.map(), wall.place.wall, part));
    if (scene.lights)
        set_glow(look, scene, scene.lights->on_wall(scene.input.snapshot, wall.place.wall), w.length, wall.pose.eye_z);
    return look;
}

Look hanging_look(const Scene& scene, const SeenWall& wall, double top) {
    const WallId id = wall.place.wall;
    const Surface surface = picture_now(scene.map(), scene.input.snapshot, id, scene.map()[id].middle);
    Look look = wall_look(scene, wall, scene.map()[id].middle, WallPart::middle);
    const bool runs = surface.scroll.y != 0;  // through its place, over and over, as on a wall
    set_picture(look, scene, surface.texture, wall_id(scene.map(), id, WallPart::middle),
                runs ? Paint::wall : Paint::picture);
    if (!runs) look.b[1] = f(top / surface.tile_m.y);
    return look;
}

Look panel_look(const Scene& scene, const PanelOnScreen& shown, const Pose& pose) {
    const Panel& panel = scene.map()[shown.panel];
    Look look = plain_look(scene, shown.place);
    set_light(look,
              lighting_in(scene.map(), panel.sector, light_at(scene.input.snapshot, panel.sector), panel.contrast));
    set_surface(look, scene, shown.place, picture_now(scene.input.snapshot, panel), panel.length,
                panel.top - pose.eye_z, panel_id(scene.map(), shown.panel));
    if (scene.lights)
        set_glow(look, scene, scene.lights->on_panel(scene.input.snapshot, shown.panel), panel.length, pose.eye_z);
    return look;
}

Look thing_look(const Scene& scene, const ThingOnScreen& thing) {
    Look look = plain_look(scene, thing.place);
    set_picture(look, scene, thing.texture, thing.id, Paint::picture);
    set_light(look, thing.lighting);
    set_along(look, scene, thing.place, kBelowOne, 0);
    if (!scene.rays.is_tilted) look.farthest = f(thing.place.cross / (thing.place.right_v.x - thing.place.left_v.x));
    if (scene.lights) set_glow(look, scene, scene.lights->on_thing(scene.input.snapshot, thing.thing), 0, 0);
    look.b[1] = f(thing.top / thing.height);
    look.b[2] = f(1 / thing.height);
    return look;
}

Look flat_look(const Scene& scene, const SeenWall& wall, const FlatNow& flat, double height, const LightGrid* grid,
               SurfaceId id) {
    const Surface& surface = flat.surface;
    if (flat.sky) return sky_look(scene, wall, flat, id);
    Look look = plain_look(scene, wall.place);
    set_picture(look, scene, surface.texture, id, Paint::flat);
    const SectorId sector = scene.map()[wall.place.wall].sector;
    set_light(look, lighting_in(scene.map(), sector, light_at(scene.input.snapshot, sector), 1));
    set_direction(look, scene.rays, wall.pose, surface.tile_m);
    const Vec2 from_origin = wall.pose.eye - flat.origin;
    look.c[0] = f(fraction(from_origin.x / surface.tile_m.x - surface.offset_tiles.x));
    look.c[1] = f(fraction(from_origin.y / surface.tile_m.y - surface.offset_tiles.y));
    look.c[2] = f(height);
    if (grid)
        look.record = scene.records.glow(*grid, surface.tile_m * (1 / kLightCell),
                                         (wall.pose.eye - Vec2{grid->u, grid->v}) * (1 / kLightCell));
    if (flat.layer_count == 0) return look;
    look.record = scene.records.level(layers_from(scene), flat, wall.pose.eye, look.record);
    look.id_and_paint |= kLayered;
    return look;
}

Look end_look(const Scene& scene, const SeenWall& wall) {
    Look look = plain_look(scene, wall.place);
    look.id_and_paint = kRecursionEnd | static_cast<std::uint32_t>(Paint::color) << 24;
    look.texels = pixel_of(scene.map().render.recursion_color);
    return look;
}

}  // namespace enfilade::stencil
