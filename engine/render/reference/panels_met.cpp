#include "render/reference/panels_met.h"

#include <algorithm>
#include <cmath>

#include "render/picture_now.h"

namespace enfilade {
namespace {

/// Is the ray at `height` above the eye, or higher, where it meets the panel? A panel through the eye is met an instant
/// after the start, as a wall is.
bool reaches(const RoomRay& ray, const PanelHit& at, double height) {
    if (at.depth == 0 && height == 0) return ray.course.climb >= 0;
    return (ray.course.climb + kTieClimb) * at.depth >= height;
}

/// A level ray, or a panel through the eye, is compared with a height without any rounding.
bool is_close_to(const RoomRay& ray, const PanelHit& at, double height) {
    if (ray.course.climb == 0 || at.depth == 0) return false;
    return std::fabs(ray.course.climb * at.depth - height) < kAmbiguous;
}

Pane pane_of(const Scene& scene, const RoomRay& ray, const PanelHit& at) {
    const Panel& panel = scene.map[at.panel];
    const Surface surface = picture_now(scene.snapshot, panel);
    const Texture& texture = scene.textures[surface.texture];
    const double top = panel.top - ray.hit.space.eye_z;
    const double u = at.along * panel.length / surface.tile_m.x - surface.offset_tiles.x;
    const double v = (top - ray.course.climb * at.depth) / surface.tile_m.y - surface.offset_tiles.y;
    const Texel shown = texel(texture, place_on_tile(u), place_on_tile(v));
    const Lighting lighting =
        lighting_in(scene.map, panel.sector, light_at(scene.snapshot, panel.sector), panel.contrast);
    const double depth = at.depth * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = panel_id(scene.map, at.panel);
    pane.seen.depth = depth;
    pane.seen.texel = {static_cast<float>(fraction(u)), static_cast<float>(fraction(v))};
    pane.alpha = shown.color >> 24;
    const LightGrid* grid = scene.lights ? scene.lights->on_panel(scene.map, scene.snapshot, at.panel) : nullptr;
    const double z = ray.hit.space.eye_z + ray.course.climb * at.depth;
    pane.seen.color = lit(scene, shown, lighting, depth, glow_on(grid, at.along * panel.length, z));
    pane.ambiguous = is_at_rim_of_hole(texture, pane.seen.texel, surface.tile_m);
    return pane;
}

}  // namespace

bool find_panels_met(const Scene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    bool ambiguous = false;
    const Heights room = heights_at(scene.snapshot, ray.hit.sector);
    const double eye_z = ray.hit.space.eye_z;
    for (const PanelHit& at : ray.hit.panels) {
        const Panel& panel = scene.map[at.panel];
        const double top = std::min(panel.top, room.ceiling_z) - eye_z;
        const double bottom = std::max(panel.bottom, room.floor_z) - eye_z;
        ambiguous |= is_close_to(ray, at, top) || is_close_to(ray, at, bottom);
        if (reaches(ray, at, bottom) && !reaches(ray, at, top)) met.push_back({at.depth, pane_of(scene, ray, at)});
    }
    return ambiguous;
}

}  // namespace enfilade
