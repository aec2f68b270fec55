// What becomes of a run of pixels once its picture is drawn: the light of lamps, fog, and laying it over what was there
// before. A surface goes through those it needs, one after the other; what it does without costs nothing.
//
// The scalar passes say what is drawn; those for AVX2 draw the same bits, eight pixels at a time.
#pragma once
#include "render/column/kernels.h"
#include "render/light_grid.h"

namespace enfilade::column {

/// Pixels that lamps light.
struct LitRun {
    Run run;
    /// As painted, where a color table has darkened the run's pixels already: what lamps add comes on top of them
    /// (lit_above()) [count]. Null: the pixels are as painted, and are darkened, too (lit()).
    const std::uint32_t* texels = nullptr;
};

/// Points of light side by side. Lanes as in LightCell: red and blue in one word, green in the other.
struct LightRow {
    std::uint32_t* red_blue;  ///< [count], and kCellsBeyond more on either side that may be read
    std::uint32_t* green;
    int count;  ///< >= 2
};
inline constexpr int kCellsBeyond = 8;

/// The light of lamps down one column of a wall.
struct WallLamplight {
    Shade shade;  ///< without lamps
    LightRow cells;
    std::uint64_t at_row_0;  ///< position among them, in 2^-32 of a cell; beyond them counts as at their ends
    std::uint64_t per_row;   ///< downwards: 0, or as a number with a sign below it
};

/// The light of lamps on a floor or ceiling along one column: position in the grid = base + depth(row) * step.
struct FlatLamplight {
    const LightGrid* grid;
    double base_u, base_v;     ///< under the eye [cells]
    double step_u, step_v;     ///< per metre of depth along this column's ray [cells/m]
    double farthest;           ///< depths are cut off here: where the wall behind the flat stands [m]
    const double* row_depths;  ///< by row, and kRowsBeyond more that may be read [m]
    const Shade* row_shades;   ///< without lamps, by row; and as many more
};

struct LampPasses {
    /// between() two columns of a grid, `part` of 256 of the way from a to b: to.count points.
    void (*mix_cells)(const LightCell* a, const LightCell* b, std::uint32_t part, const LightRow& to);
    void (*light_wall)(const LitRun& lit, const WallLamplight& lamplight);
    void (*light_flat)(const LitRun& lit, const FlatLamplight& lamplight);
};

struct Passes {
    LampPasses lamps;
    /// Fog of a colour. fog_parts: of each pixel, and kRowsBeyond more that may be read.
    void (*add_fog)(const Run& run, std::uint32_t fog, const FogPart* fog_parts);
    /// above: laid_over() the run's pixels [count].
    void (*blend)(const Run& run, const std::uint32_t* above);
};

/// The definition, pixel by pixel.
const Passes& scalar_passes();
/// Eight pixels at a time, with AVX2; nothing where the processor cannot.
std::optional<Passes> eight_wide_passes();

/// Those that go with these kernels.
Passes passes_beside(const PlainKernels& kernels);

}  // namespace enfilade::column
