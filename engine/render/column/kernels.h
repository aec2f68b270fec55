// The inner loops of surfaces with fog, lamps or holes, and of clouds: each fills a run of one screen column. Chosen
// once per surface; what a surface does not use is not in its loop (for most that is plain_kernels.h). Positions within
// a picture are whole numbers (2^64 or 2^32 steps a tile), so stepping them is exact and a run's pixels do not depend
// on where it starts.
#pragma once
#include <cstdint>

#include "map/textures.h"
#include "render/column/plain_kernels.h"
#include "render/light_grid.h"
#include "render/shade.h"

namespace enfilade::column {

/// A texture column of a wall under one light.
struct WallRun {
    const std::uint32_t* texels;  ///< texture column [height]
    std::uint32_t height;
    TileSteps v_at_row_0;
    TileSteps v_per_row;
    Shade shade;
    Mist mist = 0;                            ///< 0: no fog
    std::uint32_t fog = 0;                    ///< its colour
    const std::uint8_t* numbers = nullptr;    ///< of the texels' colours; null: they are darkened in proportion
    const std::uint32_t* darkened = nullptr;  ///< by number, in this shade
};
void fill_wall(const Run& run, const WallRun& wall);
/// The same for texels that have numbers.
void fill_wall_by_table(const Run& run, const WallRun& wall);

/// Point lights down one column of a wall.
struct WallGlow {
    const LightCell* cells;
    int count;               ///< of cells, >= 2
    std::uint64_t at_row_0;  ///< position among them, in 2^-32 of a cell; wraps
    std::uint64_t per_row;
};
void fill_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow);

/// The same for a picture with holes, laid over what is there already.
void lay_lit_wall(const Run& run, const WallRun& wall, const WallGlow& glow);
void lay_wall(const Run& run, const WallRun& wall);

/// A floor or ceiling along one column: tile position = base + depth(row) * step.
struct FlatRun {
    const Texture* texture;
    double base_u, base_v;                    ///< under the eye, in [0, 1) [tiles]
    double step_u, step_v;                    ///< per metre of depth along this column's ray [tiles/m]
    double farthest;                          ///< depths are cut off here: where the wall behind the flat stands [m]
    const double* row_depths;                 ///< by row [m]
    const Shade* row_shades;                  ///< by row
    const Mist* row_mists = nullptr;          ///< by row; null: no fog
    std::uint32_t fog = 0;                    ///< its colour
    const ColorTable* color_table = nullptr;  ///< that the texture goes by; null: it is darkened in proportion
};
void fill_flat(const Run& run, const FlatRun& flat);
/// The same for a texture that goes by a color table.
void fill_flat_by_table(const Run& run, const FlatRun& flat);

/// Point lights on a floor or ceiling along one column: position in the grid = base + depth(row) * step.
struct FlatGlow {
    const LightGrid* grid;
    double base_u, base_v;  ///< under the eye [cells]
    double step_u, step_v;  ///< per metre of depth along this column's ray [cells/m]
};
void fill_lit_flat(const Run& run, const FlatRun& flat, const FlatGlow& glow);

/// A layer of sky with holes, laid over what is there already.
void lay_sky(const Run& run, const SkyRun& layer);

void fill_color(const Run& run, std::uint32_t color);

}  // namespace enfilade::column
