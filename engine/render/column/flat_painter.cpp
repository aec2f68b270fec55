#include "render/column/painters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/sprite.h"

namespace enfilade::column {
namespace {

SkyRows rows_of_sky(const ColumnScene& scene) { return sky_rows(scene.map.render, false); }

/// What a ray climbs from one row to the next: where the sky's rows are straight, per metre of depth; else per metre
/// along the ground, which is longer by the length of `ray`.
double rise_per_row(const ColumnScene& scene, Vec2 ray) {
    if (rows_of_sky(scene) == SkyRows::straight) return 1 / scene.screen.focal_y;
    return 1 / (scene.screen.focal_y * std::sqrt(dot(ray, ray)));
}

std::size_t rows_in(const ColumnScene& scene) { return scene.screen.row_depths.size() + kRowsBeyond; }

/// The largest length of a ray's part along an axis, per metre of depth.
double longest_ray(const RayTables& screen) {
    return 1 + std::max(std::fabs(screen.slopes.front()), std::fabs(screen.slopes.back()));
}

}  // namespace

void FlatPainter::start(const ColumnScene& scene, const Pose& pose, const FlatNow& flat, FlatSide side, double height,
                        const Lighting& lighting, const LightGrid* lamplight, PixelSurface id) {
    pose_ = &pose;
    flat_ = flat;
    picture_ = picture_of(scene, flat.surface);
    id_ = id;
    height_ = height;
    lamplight_ = lamplight;
    fog_ = fog_of(scene.map);
    is_extended_ = side == FlatSide::floor ? height >= 0 : height <= 0;
    const bool has_layers = built_in::kFlatLayers && flat.layer_count > 0;
    is_plain_ = !(built_in::kSky && flat.sky) && !(built_in::kPointLights && lamplight) && !is_there(fog_) &&
                !is_extended_ && !has_layers;
    is_plainly_lit_ =
        built_in::kPointLights && lamplight && !flat.sky && !is_extended_ && !has_layers && !picture_.color_table;
    level_layers_.clear();
    sky_layers_.clear();
    if (has_layers) start_layers(scene);
    start_dials(scene);
    is_plainly_lit_ = is_plainly_lit_ && !is_dialled_;
    start_rows(scene, lighting);
}

void FlatPainter::start_rows(const ColumnScene& scene, const Lighting& lighting) {
    const FlatRowsKey key{height_, lighting, picture_.color_table, fog_};
    if (is_extended_ || is_dialled_) {
        rows_ = &own_rows_;
        rows_->start(key, scene.screen);
    } else {
        rows_ = &scene.scratch.flat_rows.of(key, scene.screen);
    }
    if (lamplight_) full_light_.resize(rows_in(scene), darkness_of(nullptr, kFullBright));
}

void FlatPainter::start_layers(const ColumnScene& scene) {
    layer_darkness_.resize(rows_in(scene));
    for (std::uint32_t i = 0; i < flat_.layer_count; ++i) {
        const Surface layer = layer_now(scene.map, scene.snapshot, flat_, i);
        if (built_in::kSky && flat_.sky)
            sky_layers_.push_back(layer);
        else {
            level_layers_.push_back(picture_of(scene, layer));
            level_layers_.back().is_exact = true;
        }
    }
}

FlatPainter::LevelPicture FlatPainter::picture_of(const ColumnScene& scene, const Surface& surface) const {
    const Texture& texture = scene.textures[surface.texture];
    const Vec2 from_origin = pose_->eye - flat_.origin, tile = surface.tile_m;
    return {&texture,
            texture.numbers.empty() ? nullptr : &scene.textures.color_table,
            tile,
            fraction(from_origin.x / tile.x - surface.offset_tiles.x),
            fraction(from_origin.y / tile.y - surface.offset_tiles.y),
            (kNearTiles - 1) * std::min(tile.x, tile.y) / longest_ray(scene.screen)};
}

void FlatPainter::paint(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) {
    if (is_plain_ && looks.farthest < picture_.near_limit) return paint_plain(scene, looks, tops, bottoms);
    if (is_plainly_lit_ && looks.farthest < picture_.near_limit) return paint_plainly_lit(scene, looks, tops, bottoms);
    for (int i = 0; i < looks.count; ++i) {
        if (tops[i] >= bottoms[i]) continue;
        if (built_in::kSky && flat_.sky)
            paint_sky(scene, looks.begin + i, tops[i], bottoms[i]);
        else
            paint_level(scene, column_at(scene, looks.begin + i, {tops[i], bottoms[i]}, looks.depth[i]));
    }
}

/// The rows that any of the columns has; closed where none has any.
OpenRows FlatPainter::rows_of_any(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                                  const int* bottoms) {
    OpenRows any{scene.screen.height, 0};
    for (int i = 0; i < looks.count; ++i) {
        const bool is_seen = tops[i] < bottoms[i];
        any.top = is_seen && tops[i] < any.top ? tops[i] : any.top;
        any.bottom = is_seen && bottoms[i] > any.bottom ? bottoms[i] : any.bottom;
    }
    return any;
}

void FlatPainter::find_steps(const ColumnScene& scene, const WallLooks& looks, FlatSteps& steps) const {
    const double* const slopes = &scene.screen.slopes[static_cast<std::size_t>(looks.begin)];
    const Vec2 forward = pose_->forward, right = pose_->right, tile = picture_.tile_m;
    for (int i = 0; i < looks.count; ++i) {
        steps.u[i] = (forward.x + right.x * slopes[i]) / tile.x;
        steps.v[i] = (forward.y + right.y * slopes[i]) / tile.y;
    }
}

PlainFlats FlatPainter::flats_at(const ColumnScene& scene, const WallLooks& looks, const FlatSteps& steps,
                                 const int* tops, const int* bottoms) const {
    const ColumnRuns runs{scene.canvas.column(looks.begin), scene.canvas.pitch(), looks.count, tops, bottoms};
    return {runs,    picture_.texture, picture_.base_u, picture_.base_v,   steps.u,
            steps.v, looks.depth,      rows_->depths(), rows_->darkness(), picture_.color_table};
}

void FlatPainter::paint_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) {
    const OpenRows any = rows_of_any(scene, looks, tops, bottoms);
    if (any.is_closed()) return;
    prepare_rows(scene, any.top, any.bottom);
    if (is_dialled_ && !is_exact_in(scene, any.top, any.bottom)) {
        paint_by_dials(scene, looks, tops, bottoms);
        return note_plain(scene, looks, tops, bottoms);
    }
    FlatSteps steps;
    find_steps(scene, looks, steps);
    scene.kernels.fill_flats(flats_at(scene, looks, steps, tops, bottoms));
    note_plain(scene, looks, tops, bottoms);
}

void FlatPainter::add_fog(const ColumnScene& scene, int x, OpenRows rows) const {
    scene.passes.add_fog(scene.canvas.run(x, rows.top, rows.bottom), fog_.color, rows_->fog_parts() + rows.top);
}

void FlatPainter::note_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                             const int* bottoms) const {
    if (scene.facts == nullptr) return;
    for (int i = 0; i < looks.count; ++i)
        note_level(scene, column_at(scene, looks.begin + i, {tops[i], bottoms[i]}, looks.depth[i]), true);
}

FlatPainter::FlatColumn FlatPainter::column_at(const ColumnScene& scene, int x, OpenRows rows,
                                               double wall_depth) const {
    return {x, pose_->forward + pose_->right * scene.screen.slopes[x], wall_depth, rows};
}

void FlatPainter::paint_level(const ColumnScene& scene, const FlatColumn& column) {
    const auto [top, bottom] = column.rows;
    prepare_rows(scene, top, bottom);
    if (is_extended_) shade_extended_rows(top, bottom, column.farthest);
    paint_picture(scene, picture_, column, {scene.canvas.column(column.x), rows_->darkness()});
    for (const LevelPicture& layer : level_layers_) lay_layer(scene, layer, column);
    if (is_there(fog_)) add_fog(scene, column.x, column.rows);
    if (scene.facts != nullptr) note_level(scene, column, false);
}

void FlatPainter::paint_picture(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                                const LevelTarget& to) const {
    if (built_in::kPointLights && lamplight_)
        paint_lit(scene, picture, column, to);
    else
        fill(scene, picture, column, to);
}

/// Calls draw(flats) with one column of a picture.
template <class Draw>
void FlatPainter::with_flats(const LevelPicture& picture, const FlatColumn& column, const LevelTarget& to,
                             Draw draw) const {
    const double step_u = column.ray.x / picture.tile_m.x, step_v = column.ray.y / picture.tile_m.y;
    const ColumnRuns runs{to.row_0, 0, 1, &column.rows.top, &column.rows.bottom};
    draw(PlainFlats{runs, picture.texture, picture.base_u, picture.base_v, &step_u, &step_v, &column.farthest,
                    rows_->depths(), to.darkness, picture.color_table});
}

void FlatPainter::fill(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                       const LevelTarget& to) const {
    if (is_dialled_ && !picture.is_exact) return fill_by_dials(scene, picture, column, to);
    with_flats(picture, column, to, column.farthest < picture.near_limit ? scene.kernels.fill_flats : fill_far_flats);
}

/// As it is painted, with its alpha.
void FlatPainter::read(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                       const LevelTarget& to) const {
    with_flats(picture, column, to, column.farthest < picture.near_limit ? scene.kernels.read_flats : read_far_flats);
}

/// In the light of the flat, over what is drawn already.
void FlatPainter::lay_layer(const ColumnScene& scene, const LevelPicture& layer, const FlatColumn& column) {
    std::vector<std::uint32_t>&texels = scene.scratch.texels, &colors = scene.scratch.colors;
    const auto [top, bottom] = column.rows;
    for (int row = top; row < bottom; ++row)
        layer_darkness_[row] = darkness_of(layer.color_table, rows_->shades()[row] & 0xFFFF);
    paint_picture(scene, layer, column, {colors.data(), layer_darkness_.data()});
    read(scene, layer, column, {texels.data(), nullptr});
    scene.passes.blend(scene.canvas.run(column.x, top, bottom), colors.data() + top, texels.data() + top);
}

void FlatPainter::note_level(const ColumnScene& scene, const FlatColumn& column, bool is_alike) const {
    for (int y = column.rows.top; y < column.rows.bottom; ++y) {
        const TexelPosition at = drawn_at(scene, column, y, is_alike);
        note(scene, column.x, y, id_, std::min(rows_->depths()[y], column.farthest), at.u, at.v);
    }
}

void FlatPainter::paint_sky(const ColumnScene& scene, int x, int top, int bottom) {
    const Vec2 ray = pose_->forward + pose_->right * scene.screen.slopes[x];
    const SkyColumn column{scene.scratch.turns.of(*pose_, x, ray), rise_per_row(scene, ray)};
    const Run run = scene.canvas.run(x, top, bottom);
    scene.kernels.fill_sky(run, sky_run(scene, flat_.surface, column));
    for (const Surface& layer : sky_layers_) lay_sky(run, sky_run(scene, layer, column));
    if (scene.facts == nullptr) return;
    for (int y = top; y < bottom; ++y) {
        const SkyTexel texel = sky_texel(flat_.surface.tile_m, flat_.surface.offset_tiles, column.turn,
                                         scene.screen.row_rises[y] * column.rise_per_row, rows_of_sky(scene));
        note(scene, x, y, id_, std::numeric_limits<double>::infinity(), texel.u, texel.v);
    }
}

SkyRun FlatPainter::sky_run(const ColumnScene& scene, const Surface& surface, const SkyColumn& column) const {
    const Texture& texture = scene.textures[surface.texture];
    const SkyTexel horizon = sky_texel(surface.tile_m, surface.offset_tiles, column.turn, 0, rows_of_sky(scene));
    const std::uint32_t texels = texel_of(place_on_tile(horizon.u), texture.width);
    return {&texture.pixels[std::size_t{texels} * texture.height],
            texture.height,
            1 - surface.offset_tiles.y,
            last_of_sky(rows_of_sky(scene)),
            -column.rise_per_row / surface.tile_m.y,
            scene.screen.row_rises.data()};
}

void FlatPainter::prepare_rows(const ColumnScene& scene, int top, int bottom) {
    OpenRows before = rows_->known();
    rows_->prepare(scene.screen, top, bottom);
    if (!is_dialled_) return;
    const OpenRows now = rows_->known();
    if (before.is_closed()) before = {now.bottom, now.bottom};
    prepare_dials(scene, {now.top, before.top});
    prepare_dials(scene, {before.bottom, now.bottom});
}

/// A flat seen from its wrong side (past a step that is not drawn, or by an eye outside the room's heights) never comes
/// nearer than the wall it is stretched to: its rows are lit as far away as they are drawn, column by column.
void FlatPainter::shade_extended_rows(int top, int bottom, double wall_depth) {
    for (int y = top; y < bottom; ++y) {
        const double depth = std::min(rows_->depths()[y], wall_depth);
        rows_->shade(y, y + 1, &depth);
    }
}

}  // namespace enfilade::column
