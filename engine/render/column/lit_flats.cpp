// Floors and ceilings in the light of lamps: their texels are drawn as they are painted, then lit.
#include <algorithm>

#include "render/column/kernels.h"
#include "render/column/painters.h"
#include "render/column/scene.h"

namespace enfilade::column {
namespace {

/// Of which it holds: of the first rows, or the last, or all, or none.
template <class Holds>
OpenRows rows_where(OpenRows rows, const Holds& holds) {
    if (rows.is_closed()) return rows;
    const bool of_first = holds(rows.top), of_last = holds(rows.bottom - 1);
    if (of_first && of_last) return rows;
    if (!of_first && !of_last) return {rows.top, rows.top};
    int from = rows.top, to = rows.bottom - 1;  // it holds of one of them
    while (to - from > 1) {
        const int middle = from + (to - from) / 2;
        (holds(middle) == of_first ? from : to) = middle;
    }
    return of_first ? OpenRows{rows.top, to} : OpenRows{to, rows.bottom};
}

}  // namespace

/// Draws the rows that no lamp reaches, above and below those that some may, then these.
void FlatPainter::paint_plainly_lit(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                                    const int* bottoms) {
    const OpenRows any = rows_of_any(scene, looks, tops, bottoms);
    if (any.is_closed()) return;
    prepare_rows(scene, any.top, any.bottom);
    FlatSteps steps;
    find_steps(scene, looks, steps);
    FlatLamplight lamplights[WallLooks::kMost];
    int lit_tops[WallLooks::kMost], lit_bottoms[WallLooks::kMost];
    bool is_any_dark = false;
    for (int i = 0; i < looks.count; ++i) {
        const OpenRows open{tops[i], bottoms[i]};
        lamplights[i] = lamplight_at(column_at(scene, looks.begin + i, open, looks.depth[i]));
        const OpenRows lit = goes_one_way(open) ? lit_rows(lamplights[i], open) : OpenRows{open.top, open.top};
        lit_tops[i] = lit.top;
        lit_bottoms[i] = lit.bottom;
        is_any_dark |= lit.top != open.top || lit.bottom != open.bottom;
    }
    if (is_any_dark) {
        scene.kernels.fill_flats(flats_at(scene, looks, steps, tops, lit_tops));
        scene.kernels.fill_flats(flats_at(scene, looks, steps, lit_bottoms, bottoms));
    }
    scene.kernels.read_flats(flats_at(scene, looks, steps, lit_tops, lit_bottoms));
    for (int i = 0; i < looks.count; ++i) {
        const OpenRows open{tops[i], bottoms[i]};
        if (!goes_one_way(open))
            paint_lit(scene, picture_, column_at(scene, looks.begin + i, open, looks.depth[i]),
                      {scene.canvas.column(looks.begin + i), rows_->darkness()});
        else if (lit_tops[i] < lit_bottoms[i])
            scene.passes.lamps.light_flat({scene.canvas.run(looks.begin + i, lit_tops[i], lit_bottoms[i])},
                                          lamplights[i]);
        if (is_there(fog_) && !open.is_closed()) add_fog(scene, looks.begin + i, open);
    }
    note_plain(scene, looks, tops, bottoms);
}

/// Rows before and beyond the horizon are lit by themselves.
void FlatPainter::paint_lit(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                            const LevelTarget& to) const {
    if (goes_one_way(column.rows)) return paint_lit_one_way(scene, picture, column, to);
    const double* const depths = rows_->depths();
    FlatColumn part = column;
    for (int row = column.rows.top; row < column.rows.bottom; row = part.rows.bottom) {
        int end = row + 1;
        while (end < column.rows.bottom && (depths[end] > 0) == (depths[row] > 0)) ++end;
        part.rows = {row, end};
        paint_lit_one_way(scene, picture, part, to);
    }
}

/// Whether depths only grow or only shrink down the rows. Down a flat seen from its wrong side, or one so near the
/// eye's height that the tie rule gives it a row beyond the horizon, they grow up to the horizon's and are 0 beyond it,
/// or the other way round.
bool FlatPainter::goes_one_way(const OpenRows& rows) const {
    return rows.is_closed() || (rows_->depths()[rows.top] > 0 && rows_->depths()[rows.bottom - 1] > 0);
}

/// Rows that go one way.
void FlatPainter::paint_lit_one_way(const ColumnScene& scene, const LevelPicture& picture, const FlatColumn& column,
                                    const LevelTarget& to) const {
    const FlatLamplight lamplight = lamplight_at(column);
    FlatColumn above = column, lit = column, below = column;
    lit.rows = lit_rows(lamplight, column.rows);
    above.rows.bottom = lit.rows.top;
    below.rows.top = lit.rows.bottom;
    fill(scene, picture, above, to);
    fill(scene, picture, below, to);
    const auto [top, bottom] = lit.rows;
    LitRun run{{to.row_0 + top, top, bottom - top}};
    LevelPicture as_painted = picture;
    as_painted.color_table = nullptr;
    if (picture.color_table) {
        std::uint32_t* const texels = scene.scratch.texels.data();
        fill(scene, picture, lit, to);
        fill(scene, as_painted, lit, {texels, full_light_.data()});
        run.texels = texels + top;
    } else {
        fill(scene, as_painted, lit, {to.row_0, full_light_.data()});
    }
    scene.passes.lamps.light_flat(run, lamplight);
}

FlatLamplight FlatPainter::lamplight_at(const FlatColumn& column) const {
    const double per_m = lamplight_->per_m;
    return {lamplight_,
            (pose_->eye.x - lamplight_->u) * per_m + kGridShift,
            (pose_->eye.y - lamplight_->v) * per_m + kGridShift,
            column.ray.x * per_m,
            column.ray.y * per_m,
            column.farthest,
            rows_->depths(),
            rows_->shades()};
}

/// Which of the rows may be lit. Down the column places only go one way, so that beyond each edge of the light are its
/// first rows, or its last, or all.
OpenRows FlatPainter::lit_rows(const FlatLamplight& lamplight, const OpenRows& rows) const {
    const LightGrid& grid = *lamplight.grid;
    const auto depth = [&](int row) { return std::min(rows_->depths()[row], lamplight.farthest); };
    const auto u = [&](int row) { return lamplight.base_u + depth(row) * lamplight.step_u; };
    const auto v = [&](int row) { return lamplight.base_v + depth(row) * lamplight.step_v; };
    constexpr double kFirst = kGridShift;
    const double last_u = kGridShift + (grid.columns - 1), last_v = kGridShift + (grid.rows - 1);
    OpenRows lit = rows;
    if (grid.is_dark_before_u) lit = rows_where(lit, [&](int row) { return u(row) > kFirst; });
    if (grid.is_dark_after_u) lit = rows_where(lit, [&](int row) { return u(row) < last_u; });
    if (grid.is_dark_before_v) lit = rows_where(lit, [&](int row) { return v(row) > kFirst; });
    if (grid.is_dark_after_v) lit = rows_where(lit, [&](int row) { return v(row) < last_v; });
    return lit;
}

}  // namespace enfilade::column
