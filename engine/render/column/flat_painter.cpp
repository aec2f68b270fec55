#include "render/column/flat_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/kernels.h"

namespace enfilade::column {
namespace {

bool has_fog(const Scene& scene) { return scene.map.render.fog_reach > 0; }

}  // namespace

void FlatPainter::start(const Scene& scene, const Pose& pose, const Flat& flat, FlatSide side, double height,
                        double light, SurfaceId id) {
    pose_ = &pose;
    flat_ = flat;
    texture_ = &scene.textures[flat.surface.texture];
    id_ = id;
    height_ = height;
    light_ = light;
    is_extended_ = side == FlatSide::floor ? height >= 0 : height <= 0;
    const Surface& surface = flat.surface;
    base_u_ = fraction((pose.eye.x - flat.origin.x) / surface.tile_m.x - surface.offset_tiles.x);
    base_v_ = fraction((pose.eye.y - flat.origin.y) / surface.tile_m.y - surface.offset_tiles.y);
    prepared_top_ = prepared_bottom_ = 0;
}

void FlatPainter::paint(const Scene& scene, int x, int top, int bottom, double wall_depth) {
    if (top >= bottom) return;
    if (flat_.sky)
        paint_sky(scene, x, top, bottom);
    else
        paint_level(scene, x, top, bottom, wall_depth);
}

void FlatPainter::paint_level(const Scene& scene, int x, int top, int bottom, double wall_depth) {
    prepare_rows(scene, top, bottom);
    if (is_extended_) shade_extended_rows(scene, top, bottom, wall_depth);
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
                       has_fog(scene) ? row_mists_.data() : nullptr,
                       pixel_of(scene.map.render.fog_color)};
    fill_flat(scene.canvas.run(x, top, bottom), flat);
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) {
        const double depth = std::min(row_depths_[y], wall_depth);
        note(scene, x, y, id_, depth, base_u_ + depth * flat.step_u, base_v_ + depth * flat.step_v);
    }
}

void FlatPainter::paint_sky(const Scene& scene, int x, int top, int bottom) {
    const Screen& screen = scene.screen;
    const Vec2 ray = pose_->forward + pose_->right * screen.slopes[x];
    const Surface& surface = flat_.surface;
    // The ray's climb is per metre of depth; per metre along the ground it is less by the length of `ray`.
    const double rise = 1 / (screen.focal_y * std::sqrt(dot(ray, ray)));
    const SkyTexel horizon = sky_texel(surface.tile_m, surface.offset_tiles, turn_of(ray), 0);
    const double v_at_horizon = 1 - surface.offset_tiles.y;
    const std::uint32_t column = texel_index(horizon.u, texture_->width);
    fill_sky(scene.canvas.run(x, top, bottom),
             {&texture_->pixels[std::size_t{column} * texture_->height], texture_->height, v_at_horizon,
              -rise / surface.tile_m.y, screen.row_rises.data()});
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) {
        const SkyTexel texel =
            sky_texel(surface.tile_m, surface.offset_tiles, turn_of(ray), screen.row_rises[y] * rise);
        note(scene, x, y, id_, std::numeric_limits<double>::infinity(), texel.u, texel.v);
    }
}

void FlatPainter::prepare_rows(const Scene& scene, int top, int bottom) {
    row_depths_.resize(scene.screen.row_depths.size());
    row_shades_.resize(scene.screen.row_depths.size());
    if (has_fog(scene)) row_mists_.resize(scene.screen.row_depths.size());
    if (prepared_top_ >= prepared_bottom_) prepared_top_ = prepared_bottom_ = top;
    while (prepared_top_ > top) prepare_row(scene, --prepared_top_);
    while (prepared_bottom_ < bottom) prepare_row(scene, prepared_bottom_++);
}

void FlatPainter::prepare_row(const Scene& scene, int row) {
    const double depth_per_metre = scene.screen.row_depths[row];
    // A level ray meets a level plane at infinity, also one at its own height. Behind the eye (below 0) only where the
    // eye is above the ceiling or below the floor it looks at.
    row_depths_[row] = std::isinf(depth_per_metre) ? depth_per_metre : std::max(height_ * depth_per_metre, 0.0);
    shade_row(scene, row, row_depths_[row]);
}

void FlatPainter::shade_row(const Scene& scene, int row, double depth) {
    row_shades_[row] = shade_at(scene.map.render.light, light_, 1, depth);
    if (has_fog(scene)) row_mists_[row] = mist_at(scene.map.render.fog_reach, depth);
}

/// A flat seen from its wrong side (past a step that is not drawn, or by an eye outside the room's heights) never comes
/// nearer than the wall it is stretched to: its rows are lit as far away as they are drawn, column by column.
void FlatPainter::shade_extended_rows(const Scene& scene, int top, int bottom, double wall_depth) {
    for (int y = top; y < bottom; ++y) shade_row(scene, y, std::min(row_depths_[y], wall_depth));
}

}  // namespace enfilade::column
