#include "render/column/flat_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/sprite.h"

namespace enfilade::column {
namespace {

constexpr Shade kFullBright = 256;

/// What a ray climbs from one row to the next: where the sky's rows are straight, per metre of depth; else per metre
/// along the ground, which is longer by the length of `ray`.
double rise_per_row(const Scene& scene, Vec2 ray) {
    if (sky_rows(scene.map.render, false) == SkyRows::straight) return 1 / scene.screen.focal_y;
    return 1 / (scene.screen.focal_y * std::sqrt(dot(ray, ray)));
}

/// The largest length of a ray's part along an axis, per metre of depth.
double longest_ray(const Screen& screen) {
    return 1 + std::max(std::fabs(screen.slopes.front()), std::fabs(screen.slopes.back()));
}

}  // namespace

void FlatPainter::start(const Scene& scene, const Pose& pose, const FlatNow& flat, FlatSide side, double height,
                        const Lighting& lighting, const LightGrid* glow, SurfaceId id) {
    pose_ = &pose;
    flat_ = flat;
    texture_ = &scene.textures[flat.surface.texture];
    color_table_ = texture_->numbers.empty() ? nullptr : &scene.textures.color_table;
    id_ = id;
    height_ = height;
    dimming_ = dimming_of(lighting);
    glow_ = glow;
    fog_ = fog_of(scene.map);
    is_extended_ = side == FlatSide::floor ? height >= 0 : height <= 0;
    const Surface& surface = flat.surface;
    base_u_ = fraction((pose.eye.x - flat.origin.x) / surface.tile_m.x - surface.offset_tiles.x);
    base_v_ = fraction((pose.eye.y - flat.origin.y) / surface.tile_m.y - surface.offset_tiles.y);
    prepared_top_ = prepared_bottom_ = 0;
    row_depths_.resize(scene.screen.row_depths.size() + kRowsBeyond);
    row_shades_.resize(row_depths_.size());
    row_darkness_.resize(row_depths_.size());
    if (glow_) full_light_.resize(row_depths_.size(), darkness_of(nullptr, kFullBright));
    if (is_there(fog_)) row_mists_.resize(row_depths_.size());
    is_plain_ = !(built_in::kSky && flat.sky) && !(built_in::kPointLights && glow) && !is_there(fog_) && !is_extended_;
    near_limit_ = (kNearTiles - 1) * std::min(surface.tile_m.x, surface.tile_m.y) / longest_ray(scene.screen);
    if (!built_in::kSkyLayers) return;
    layers_.clear();
    for (std::uint32_t i = 0; i < flat.layer_count; ++i)
        layers_.push_back(layer_now(scene.map, scene.snapshot, scene.map.sky_layers[flat.first_layer + i]));
}

void FlatPainter::paint(const Scene& scene, const WallLooks& looks, const int* tops, const int* bottoms) {
    if (is_plain_ && looks.farthest < near_limit_) return paint_plain(scene, looks, tops, bottoms);
    for (int i = 0; i < looks.count; ++i) {
        if (tops[i] >= bottoms[i]) continue;
        if (built_in::kSky && flat_.sky)
            paint_sky(scene, looks.begin + i, tops[i], bottoms[i]);
        else
            paint_level(scene, looks.begin + i, {tops[i], bottoms[i]}, looks.depth[i]);
    }
}

void FlatPainter::paint_plain(const Scene& scene, const WallLooks& looks, const int* tops, const int* bottoms) {
    int top = scene.screen.height, bottom = 0;
    for (int i = 0; i < looks.count; ++i) {
        const bool is_seen = tops[i] < bottoms[i];
        top = is_seen && tops[i] < top ? tops[i] : top;
        bottom = is_seen && bottoms[i] > bottom ? bottoms[i] : bottom;
    }
    if (top >= bottom) return;
    prepare_rows(scene, top, bottom);
    double step_u[WallLooks::kMost], step_v[WallLooks::kMost];
    const double* const slopes = &scene.screen.slopes[static_cast<std::size_t>(looks.begin)];
    const Vec2 forward = pose_->forward, right = pose_->right, tile = flat_.surface.tile_m;
    for (int i = 0; i < looks.count; ++i) {
        step_u[i] = (forward.x + right.x * slopes[i]) / tile.x;
        step_v[i] = (forward.y + right.y * slopes[i]) / tile.y;
    }
    const ColumnRuns runs{scene.canvas.column(looks.begin), scene.canvas.pitch(), looks.count, tops, bottoms};
    scene.kernels.fill_flats({runs, texture_, base_u_, base_v_, step_u, step_v, looks.depth, row_depths_.data(),
                              row_darkness_.data(), color_table_});
    if (scene.facts == nullptr) return;
    for (int i = 0; i < looks.count; ++i) note_level(scene, looks.begin + i, tops[i], bottoms[i], looks.depth[i]);
}

void FlatPainter::paint_level(const Scene& scene, int x, OpenRows rows, double wall_depth) {
    prepare_rows(scene, rows.top, rows.bottom);
    if (is_extended_) shade_extended_rows(rows.top, rows.bottom, wall_depth);
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x], tile = flat_.surface.tile_m;
    const FlatColumn column{x, ray, ray.x / tile.x, ray.y / tile.y, wall_depth};
    if (built_in::kPointLights && glow_)
        paint_lit(scene, column, rows);
    else
        fill(scene, scene.canvas.column(x), column, rows, row_darkness_.data(), color_table_);
    if (is_there(fog_))
        scene.passes.mist(scene.canvas.run(x, rows.top, rows.bottom), fog_.color, &row_mists_[std::size_t(rows.top)]);
    if (scene.facts != nullptr) note_level(scene, x, rows.top, rows.bottom, wall_depth);
}

void FlatPainter::fill(const Scene& scene, std::uint32_t* row_0, const FlatColumn& column, const OpenRows& rows,
                       const std::uint32_t* darkness, const ColorTable* table) const {
    const PlainFlats flats{{row_0, 0, 1, &rows.top, &rows.bottom},
                           texture_,
                           base_u_,
                           base_v_,
                           &column.step_u,
                           &column.step_v,
                           &column.farthest,
                           row_depths_.data(),
                           darkness,
                           table};
    column.farthest < near_limit_ ? scene.kernels.fill_flats(flats) : fill_far_flats(flats);
}

void FlatPainter::paint_lit(const Scene& scene, const FlatColumn& column, const OpenRows& rows) const {
    const FlatGlow glow = glow_at(column);
    const OpenRows lit = lit_rows(glow, rows);
    std::uint32_t* const pixels = scene.canvas.column(column.x);
    fill(scene, pixels, column, {rows.top, lit.top}, row_darkness_.data(), color_table_);
    fill(scene, pixels, column, {lit.bottom, rows.bottom}, row_darkness_.data(), color_table_);
    LitRun to{scene.canvas.run(column.x, lit.top, lit.bottom)};
    if (color_table_) {
        std::uint32_t* const texels = scene.scratch.texels.data();
        fill(scene, pixels, column, lit, row_darkness_.data(), color_table_);
        fill(scene, texels, column, lit, full_light_.data(), nullptr);
        to.texels = texels + lit.top;
    } else {
        fill(scene, pixels, column, lit, full_light_.data(), nullptr);
    }
    scene.passes.lamps.light_flat(to, glow);
}

FlatGlow FlatPainter::glow_at(const FlatColumn& column) const {
    return {glow_,
            (pose_->eye.x - glow_->u) / kLightCell,
            (pose_->eye.y - glow_->v) / kLightCell,
            column.ray.x / kLightCell,
            column.ray.y / kLightCell,
            column.farthest,
            row_depths_.data(),
            row_shades_.data()};
}

/// Which of the rows may be lit: only their ends are looked at.
OpenRows FlatPainter::lit_rows(const FlatGlow& glow, const OpenRows& rows) const {
    const auto is_dark = [&](int row) {
        const double depth = std::min(row_depths_[row], glow.farthest);
        return is_beyond_light(*glow.grid, glow.base_u + depth * glow.step_u, glow.base_v + depth * glow.step_v);
    };
    OpenRows lit = rows;
    while (lit.top < lit.bottom && is_dark(lit.top)) ++lit.top;
    while (lit.top < lit.bottom && is_dark(lit.bottom - 1)) --lit.bottom;
    return lit;
}

void FlatPainter::note_level(const Scene& scene, int x, int top, int bottom, double wall_depth) const {
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x];
    const Vec2 tile = flat_.surface.tile_m;
    for (int y = top; y < bottom; ++y) {
        const double depth = std::min(row_depths_[y], wall_depth);
        note(scene, x, y, id_, depth, base_u_ + depth * (ray.x / tile.x), base_v_ + depth * (ray.y / tile.y));
    }
}

void FlatPainter::paint_sky(const Scene& scene, int x, int top, int bottom) {
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x];
    const SkyColumn column{scene.scratch.turns.of(*pose_, x, ray), rise_per_row(scene, ray)};
    const Run run = scene.canvas.run(x, top, bottom);
    scene.kernels.fill_sky(run, sky_run(scene, flat_.surface, column));
    for (const Surface& layer : layers_) lay_sky(run, sky_run(scene, layer, column));
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) {
        const SkyTexel texel = sky_texel(flat_.surface.tile_m, flat_.surface.offset_tiles, column.turn,
                                         scene.screen.row_rises[y] * column.rise_per_row);
        note(scene, x, y, id_, std::numeric_limits<double>::infinity(), texel.u, texel.v);
    }
}

SkyRun FlatPainter::sky_run(const Scene& scene, const Surface& surface, const SkyColumn& column) const {
    const Texture& texture = scene.textures[surface.texture];
    const SkyTexel horizon = sky_texel(surface.tile_m, surface.offset_tiles, column.turn, 0);
    const std::uint32_t texels = texel_of(place_on_tile(horizon.u), texture.width);
    return {&texture.pixels[std::size_t{texels} * texture.height], texture.height, 1 - surface.offset_tiles.y,
            -column.rise_per_row / surface.tile_m.y, scene.screen.row_rises.data()};
}

void FlatPainter::prepare_rows(const Scene& scene, int top, int bottom) {
    if (top >= prepared_top_ && bottom <= prepared_bottom_) return;
    if (prepared_top_ >= prepared_bottom_) prepared_top_ = prepared_bottom_ = top;
    if (top < prepared_top_) prepare_more_rows(scene, top, prepared_top_);
    if (bottom > prepared_bottom_) prepare_more_rows(scene, prepared_bottom_, bottom);
    prepared_top_ = std::min(prepared_top_, top);
    prepared_bottom_ = std::max(prepared_bottom_, bottom);
}

// A level ray meets a level plane at infinity, also one at its own height. Behind the eye (below 0) only where the eye
// is above the ceiling or below the floor it looks at.
void FlatPainter::prepare_more_rows(const Scene& scene, int top, int bottom) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double* const depths_per_metre = scene.screen.row_depths.data();
    for (int row = top; row < bottom; ++row) {
        const double depth = height_ * depths_per_metre[row];
        row_depths_[row] = std::fabs(depths_per_metre[row]) == kInfinity ? depths_per_metre[row]
                           : depth > 0                                   ? depth
                                                                         : 0;
    }
    shade_rows(top, bottom, &row_depths_[static_cast<std::size_t>(top)]);
}

/// depths: [bottom - top].
void FlatPainter::shade_rows(int top, int bottom, const double* depths) {
    dimming_.at_all(depths, bottom - top, &row_shades_[static_cast<std::size_t>(top)]);
    for (int row = top; row < bottom; ++row) row_darkness_[row] = darkness_of(color_table_, row_shades_[row]);
    if (is_there(fog_))
        for (int row = top; row < bottom; ++row) row_mists_[row] = mist_at(fog_.reach, depths[row - top]);
}

/// A flat seen from its wrong side (past a step that is not drawn, or by an eye outside the room's heights) never comes
/// nearer than the wall it is stretched to: its rows are lit as far away as they are drawn, column by column.
void FlatPainter::shade_extended_rows(int top, int bottom, double wall_depth) {
    for (int y = top; y < bottom; ++y) {
        const double depth = std::min(row_depths_[y], wall_depth);
        shade_rows(y, y + 1, &depth);
    }
}

}  // namespace enfilade::column
