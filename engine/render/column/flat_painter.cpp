#include "render/column/flat_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/fog.h"
#include "render/picture_now.h"

namespace enfilade::column {
namespace {

/// What a ray climbs from one row to the next: where the sky's rows are straight, per metre of depth; else per metre
/// along the ground, which is longer by the length of `ray`.
double rise_per_row(const Scene& scene, Vec2 ray) {
    if (sky_rows(scene.map.render, false) == SkyRows::straight) return 1 / scene.screen.focal_y;
    return 1 / (scene.screen.focal_y * std::sqrt(dot(ray, ray)));
}

}  // namespace

void FlatPainter::start(const Scene& scene, const Pose& pose, const Flat& flat, FlatSide side, double height,
                        const Lighting& lighting, const LightGrid* glow, SurfaceId id) {
    pose_ = &pose;
    flat_ = flat;
    texture_ = &scene.textures[flat.surface.texture];
    color_table_ = texture_->numbers.empty() ? nullptr : &scene.textures.color_table;
    id_ = id;
    height_ = height;
    lighting_ = lighting;
    glow_ = glow;
    fog_ = fog_of(scene.map);
    is_extended_ = side == FlatSide::floor ? height >= 0 : height <= 0;
    const Surface& surface = flat.surface;
    base_u_ = fraction((pose.eye.x - flat.origin.x) / surface.tile_m.x - surface.offset_tiles.x);
    base_v_ = fraction((pose.eye.y - flat.origin.y) / surface.tile_m.y - surface.offset_tiles.y);
    prepared_top_ = prepared_bottom_ = 0;
    if (!built_in::kSkyLayers) return;
    layers_.clear();
    for (std::uint32_t i = 0; i < flat.layer_count; ++i)
        layers_.push_back(layer_now(scene.map, scene.snapshot, scene.map.sky_layers[flat.first_layer + i]));
}

void FlatPainter::paint(const Scene& scene, int x, int top, int bottom, double wall_depth) {
    if (top >= bottom) return;
    if (built_in::kSky && flat_.sky)
        paint_sky(scene, x, top, bottom);
    else
        paint_level(scene, x, top, bottom, wall_depth);
}

// Out of line, so that flats without point lights and color tables do not save registers for them.
[[gnu::noinline]] void FlatPainter::fill_rich(const Run& run, const FlatRun& flat, Vec2 ray) const {
    if (!built_in::kPointLights || !glow_) return fill_flat_by_table(run, flat);
    fill_lit_flat(run, flat,
                  {glow_, (pose_->eye.x - glow_->u) / kLightCell, (pose_->eye.y - glow_->v) / kLightCell,
                   ray.x / kLightCell, ray.y / kLightCell});
}

void FlatPainter::paint_level(const Scene& scene, int x, int top, int bottom, double wall_depth) {
    prepare_rows(scene, top, bottom);
    if (is_extended_) shade_extended_rows(top, bottom, wall_depth);
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x];
    const Vec2 tile = flat_.surface.tile_m;
    const FlatRun flat{texture_,
                       base_u_,
                       base_v_,
                       ray.x / tile.x,
                       ray.y / tile.y,
                       wall_depth,
                       row_depths_.data(),
                       row_shades_.data(),
                       is_there(fog_) ? row_mists_.data() : nullptr,
                       fog_.color,
                       color_table_};
    const Run run = scene.canvas.run(x, top, bottom);
    if ((built_in::kPointLights && glow_) || color_table_)
        fill_rich(run, flat, ray);
    else
        fill_flat(run, flat);
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) {
        const double depth = std::min(row_depths_[y], wall_depth);
        note(scene, x, y, id_, depth, base_u_ + depth * flat.step_u, base_v_ + depth * flat.step_v);
    }
}

void FlatPainter::paint_sky(const Scene& scene, int x, int top, int bottom) {
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x];
    const Run run = scene.canvas.run(x, top, bottom);
    fill_sky(run, sky_run(scene, flat_.surface, ray));
    for (const Surface& layer : layers_) lay_sky(run, sky_run(scene, layer, ray));
    if (scene.facts == nullptr) return;
    const double rise = rise_per_row(scene, ray);
    for (int y = top; y < bottom; ++y) {
        const SkyTexel texel =
            sky_texel(flat_.surface.tile_m, flat_.surface.offset_tiles, turn_of(ray), scene.screen.row_rises[y] * rise);
        note(scene, x, y, id_, std::numeric_limits<double>::infinity(), texel.u, texel.v);
    }
}

SkyRun FlatPainter::sky_run(const Scene& scene, const Surface& surface, Vec2 ray) const {
    const Texture& texture = scene.textures[surface.texture];
    const SkyTexel horizon = sky_texel(surface.tile_m, surface.offset_tiles, turn_of(ray), 0);
    const std::uint32_t column = texel_of(place_on_tile(horizon.u), texture.width);
    return {&texture.pixels[std::size_t{column} * texture.height], texture.height, 1 - surface.offset_tiles.y,
            -rise_per_row(scene, ray) / surface.tile_m.y, scene.screen.row_rises.data()};
}

void FlatPainter::prepare_rows(const Scene& scene, int top, int bottom) {
    row_depths_.resize(scene.screen.row_depths.size());
    row_shades_.resize(scene.screen.row_depths.size());
    if (is_there(fog_)) row_mists_.resize(scene.screen.row_depths.size());
    if (prepared_top_ >= prepared_bottom_) prepared_top_ = prepared_bottom_ = top;
    while (prepared_top_ > top) prepare_row(scene, --prepared_top_);
    while (prepared_bottom_ < bottom) prepare_row(scene, prepared_bottom_++);
}

void FlatPainter::prepare_row(const Scene& scene, int row) {
    const double depth_per_metre = scene.screen.row_depths[row];
    // A level ray meets a level plane at infinity, also one at its own height. Behind the eye (below 0) only where the
    // eye is above the ceiling or below the floor it looks at.
    row_depths_[row] = std::isinf(depth_per_metre) ? depth_per_metre : std::max(height_ * depth_per_metre, 0.0);
    shade_row(row, row_depths_[row]);
}

void FlatPainter::shade_row(int row, double depth) {
    row_shades_[row] = shade_at(lighting_, depth);
    if (is_there(fog_)) row_mists_[row] = mist_at(fog_.reach, depth);
}

/// A flat seen from its wrong side (past a step that is not drawn, or by an eye outside the room's heights) never comes
/// nearer than the wall it is stretched to: its rows are lit as far away as they are drawn, column by column.
void FlatPainter::shade_extended_rows(int top, int bottom, double wall_depth) {
    for (int y = top; y < bottom; ++y) shade_row(y, std::min(row_depths_[y], wall_depth));
}

}  // namespace enfilade::column
