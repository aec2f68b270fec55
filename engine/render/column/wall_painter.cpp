#include "render/column/painters.h"

#include <algorithm>
#include <cmath>

#include "render/column/kernels.h"
#include "render/column/scene.h"
#include "render/column/texel_dials.h"
#include "render/sprite.h"

namespace enfilade::column {
namespace {

ColumnRuns column_of(const ColumnRuns& runs, int i) {
    return {runs.pixels + i * runs.pitch, runs.pitch, 1, runs.tops + i, runs.bottoms + i};
}

// Two ways to sample: which texels columns show, in their light and as painted.

struct NearestTexels {
    const PlainKernels& kernels;

    void fill(const PlainWalls& walls) const { kernels.fill_walls(walls); }
    void read(const PlainWalls& walls, int) const { kernels.read_walls(walls); }
};

struct BlendedTexels {
    const WallBlend& blend;

    void fill(const PlainWalls& walls) const { fill_blended_walls(walls, blend); }
    /// From the i-th column on.
    void read(PlainWalls walls, int i) const {
        Shade all_bright[WallLooks::kMost];
        std::fill_n(all_bright, walls.runs.count, kFullBright);
        walls.color_table = nullptr;
        walls.shades = all_bright;
        fill_blended_walls(walls, {blend.u + i, blend.smaller, blend.parts + i});
    }
};

TileSteps steps_of(double tiles) { return std::fabs(tiles) <= kNearTiles ? near_tile_steps(tiles) : tile_steps(tiles); }

}  // namespace

void WallPainter::start(const ColumnScene& scene, const Wall& wall, const Surface& surface, double peg, double light,
                        PixelSurface id) {
    hang(scene, surface, wall.length, peg);
    id_ = id;
    shade_by(scene, lighting_in(scene.map, wall.sector, light, wall.contrast));
}

void WallPainter::start_panel(const ColumnScene& scene, const Panel& panel, double top, double light, PixelSurface id) {
    hang(scene, picture_now(scene.snapshot, panel), panel.length, top);
    id_ = id;
    shade_by(scene, lighting_in(scene.map, panel.sector, light, panel.contrast));
}

/// length: of the wall [m].
void WallPainter::hang(const ColumnScene& scene, const Surface& surface, double length, double peg) {
    texture_ = &scene.textures[surface.texture];
    light_grid_ = nullptr;
    is_once_ = false;
    u_per_along_ = length / surface.tile_m.x;
    u_offset_ = surface.offset_tiles.x;
    v_per_m_ = 1 / surface.tile_m.y;
    v_at_peg_ = peg * v_per_m_ - surface.offset_tiles.y;
}

void WallPainter::start_picture(const ColumnScene& scene, const Texture& texture, double top, double height,
                                const Lighting& lighting, PixelSurface id) {
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
WallLamplight WallPainter::lamplight_at(const ColumnScene& scene, int top, int bottom, Shade shade,
                                        const WallHit& hit) const {
    constexpr double kWrap = 0x1p-32;  // cells are counted modulo 2^32
    const LightGrid& grid = *light_grid_;
    const double cells_per_row = -hit.depth / scene.screen.focal_y * grid.per_m;
    const double at_row_0 = (eye_z_ - grid.v) * grid.per_m - (scene.screen.horizon - 0.5) * cells_per_row;
    const int last = grid_step(at_row_0 + top * cells_per_row, grid.rows).cell + 1;
    const int first = grid_step(at_row_0 + (bottom - 1) * cells_per_row, grid.rows).cell;
    const GridStep across = grid_step(across_at(hit), grid.columns);
    const LightCell* const left =
        &grid.cells[static_cast<std::size_t>(across.cell) * static_cast<std::size_t>(grid.rows)] + first;
    const LightRow cells = scene.scratch.cells(last - first + 1);
    scene.passes.lamps.mix_cells(left, left + grid.rows, across.part, cells);
    return {shade, cells, tile_steps((at_row_0 - first) * kWrap), tile_steps(cells_per_row * kWrap)};
}

/// Where a look meets the light's grid [points from its first column].
double WallPainter::across_at(const WallHit& hit) const {
    return (hit.along * length_ - light_grid_->u) * light_grid_->per_m;
}

/// Whether no lamp reaches the column.
bool WallPainter::is_dark_at(const WallHit& hit) const {
    const double across = across_at(hit);
    return (light_grid_->is_dark_before_u && across <= 0) ||
           (light_grid_->is_dark_after_u && across >= light_grid_->columns - 1);
}

void WallPainter::shade_by(const ColumnScene& scene, const Lighting& lighting) {
    color_table_ = texture_->numbers.empty() ? nullptr : &scene.textures.color_table;
    dimming_ = dimming_of(lighting);
    fog_ = fog_of(scene.map);
}

WallPainter::ColumnTexels WallPainter::texels_at(const ColumnScene& scene, const WallHit& hit) const {
    const double v_per_row = hit.depth / scene.screen.focal_y * v_per_m_;
    return {hit.along * u_per_along_ - u_offset_, v_at_peg_ - (scene.screen.horizon - 0.5) * v_per_row, v_per_row};
}

void WallPainter::paint(const ColumnScene& scene, const WallLooks& looks, const int* tops, const int* bottoms) const {
    if (scene.dials && may_any_be_alike(scene, looks)) return paint_by_dials(scene, looks, tops, bottoms);
    int first = 0, end = looks.count;
    while (first < end && tops[first] >= bottoms[first]) ++first;
    while (first < end && tops[end - 1] >= bottoms[end - 1]) --end;
    if (first == end) return;
    Placed placed;
    placed.texture = texture_;
    place(scene, looks, first, end, placed);
    const ColumnRuns runs{scene.canvas.column(looks.begin + first), scene.canvas.pitch(), end - first, tops + first,
                          bottoms + first};
    fill(scene, runs, placed, looks.depth + first, looks.along + first);
    if (is_there(fog_))
        for (int i = first; i < end; ++i)
            add_fog(scene, scene.canvas.run(looks.begin + i, tops[i], std::max(tops[i], bottoms[i])), looks.depth[i]);
    if (scene.facts == nullptr) return;
    for (int i = first; i < end; ++i)
        note_column(scene, looks.begin + i, {tops[i], bottoms[i]}, looks.depth[i], texels_at(scene, looks.at(i)));
}

/// Whether no position on the picture is farther than kNearTiles, at depths up to `farthest`.
bool WallPainter::is_near(const ColumnScene& scene, double farthest) const {
    const double most_per_row = farthest / scene.screen.focal_y * v_per_m_;
    return std::fabs(v_at_peg_) + (std::fabs(scene.screen.horizon) + 1) * most_per_row < kNearTiles &&
           u_per_along_ + std::fabs(u_offset_) < kNearTiles;
}

/// The columns from `first` to `end`.
void WallPainter::place(const ColumnScene& scene, const WallLooks& looks, int first, int end, Placed& placed) const {
    if (is_near(scene, looks.farthest))
        place_near(scene, looks.depth + first, looks.along + first, end - first, placed);
    else
        for (int i = first; i < end; ++i) place_one(texels_at(scene, looks.at(i)), looks.depth[i], placed, i - first);
}

/// As place_one(), of columns that are near.
void WallPainter::place_near(const ColumnScene& scene, const double* depths, const double* along, int count,
                             Placed& placed) const {
    const double rows_to_horizon = scene.screen.horizon - 0.5, focal_y = scene.screen.focal_y;
    for (int i = 0; i < count; ++i) {
        const double per_row = depths[i] / focal_y * v_per_m_;
        placed.v_per_row[i] = near_tile_steps(per_row);
        placed.v_at_row_0[i] = near_tile_steps(v_at_peg_ - rows_to_horizon * per_row);
        placed.first_texels[i] =
            texel_of(place_on_near_tile(along[i] * u_per_along_ - u_offset_), texture_->width) * texture_->height;
    }
    dimming_.at_all(depths, count, placed.shades);
}

void WallPainter::place_one(const ColumnTexels& at, double depth, Placed& placed, int i) const {
    placed.v_per_row[i] = steps_of(at.v_per_row);
    placed.v_at_row_0[i] = steps_of(at.v_at_row_0);
    placed.first_texels[i] = texel_of(place_on_tile(at.u), placed.texture->width) * placed.texture->height;
    placed.shades[i] = dimming_.at(depth);
}

/// runs: of the columns from the i-th on.
PlainWalls WallPainter::walls_at(const ColumnRuns& runs, const Placed& placed, int i) const {
    return {runs,
            placed.texture,
            placed.first_texels + i,
            placed.v_at_row_0 + i,
            placed.v_per_row + i,
            placed.shades + i,
            color_table_};
}

/// As placed; depths, along: of the columns.
void WallPainter::fill(const ColumnScene& scene, const ColumnRuns& runs, Placed& placed, const double* depths,
                       const double* along) const {
    if (built_in::kPointLights && light_grid_)
        fill_lit(scene, NearestTexels{scene.kernels}, runs, placed, depths, along);
    else
        scene.kernels.fill_walls(walls_at(runs, placed, 0));
}

/// The same with texels that are blended.
void WallPainter::fill_blended(const ColumnScene& scene, const WallBlend& blend, const ColumnRuns& runs, Placed& placed,
                               const double* depths, const double* along) const {
    if (built_in::kPointLights && light_grid_)
        fill_lit(scene, BlendedTexels{blend}, runs, placed, depths, along);
    else
        fill_blended_walls(walls_at(runs, placed, 0), blend);
}

// Out of line, so that walls without lamps do not save registers for it.
template <class Texels>
[[gnu::noinline]] void WallPainter::fill_lit(const ColumnScene& scene, const Texels& texels, const ColumnRuns& runs,
                                             Placed& placed, const double* depths, const double* along) const {
    bool is_lit[WallLooks::kMost];
    int lit_columns = 0, seen_columns = 0;
    for (int i = 0; i < runs.count; ++i) {
        const bool is_seen = runs.tops[i] < runs.bottoms[i];
        is_lit[i] = is_seen && !is_dark_at({depths[i], along[i]});
        seen_columns += is_seen;
        lit_columns += is_lit[i];
    }
    const bool is_painted_first = lit_columns == seen_columns && !color_table_;
    if (is_painted_first)
        texels.read(walls_at(runs, placed, 0), 0);
    else
        texels.fill(walls_at(runs, placed, 0));
    for (int i = 0; i < runs.count; ++i) {
        if (!is_lit[i]) continue;
        const int top = runs.tops[i], bottom = runs.bottoms[i];
        LitRun lit{{runs.pixels + i * runs.pitch + top, top, bottom - top}};
        if (!is_painted_first) {
            PlainWalls wall = walls_at(column_of(runs, i), placed, i);
            if (color_table_) {
                wall.runs.pixels = scene.scratch.texels.data();
                lit.texels = wall.runs.pixels + top;
            }
            texels.read(wall, i);
        }
        scene.passes.lamps.light_wall(lit, lamplight_at(scene, top, bottom, placed.shades[i], {depths[i], along[i]}));
    }
}

void WallPainter::add_fog(const ColumnScene& scene, const Run& run, double depth) const {
    std::fill_n(scene.scratch.fog_parts.begin(), run.count, fog_part_at(fog_.reach, depth, fog_.step));
    scene.passes.add_fog(run, fog_.color, scene.scratch.fog_parts.data());
}

/// at: as it is drawn.
void WallPainter::note_column(const ColumnScene& scene, int x, OpenRows rows, double depth,
                              const ColumnTexels& at) const {
    for (int y = rows.top; y < rows.bottom; ++y) note(scene, x, y, id_, depth, at.u, at.v_at_row_0 + y * at.v_per_row);
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
