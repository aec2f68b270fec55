// Floors and ceilings drawn by the dials of texels.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/painters.h"
#include "render/column/texel_dials.h"

namespace enfilade::column {
namespace {

/// What a vector along a flat is in texels, along the longer side.
double texels_of(Vec2 metres, Vec2 tile_m, const Texture& picture) {
    return std::max(std::fabs(metres.x) / tile_m.x * picture.width, std::fabs(metres.y) / tile_m.y * picture.height);
}

}  // namespace

void FlatPainter::start_dials(const ColumnScene& scene) {
    vanilla_.reset();
    is_dialled_ = scene.dials != nullptr && !(built_in::kSky && flat_.sky);
    // Lamps, fog and layers make each column another one: a promise alone has nothing to give there.
    if (is_dialled_ && !is_plain_ && is_only_promise(scene.dials->dials)) is_dialled_ = false;
    if (!is_dialled_) return;
    const RayTables& screen = scene.screen;
    texels_across_ = texels_of(pose_->right, picture_.tile_m, *picture_.texture) / screen.column_scale;
    texels_down_ = texels_of(pose_->forward, picture_.tile_m, *picture_.texture) /
                   std::max(std::fabs(height_) * screen.focal_y, std::numeric_limits<double>::min());
    if (scene.dials->dials.number == NumberKind::vanilla && !is_extended_)
        vanilla_.emplace(VanillaScreen{screen.width, screen.column_scale},
                         height_ * picture_.texture->width / picture_.tile_m.x, pose_->forward, pose_->flip);
    const auto rows = static_cast<std::size_t>(screen.height);
    texel_depths_.resize(rows + kRowsBeyond);
    row_dials_.resize(rows);
    row_mip_parts_.resize(rows);
}

/// Whether exact texels are all that the dials leave to these rows, which are prepared: nearer ones are held longer.
bool FlatPainter::is_exact_in(const ColumnScene& scene, int top, int bottom) const {
    const int nearest = height_ < 0 ? bottom - 1 : top;
    return is_only_promise(scene.dials->dials) && row_dials_[static_cast<std::size_t>(nearest)].held == 1;
}

/// How a row at this depth is drawn: alike are columns whose first and last are no farther from their mean than is
/// promised.
FlatPainter::RowDials FlatPainter::dials_at(const ColumnScene& scene, double depth) const {
    RowDials row;
    if (is_extended_) return row;
    const double across = depth * texels_across_;
    const double most = most_apart(scene.dials->dials, std::max(picture_.texture->width, picture_.texture->height));
    while (row.held < kMostHeld && across * (2 * row.held - 1) <= most && most > 0) row.held *= 2;
    row.level = mip_at(scene, depth).level;
    return row;
}

/// By texels per pixel (render/sampling.h).
MipPlace FlatPainter::mip_at(const ColumnScene& scene, double depth) const {
    if (!scene.dials->mips || is_extended_) return {};
    const double most = std::max(depth * texels_across_, depth * depth * texels_down_);
    return scene.dials->dials.sampling == Sampling::mip ? MipPlace{mip_level(most), 0} : mip_place(most);
}

/// Between the rows of a span; those at its ends are exact, or the first and last that see the flat.
double FlatPainter::depth_in_span(const ColumnScene& scene, int row) const {
    const RayTables& screen = scene.screen;
    const int span = scene.dials->dials.span;
    const bool is_floor = height_ < 0;
    int first = row - row % span, last = std::min(first + span, screen.height - 1);
    while (is_floor && first < row && !(screen.row_rises[static_cast<std::size_t>(first)] < 0)) ++first;
    while (!is_floor && last > row && !(screen.row_rises[static_cast<std::size_t>(last)] > 0)) --last;
    return on_line(level_depth(screen, height_, first), level_depth(screen, height_, last), first, last, row);
}

void FlatPainter::prepare_dials(const ColumnScene& scene, OpenRows rows) {
    for (int row = rows.top; row < rows.bottom; ++row) {
        const auto i = static_cast<std::size_t>(row);
        const double depth = rows_->depths()[row];
        texel_depths_[i] = scene.dials->dials.span == 1 || is_extended_ ? depth : depth_in_span(scene, row);
        row_dials_[i] = dials_at(scene, depth);
        row_mip_parts_[i] = mip_at(scene, depth).part;
    }
}

/// The end of the rows from `row` on that are drawn as it is.
int FlatPainter::end_of_alike_rows(int row, int end) const {
    const RowDials dials = row_dials_[static_cast<std::size_t>(row)];
    while (row < end && row_dials_[static_cast<std::size_t>(row)] == dials) ++row;
    return row;
}

/// Of a column, or of the middle of those that it is drawn alike with [tiles/m].
Vec2 FlatPainter::steps_at(const ColumnScene& scene, int x, int held) const {
    const ColumnGroup columns = group_of(x, held, {0, scene.screen.width - 1});
    const std::vector<double>& slopes = scene.screen.slopes;
    const double slope =
        (slopes[static_cast<std::size_t>(columns.first)] + slopes[static_cast<std::size_t>(columns.last)]) / 2;
    const Vec2 ray = pose_->forward + pose_->right * slope;
    return {ray.x / picture_.tile_m.x, ray.y / picture_.tile_m.y};
}

/// A flat in one light without lamps, fog and layers.
void FlatPainter::paint_by_dials(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                                 const int* bottoms) const {
    const int top = *std::min_element(tops, tops + looks.count),
              end = *std::max_element(bottoms, bottoms + looks.count);
    int some_tops[WallLooks::kMost], some_bottoms[WallLooks::kMost];
    for (int row = std::max(top, rows_->known().top); row < std::min(end, rows_->known().bottom);) {
        const int next = end_of_alike_rows(row, end);
        for (int i = 0; i < looks.count; ++i) {
            some_tops[i] = std::max(tops[i], row);
            some_bottoms[i] = std::min(bottoms[i], next);
        }
        const ColumnRuns runs{scene.canvas.column(looks.begin), scene.canvas.pitch(), looks.count, some_tops,
                              some_bottoms};
        paint_alike(scene, looks, runs, row_dials_[static_cast<std::size_t>(row)]);
        row = next;
    }
}

/// Rows that have the same dials.
void FlatPainter::paint_alike(const ColumnScene& scene, const WallLooks& looks, const ColumnRuns& runs,
                              RowDials dials) const {
    double step_u[WallLooks::kMost], step_v[WallLooks::kMost];
    int like[WallLooks::kMost];
    for (int i = 0; i < looks.count; ++i) {
        const Vec2 step = steps_at(scene, looks.begin + i, dials.held);
        step_u[i] = step.x;
        step_v[i] = step.y;
        like[i] = std::max(group_of(looks.begin + i, dials.held, {0, scene.screen.width}).first - looks.begin, 0);
    }
    fill_alike(runs, like, [&](const ColumnRuns& some) {
        fill_texels(scene,
                    {some, picture_.texture, picture_.base_u, picture_.base_v, step_u, step_v, looks.depth,
                     texel_depths_.data(), rows_->darkness(), picture_.color_table},
                    {looks.begin, dials.level, true});
    });
}

/// flats: with the picture as painted.
void FlatPainter::fill_texels(const ColumnScene& scene, PlainFlats flats, const TexelSource& from) const {
    const Dials& dials = scene.dials->dials;
    const Texture& picture = *flats.texture;
    const MipChains* const mips = scene.dials->mips;
    const FlatBlend blend{mips ? &mips->at(picture, from.level + 1) : nullptr, row_mip_parts_.data()};
    const bool is_blended = is_blend(dials.sampling) && !picture.has_holes;
    if (from.level > 0) flats.texture = &mips->at(picture, from.level);
    const auto by_tables = [&](int i, int y) { return by_vanilla(scene, from.first_column + i, y); };
    if (vanilla_)
        is_blended ? fill_blended_flats_at(flats, blend, by_tables) : fill_flats_at(flats, by_tables);
    else if (is_blended)
        fill_blended_flats(dials.number, flats, blend);
    else if (dials.number == NumberKind::real32 || dials.number == NumberKind::fixed16)
        fill_flats_in(dials.number, flats);
    else
        from.is_near ? scene.kernels.fill_flats(flats) : fill_far_flats(flats);
}

/// One column of a flat that lamps, fog or layers have to do with: nothing is drawn alike.
void FlatPainter::fill_by_dials(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                                const LevelTarget& to) const {
    const double step_u = column.ray.x / picture.tile_m.x, step_v = column.ray.y / picture.tile_m.y;
    for (int row = column.rows.top; row < column.rows.bottom;) {
        const int next = end_of_alike_rows(row, column.rows.bottom);
        const int level = row_dials_[static_cast<std::size_t>(row)].level;
        const ColumnRuns runs{to.row_0, 0, 1, &row, &next};
        fill_texels(scene,
                    {runs, picture.texture, picture.base_u, picture.base_v, &step_u, &step_v, &column.farthest,
                     texel_depths_.data(), to.darkness, picture.color_table},
                    {column.x, level, column.farthest < picture.near_limit});
        row = next;
    }
}

TexelPosition FlatPainter::by_vanilla(const ColumnScene& scene, int x, int row) const {
    const double rows = std::fabs(scene.screen.row_rises[static_cast<std::size_t>(row)]);
    const Vec2 from_eye = vanilla_->at(x, rows, scene.screen.focal_y);  // both in texels along the width
    const double width = picture_.texture->width, height = picture_.texture->height;
    return {in_16_16(picture_.base_u * width) / width + from_eye.x / width,
            in_16_16(picture_.base_v * height) / height + from_eye.y / width * picture_.tile_m.x / picture_.tile_m.y};
}

/// Where a row of a column is on the picture, as it is drawn: like its neighbours, where that is promised to do.
TexelPosition FlatPainter::drawn_at(const ColumnScene& scene, const FlatColumn& column, int row, bool is_alike) const {
    const auto i = static_cast<std::size_t>(row);
    if (vanilla_) return by_vanilla(scene, column.x, row);
    const Vec2 step = steps_at(scene, column.x, is_dialled_ && is_alike ? row_dials_[i].held : 1);
    const double depth = std::min(is_dialled_ ? texel_depths_[i] : rows_->depths()[row], column.farthest);
    const NumberKind number = is_dialled_ ? scene.dials->dials.number : NumberKind::real64;
    return {flat_position(number, picture_.base_u, depth, step.x, picture_.texture->width),
            flat_position(number, picture_.base_v, depth, step.y, picture_.texture->height)};
}

}  // namespace enfilade::column
