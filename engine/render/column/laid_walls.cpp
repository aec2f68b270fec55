// Pictures with holes: walls, panels and things, laid over what is drawn already.
#include <algorithm>

#include "render/column/kernels.h"
#include "render/column/painters.h"
#include "render/column/scene.h"

namespace enfilade::column {

void WallPainter::lay_over(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                           const int* bottoms) const {
    int ends[WallLooks::kMost];
    for (int i = 0; i < looks.count; ++i)
        ends[i] = is_once_ ? end_of_picture(texels_at(scene, looks.at(i)), tops[i], bottoms[i]) : bottoms[i];
    const bool is_lit = built_in::kPointLights && light_grid_;
    if (is_lit || is_there(fog_))
        for (int i = 0; i < looks.count; ++i)
            lay_column(scene, looks.begin + i, {tops[i], ends[i]}, texels_at(scene, looks.at(i)), looks.at(i));
    else
        lay_plain(scene, looks, tops, ends);
    for (int i = 0; i < looks.count; ++i)
        if (ends[i] < bottoms[i])
            lay_column(scene, looks.begin + i, {ends[i], bottoms[i]}, {texels_at(scene, looks.at(i)).u, kLastPlace, 0},
                       looks.at(i));
}

/// The first row that is rounded to the picture's very end, where it would begin again; `bottom` if there is none.
int WallPainter::end_of_picture(const ColumnTexels& at, int top, int bottom) const {
    int end = bottom;
    while (end > top && nearest_steps(at.v_at_row_0 + (end - 1) * at.v_per_row) >= nearest_steps(1)) --end;
    return end;
}

/// In one light, without fog.
void WallPainter::lay_plain(const ColumnScene& scene, const WallLooks& looks, const int* tops,
                            const int* bottoms) const {
    Placed placed;
    placed.texture = texture_;
    place(scene, looks, 0, looks.count, placed);
    const ColumnRuns runs{scene.canvas.column(looks.begin), scene.canvas.pitch(), looks.count, tops, bottoms};
    scene.kernels.lay_walls(walls_at(runs, placed, 0));
    if (scene.facts == nullptr) return;
    for (int i = 0; i < looks.count; ++i) {
        const ColumnRuns to_texels{scene.scratch.texels.data(), 0, 1, tops + i, bottoms + i};
        scene.kernels.read_walls(walls_at(to_texels, placed, i));
        note_laid(scene, looks.begin + i, {tops[i], bottoms[i]}, texels_at(scene, looks.at(i)), looks.depth[i]);
    }
}

/// In any light and fog.
void WallPainter::lay_column(const ColumnScene& scene, int x, OpenRows rows, const ColumnTexels& at,
                             const WallHit& hit) const {
    if (rows.is_closed()) return;
    Placed placed;
    placed.texture = texture_;
    place_one(at, hit.depth, placed, 0);
    std::vector<std::uint32_t>&texels = scene.scratch.texels, &colors = scene.scratch.colors;
    const ColumnRuns to_texels{texels.data(), 0, 1, &rows.top, &rows.bottom};
    if (scene.kernels.read_walls(walls_at(to_texels, placed, 0)) >> 24 == 0) return;
    const int top = rows.top, count = rows.bottom - rows.top;
    const Run run{colors.data() + top, top, count};
    if (built_in::kPointLights && light_grid_ && !color_table_ && !is_dark_at(hit)) {
        std::copy_n(texels.begin() + top, count, run.pixels);
        scene.passes.lamps.light_wall({run}, lamplight_at(scene, top, rows.bottom, placed.shades[0], hit));
    } else {
        const ColumnRuns to_colors{colors.data(), 0, 1, &rows.top, &rows.bottom};
        fill(scene, to_colors, placed, &hit.depth, &hit.along);
    }
    if (is_there(fog_)) add_fog(scene, run, hit.depth);
    scene.passes.blend(scene.canvas.run(x, top, rows.bottom), colors.data() + top, texels.data() + top);
    if (scene.facts) note_laid(scene, x, rows, at, hit.depth);
}

/// The rows of which scene.scratch has the texels.
void WallPainter::note_laid(const ColumnScene& scene, int x, OpenRows rows, const ColumnTexels& at,
                            double depth) const {
    for (int y = rows.top; y < rows.bottom; ++y)
        if (scene.scratch.texels[static_cast<std::size_t>(y)] >> 24 >= kSolidAlpha)
            note_over(scene, x, y, id_, depth, at.u, at.v_at_row_0 + y * at.v_per_row);
}

}  // namespace enfilade::column
