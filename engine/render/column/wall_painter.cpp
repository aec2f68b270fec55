#include "render/column/wall_painter.h"

#include <algorithm>
#include <cmath>

#include "render/column/fog.h"
#include "render/picture_now.h"

namespace enfilade::column {
void WallPainter::start(const Scene& scene, const Wall& wall, const Surface& surface, double peg, double light,
                        SurfaceId id) {
    hang(scene, surface, wall.length, peg);
    id_ = id;
    shade_by(scene, lighting_in(scene.map, wall.sector, light, wall.contrast));
}

void WallPainter::start_panel(const Scene& scene, const Panel& panel, double top, double light, SurfaceId id) {
    hang(scene, picture_now(scene.snapshot, panel), panel.length, top);
    id_ = id;
    shade_by(scene, lighting_in(scene.map, panel.sector, light, panel.contrast));
}

/// length: of the wall [m].
void WallPainter::hang(const Scene& scene, const Surface& surface, double length, double peg) {
    texture_ = &scene.textures[surface.texture];
    light_grid_ = nullptr;
    is_once_ = false;
    u_per_along_ = length / surface.tile_m.x;
    u_offset_ = surface.offset_tiles.x;
    v_per_m_ = 1 / surface.tile_m.y;
    v_at_peg_ = peg * v_per_m_ - surface.offset_tiles.y;
}

void WallPainter::start_picture(const Scene& scene, const Texture& texture, double top, double height,
                                const Lighting& lighting, SurfaceId id) {
    texture_ = &texture;
    light_grid_ = nullptr;
    is_once_ = true;
    id_ = id;
    shade_by(scene, lighting);
    u_per_along_ = 1;
    u_offset_ = 0;
    v_per_m_ = 1 / height;
    v_at_peg_ = top * v_per_m_;
}

void WallPainter::light_up(const LightGrid* grid, double length, double eye_z) {
    light_grid_ = grid;
    length_ = length;
    eye_z_ = eye_z;
}

/// The light down a column: of each row of the grid that the rows from top to bottom come near.
WallGlow WallPainter::glow_at(const Scene& scene, int top, int bottom, const WallHit& hit) const {
    constexpr double kWrap = 0x1p-32;  // cells are counted modulo 2^32
    const LightGrid& grid = *light_grid_;
    const double cells_per_row = -hit.depth / scene.screen.focal_y / kLightCell;
    const double at_row_0 = (eye_z_ - grid.v) / kLightCell - (scene.screen.horizon - 0.5) * cells_per_row;
    const int last = grid_step(at_row_0 + top * cells_per_row, grid.rows).cell + 1;
    const int first = grid_step(at_row_0 + (bottom - 1) * cells_per_row, grid.rows).cell;
    const GridStep across = grid_step((hit.along * length_ - grid.u) / kLightCell, grid.columns);
    const LightCell* left = &grid.cells[static_cast<std::size_t>(across.cell) * static_cast<std::size_t>(grid.rows)];
    scene.glow.clear();
    for (int row = first; row <= last; ++row)
        scene.glow.push_back(between(left[row], left[grid.rows + row], across.part));
    return {scene.glow.data(), last - first + 1, tile_steps((at_row_0 - first) * kWrap),
            tile_steps(cells_per_row * kWrap)};
}

void WallPainter::shade_by(const Scene& scene, const Lighting& lighting) {
    color_table_ = texture_->numbers.empty() ? nullptr : &scene.textures.color_table;
    dimming_ = dimming_of(lighting);
    fog_ = fog_of(scene.map);
}

WallPainter::ColumnTexels WallPainter::texels_at(const Scene& scene, const WallHit& hit) const {
    const double v_per_row = hit.depth / scene.screen.focal_y * v_per_m_;
    return {hit.along * u_per_along_ - u_offset_, v_at_peg_ - (scene.screen.horizon - 0.5) * v_per_row, v_per_row};
}

// Inlined by order: whether it is must not depend on what else is in it.
[[gnu::always_inline]] inline WallRun WallPainter::run_of(const ColumnTexels& at, const WallHit& hit) const {
    const std::size_t first = std::size_t{texel_of(place_on_tile(at.u), texture_->width)} * texture_->height;
    WallRun run{&texture_->pixels[first], texture_->height, tile_steps(at.v_at_row_0), tile_steps(at.v_per_row),
                dimming_.at(hit.depth)};
    if (is_there(fog_)) {
        run.mist = mist_at(fog_.reach, hit.depth);
        run.fog = fog_.color;
    }
    return run;
}

WallRun WallPainter::looked_up(WallRun run) const {
    if (!color_table_) return run;
    run.numbers = &texture_->numbers[static_cast<std::size_t>(run.texels - texture_->pixels.data())];
    run.darkened = darkened_colors(*color_table_, run.shade);
    return run;
}

// Out of line, so that walls without point lights and color tables do not save registers for them.
[[gnu::noinline]] void WallPainter::fill_rich(const Scene& scene, const Run& run, const ColumnTexels& at,
                                              const WallHit& hit) const {
    const WallRun wall = looked_up(run_of(at, hit));
    if (built_in::kPointLights && light_grid_)
        fill_lit_wall(run, wall, glow_at(scene, run.first_row, run.first_row + run.count, hit));
    else
        fill_wall_by_table(run, wall);
}

void WallPainter::paint(const Scene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const {
    int first = 0, end = looks.count;
    while (first < end && tops[first] >= bottoms[first]) ++first;
    while (first < end && tops[end - 1] >= bottoms[end - 1]) --end;
    if (first == end) return;
    const bool is_plain = !(built_in::kPointLights && light_grid_) && !is_there(fog_) && is_near(scene, looks.farthest);
    if (is_plain)
        paint_plain(scene, looks, first, end, tops, bottoms);
    else
        for (int i = first; i < end; ++i) paint_column(scene, looks.begin + i, tops[i], bottoms[i], looks.at(i));
    if (scene.facts == nullptr) return;
    for (int i = first; i < end; ++i) note_column(scene, looks.begin + i, tops[i], bottoms[i], looks.at(i));
}

/// Whether no position on the picture is farther than kNearTiles, at depths up to `farthest`.
bool WallPainter::is_near(const Scene& scene, double farthest) const {
    const double most_per_row = farthest / scene.screen.focal_y * v_per_m_;
    return std::fabs(v_at_peg_) + (std::fabs(scene.screen.horizon) + 1) * most_per_row < kNearTiles &&
           u_per_along_ + std::fabs(u_offset_) < kNearTiles;
}

/// Columns `first` to `end` of those that look, as paint_column() would.
void WallPainter::paint_plain(const Scene& scene, const WallLooks& looks, int first, int end, const int* tops,
                              const int* bottoms) const {
    std::uint32_t first_texels[WallLooks::kMost];
    TileSteps v_at_row_0[WallLooks::kMost], v_per_row[WallLooks::kMost];
    Shade shades[WallLooks::kMost];
    const int count = end - first;
    const double* const depths = looks.depth + first;
    const double* const along = looks.along + first;
    const double rows_to_horizon = scene.screen.horizon - 0.5, focal_y = scene.screen.focal_y;
    for (int i = 0; i < count; ++i) {
        const double per_row = depths[i] / focal_y * v_per_m_;
        v_per_row[i] = near_tile_steps(per_row);
        v_at_row_0[i] = near_tile_steps(v_at_peg_ - rows_to_horizon * per_row);
        first_texels[i] =
            texel_of(place_on_near_tile(along[i] * u_per_along_ - u_offset_), texture_->width) * texture_->height;
    }
    dimming_.at_all(depths, count, shades);
    const ColumnRuns runs{scene.canvas.column(looks.begin + first), scene.canvas.pitch(), count, tops + first,
                          bottoms + first};
    scene.kernels.fill_walls({runs, texture_, first_texels, v_at_row_0, v_per_row, shades, color_table_});
}

void WallPainter::paint_column(const Scene& scene, int x, int top, int bottom, const WallHit& hit) const {
    if (top >= bottom) return;
    const ColumnTexels at = texels_at(scene, hit);
    const Run run = scene.canvas.run(x, top, bottom);
    if ((built_in::kPointLights && light_grid_) || color_table_)
        fill_rich(scene, run, at, hit);
    else
        fill_wall(run, run_of(at, hit));
}

void WallPainter::note_column(const Scene& scene, int x, int top, int bottom, const WallHit& hit) const {
    const ColumnTexels at = texels_at(scene, hit);
    for (int y = top; y < bottom; ++y) note(scene, x, y, id_, hit.depth, at.u, at.v_at_row_0 + y * at.v_per_row);
}

void WallPainter::lay_over(const Scene& scene, int x, int top, int bottom, const WallHit& hit) const {
    if (top >= bottom) return;
    const ColumnTexels at = texels_at(scene, hit);
    const int end = is_once_ ? end_of_picture(at, top, bottom) : bottom;
    lay_rows(scene, x, {top, end}, at, hit);
    lay_rows(scene, x, {end, bottom}, {at.u, kLastPlace, 0}, hit);
}

/// The first row that is rounded to the picture's very end, where it would begin again; `bottom` if there is none.
int WallPainter::end_of_picture(const ColumnTexels& at, int top, int bottom) const {
    int end = bottom;
    while (end > top && nearest_steps(at.v_at_row_0 + (end - 1) * at.v_per_row) >= nearest_steps(1)) --end;
    return end;
}

void WallPainter::lay_rows(const Scene& scene, int x, OpenRows rows, const ColumnTexels& at, const WallHit& hit) const {
    if (rows.is_closed()) return;
    const WallRun run = looked_up(run_of(at, hit));
    if (built_in::kPointLights && light_grid_)
        lay_lit_wall(scene.canvas.run(x, rows.top, rows.bottom), run, glow_at(scene, rows.top, rows.bottom, hit));
    else
        lay_wall(scene.canvas.run(x, rows.top, rows.bottom), run);
    if (scene.facts == nullptr) return;
    for (int y = rows.top; y < rows.bottom; ++y) {
        const double v = at.v_at_row_0 + y * at.v_per_row;
        const std::uint32_t texel = run.texels[texel_of(place_on_tile(v), run.height)];
        if (texel >> 24 >= kSolidAlpha) note_over(scene, x, y, id_, hit.depth, at.u, v);
    }
}

double peg_height(Peg peg, const RelativeHeights& here, const RelativeHeights* behind) {
    switch (peg) {
        case Peg::ceiling: return here.ceiling;
        case Peg::floor: return here.floor;
        case Peg::opening_top: return behind ? std::min(here.ceiling, behind->ceiling) : here.ceiling;
        case Peg::opening_bottom: return behind ? std::max(here.floor, behind->floor) : here.floor;
    }
    return here.ceiling;
}

}  // namespace enfilade::column
