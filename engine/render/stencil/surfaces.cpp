#include "render/stencil/surfaces.h"

#include <algorithm>

#include "render/lighting.h"
#include "render/shade.h"
#include "render/sprite.h"
#include "render/stencil/panorama.h"

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
constexpr float kHorizon = 0x1p30f;

/// A picture that is shown once ends before its left edge would begin again [tiles].
constexpr double kBelowOne = 1 - 0x1p-24;

float f(double x) { return static_cast<float>(x); }

/// As the shader wants it: at params.from and per pixel.
void set(float (&three)[3], const PaintParams& params, const Even& number) {
    three[0] = f(number.at(static_cast<double>(params.from[0]), static_cast<double>(params.from[1])));
    three[1] = f(number.per_x);
    three[2] = f(number.per_y);
}
void set(float (&four)[4], const PaintParams& params, const Even& number, double fourth) {
    float three[3];
    set(three, params, number);
    std::copy(three, three + 3, four);
    four[3] = f(fourth);
}

void set_picture(PaintParams& params, const DrawInput& scene, TextureId texture, PixelSurface id, Paint paint) {
    const Texture& picture = scene.input.textures[texture];
    const std::uint32_t way = paint != Paint::sky && !picture.numbers.empty() ? kByTable : 0u;
    params.id_and_paint = (params.id_and_paint & kClassicLight) | id | static_cast<std::uint32_t>(paint) << 24 | way;
    params.texels = scene.store.place_of(texture);
    params.size = size_of(picture);
}

void set_light(PaintParams& params, const Lighting& lighting) {
    params.light = f(std::clamp(lighting.light, 0.0, 1.0));
    params.contrast = f(lighting.contrast);
    if (lighting.model == LightModel::classic) params.id_and_paint |= kClassicLight;
}

/// Where along the wall, counted from its a and beyond `known`, as a part of span: e_L, or -e_R where a is the right
/// end, less known (e_L - e_R).
Even from_known(const RayField& rays, const WallOnScreen& place, double known) {
    if (place.missed) return span(rays, place) * (place.missed->along - known);
    const double left = place.swapped ? -known : 1 - known, right = place.swapped ? known - 1 : known;
    return edge(rays, place.left_v) * left + edge(rays, place.right_v) * right;
}

/// The part of the wall, from its a, that is nearest to the eye.
double nearest_part(const WallOnScreen& place) {
    const Vec2 along = place.right_v - place.left_v;
    const double part = std::clamp(-dot(place.left_v, along) / dot(along, along), 0.0, 1.0);
    return place.swapped ? 1 - part : part;
}

/// Floats are good to a part of the way from what is known: of a wall of kilometres whose end was known, texels before
/// the eye would be lost.
/// known : the part of the wall where the picture's place is known
void set_along(PaintParams& params, const DrawInput& scene, const WallOnScreen& place, double tiles, double offset,
               double known) {
    set(params.a, params, from_known(scene.rays, place, known), tiles);
    params.b[0] = f(offset);
    params.c[0] = f(-known);
    params.c[1] = f(1 - known);
}

/// The surface of a wall or panel that hangs from `peg` above the eye.
void set_surface(PaintParams& params, const DrawInput& scene, const WallOnScreen& place, const Surface& surface,
                 double length, double peg, PixelSurface id) {
    set_picture(params, scene, surface.texture, id, Paint::wall);
    const double tiles = length / surface.tile_m.x, known = nearest_part(place);
    set_along(params, scene, place, tiles, fraction(surface.offset_tiles.x - known * tiles), known);
    params.b[1] = f(fraction(peg / surface.tile_m.y - surface.offset_tiles.y));
    params.b[2] = f(1 / surface.tile_m.y);
}

/// Point lights on a wall or panel. length: of it [m].
void set_lamplight(PaintParams& params, const DrawInput& scene, const LightGrid* grid, double length, double eye_z) {
    if (!grid) return;
    params.record =
        scene.records.lamplight(*grid, Vec2{length, 1} * grid->per_m, Vec2{-grid->u, eye_z - grid->v} * grid->per_m);
}

/// The ray's direction in the plane, its components divided by those of `unit`.
void set_direction(PaintParams& params, const RayField& rays, const Pose& pose, Vec2 unit) {
    set(params.a, params, (rays.ahead * pose.forward.x + rays.right * pose.right.x) * (1 / unit.x), 0);
    set(params.b, params, (rays.ahead * pose.forward.y + rays.right * pose.right.y) * (1 / unit.y), 0);
}

LayerSource layers_from(const DrawInput& scene) {
    return {scene.map(), scene.input.snapshot, scene.input.textures, scene.store};
}

PaintParams sky_params(const DrawInput& scene, const SeenWall& wall, const FlatNow& flat, PixelSurface id) {
    const Surface& surface = flat.surface;
    PaintParams params = plain_params(scene, wall.place);
    set_picture(params, scene, surface.texture, id, Paint::sky);
    set_direction(params, scene.rays, wall.pose, {1, 1});
    params.c[0] = f(surface.tile_m.x);
    params.c[1] = f(surface.tile_m.y);
    params.c[2] = f(surface.offset_tiles.x);
    params.c[3] = f(surface.offset_tiles.y);
    params.record = scene.records.sky(layers_from(scene), flat);
    return params;
}

void set_tilted(PaintParams& params, const RayField& rays, const WallOnScreen& place) {
    params.from[0] = f(rays.width / 2);
    params.from[1] = f(rays.height / 2);
    params.nearest = 0;
    params.farthest = kHorizon;
    const PaintParams corner;
    if (!place.is_open_left) set(params.left_edge, corner, edge(rays, place.shown_left_v));
    if (!place.is_open_right) set(params.right_edge, corner, edge(rays, place.shown_right_v));
}

}  // namespace

PaintParams plain_params(const DrawInput& scene, const WallOnScreen& place) {
    PaintParams params;
    params.from[0] = f((place.begin + place.end) / 2);
    params.order = order_of(place);
    params.nearest = f(place.nearest());
    params.farthest = f(place.farthest());
    if (scene.rays.is_tilted) set_tilted(params, scene.rays, place);
    params.cross = f(depth_factor(place));
    set(params.span, params, span(scene.rays, place));
    return params;
}

PaintParams wall_params(const DrawInput& scene, const SeenWall& wall, SurfaceId at_rest, WallPart part) {
    const Wall& w = scene.map()[wall.place.wall];
    const Surface surface = picture_now(scene.map(), scene.input.snapshot, wall.place.wall, at_rest);
    PaintParams params = plain_params(scene, wall.place);
    set_light(params, lighting_in(scene.map(), w.sector, light_at(scene.input.snapshot, w.sector), w.contrast));
    set_surface(params, scene, wall.place, surface, w.length, peg_height(wall.parts, surface.peg),
                wall_id(scene.map(), wall.place.wall, part));
    if (scene.lights)
        set_lamplight(params, scene, scene.lights->on_wall(scene.input.snapshot, wall.place.wall), w.length,
                      wall.pose.eye_z);
    return params;
}

PaintParams hanging_params(const DrawInput& scene, const SeenWall& wall, double top) {
    const WallId id = wall.place.wall;
    const Surface surface = picture_now(scene.map(), scene.input.snapshot, id, scene.map()[id].middle);
    PaintParams params = wall_params(scene, wall, scene.map()[id].middle, WallPart::middle);
    const bool runs = surface.scroll.y != 0;  // through its place, over and over, as on a wall
    set_picture(params, scene, surface.texture, wall_id(scene.map(), id, WallPart::middle),
                runs ? Paint::wall : Paint::picture);
    if (!runs) params.b[1] = f(top / surface.tile_m.y);
    return params;
}

PaintParams panel_params(const DrawInput& scene, const PanelOnScreen& shown, const Pose& pose) {
    const Panel& panel = scene.map()[shown.panel];
    PaintParams params = plain_params(scene, shown.place);
    set_light(params,
              lighting_in(scene.map(), panel.sector, light_at(scene.input.snapshot, panel.sector), panel.contrast));
    set_surface(params, scene, shown.place, picture_now(scene.input.snapshot, panel), panel.length,
                panel.top - pose.eye_z, panel_id(scene.map(), shown.panel));
    if (scene.lights)
        set_lamplight(params, scene, scene.lights->on_panel(scene.input.snapshot, shown.panel), panel.length,
                      pose.eye_z);
    return params;
}

PaintParams thing_params(const DrawInput& scene, const ThingOnScreen& thing) {
    PaintParams params = plain_params(scene, thing.place);
    set_picture(params, scene, thing.texture, thing.id, Paint::picture);
    set_light(params, thing.lighting);
    set_along(params, scene, thing.place, kBelowOne, 0, 0);
    if (!scene.rays.is_tilted) params.farthest = f(thing.place.cross / (thing.place.right_v.x - thing.place.left_v.x));
    if (scene.lights) set_lamplight(params, scene, scene.lights->on_thing(scene.input.snapshot, thing.thing), 0, 0);
    params.b[1] = f(thing.top / thing.height);
    params.b[2] = f(1 / thing.height);
    return params;
}

PaintParams flat_params(const DrawInput& scene, const SeenWall& wall, const FlatNow& flat, double height,
                        const LightGrid* grid, PixelSurface id) {
    const Surface& surface = flat.surface;
    if (flat.sky) return sky_params(scene, wall, flat, id);
    PaintParams params = plain_params(scene, wall.place);
    set_picture(params, scene, surface.texture, id, Paint::flat);
    const SectorId sector = scene.map()[wall.place.wall].sector;
    set_light(params, lighting_in(scene.map(), sector, light_at(scene.input.snapshot, sector), 1));
    set_direction(params, scene.rays, wall.pose, surface.tile_m);
    const Vec2 from_origin = wall.pose.eye - flat.origin;
    params.c[0] = f(fraction(from_origin.x / surface.tile_m.x - surface.offset_tiles.x));
    params.c[1] = f(fraction(from_origin.y / surface.tile_m.y - surface.offset_tiles.y));
    params.c[2] = f(height);
    if (grid)
        params.record = scene.records.lamplight(*grid, surface.tile_m * grid->per_m,
                                                (wall.pose.eye - Vec2{grid->u, grid->v}) * grid->per_m);
    if (flat.layer_count == 0) return params;
    params.record = scene.records.level(layers_from(scene), flat, wall.pose.eye, params.record);
    params.id_and_paint |= kLayered;
    return params;
}

PaintParams end_params(const DrawInput& scene, const SeenWall& wall) {
    PaintParams params = plain_params(scene, wall.place);
    params.id_and_paint = kRecursionEnd | static_cast<std::uint32_t>(Paint::color) << 24;
    params.texels = pixel_of(scene.map().render.recursion_color);
    return params;
}

}  // namespace enfilade::stencil
