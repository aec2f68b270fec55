// The inner loops: runs of walls, flats and skies down columns.
// Positions within a picture are whole numbers (2^64 or 2^32 steps a tile), so stepping them is exact and a run's
// pixels do not depend on where it starts.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "map/textures.h"
#include "render/shade.h"

namespace enfilade::column {

// The inner loops that draw most pixels: skies, and walls and flats in one light, without fog or lamps; walls with
// holes, too. Those draw the runs of one surface down neighbouring columns at once, so that what the surface has in
// common is made ready once.
//
// The scalar kernels say what is drawn; those for SSE2 and AVX2 draw the same bits, four and eight pixels at a time.

/// Position within a tile as a fraction of 2^64.
using TileSteps = std::uint64_t;

/// The fraction of a tile as steps. Any finite number; wraps.
TileSteps tile_steps(double tiles);

/// The same to within two steps, without a branch. |tiles| <= kNearTiles.
inline TileSteps near_tile_steps(double tiles) {
    const double shifted = tiles + kStepShift;
    const double rest = tiles - (shifted - kStepShift);  // exact, at most half a place
    const auto steps_of_two = static_cast<std::int64_t>(static_cast<std::int32_t>(rest * 0x1p63));
    return (std::bit_cast<std::uint64_t>(shifted) << 32) + 2 * static_cast<TileSteps>(steps_of_two);
}

/// Half a step of TilePlace: added once, it makes the upper half of all steps down a column the nearest place.
inline constexpr TileSteps kHalfPlace = TileSteps{1} << 31;

/// A run of pixels down one column; pixel i of the run is in row first_row + i.
struct Run {
    std::uint32_t* pixels;
    int first_row;
    int count;
};

/// Rows [tops[i], bottoms[i]) of the i-th of `count` columns; none where tops[i] >= bottoms[i].
struct ColumnRuns {
    std::uint32_t* pixels;  ///< row 0 of the first column; down a column, rows are side by side
    std::ptrdiff_t pitch;   ///< from a column to the next [px]
    int count;
    const int* tops;     ///< [count]
    const int* bottoms;  ///< [count]
};

/// Texture columns of a wall.
struct PlainWalls {
    ColumnRuns runs;
    const Texture* texture;
    const std::uint32_t* first_texels;  ///< of each column's texture column, among the picture's [count]
    const TileSteps* v_at_row_0;        ///< [count]
    const TileSteps* v_per_row;         ///< [count]
    const Shade* shades;                ///< [count]
    const ColorTable* color_table;      ///< that the texture goes by, or null: it is darkened in proportion
};

/// Kernels that draw several rows at once may look at so many after a run's last.
inline constexpr int kRowsBeyond = 7;

/// A floor or ceiling: tile position = base + depth(row) * step.
struct PlainFlats {
    ColumnRuns runs;
    const Texture* texture;
    double base_u, base_v;              ///< under the eye, in [0, 1) [tiles]
    const double* step_u;               ///< per metre of depth along each column's ray [count] [tiles/m]
    const double* step_v;               ///< such that depth * step <= kNearTiles - 1
    const double* farthest;             ///< where depths are cut off: of the wall behind the flat [count] [m]
    const double* row_depths;           ///< by row, and kRowsBeyond more that may be read [m]
    const std::uint32_t* row_darkness;  ///< by row: darkness_of() its shade; and as many more
    const ColorTable* color_table;      ///< that the texture goes by, or null: it is darkened in proportion
};

/// How kernels want a row's shade: in both halves of the word, so that it multiplies two channels at once; for a color
/// table the number of the first colour of its level.
inline std::uint32_t darkness_of(const ColorTable* table, Shade shade) {
    constexpr std::uint32_t kBothHalves = 0x00010001;
    return table ? static_cast<std::uint32_t>(darkened_colors(*table, shade) - table->at_level(0))
                 : shade * kBothHalves;
}

/// A texel in the light that darkness_of() tells. texel: among the texture's.
inline std::uint32_t darkened(const ColorTable* table, const Texture& texture, std::size_t texel,
                              std::uint32_t darkness) {
    if (table) return table->at_level(0)[darkness + texture.numbers[texel]];
    return shaded(texture.pixels[texel], darkness & 0xFFFF);
}

/// A column of sky.
struct SkyRun {
    const std::uint32_t* texels;  ///< texture column [height]
    std::uint32_t height;
    double v_at_horizon;      ///< [tiles]
    double last;              ///< last_of_sky() [tiles]
    double v_per_rise;        ///< tiles per row above the horizon
    const double* row_rises;  ///< by row: rows above the horizon [px]
};

struct PlainKernels {
    std::string_view name;  ///< "scalar", "sse2" or "avx2"
    void (*fill_walls)(const PlainWalls& walls);
    void (*fill_flats)(const PlainFlats& flats);
    void (*fill_sky)(const Run& run, const SkyRun& sky);
    /// The texels as they are painted, with their alpha: shades and color table are not looked at, and may be null.
    /// Returns all of them or-ed: 0 in its uppermost byte where nothing of them is to be seen.
    std::uint32_t (*read_walls)(const PlainWalls& walls);
    /// The texels in their light, laid_over() the pixels as much as their alpha says.
    void (*lay_walls)(const PlainWalls& walls);
    /// As they are painted, with their alpha: darkness and color table are not looked at, and may be null.
    void (*read_flats)(const PlainFlats& flats);
};

/// The definition, pixel by pixel.
const PlainKernels& scalar_kernels();
/// Four pixels at a time; nothing where the processor cannot. Every x86-64 can.
std::optional<PlainKernels> four_wide_kernels();
/// Eight, with AVX2.
std::optional<PlainKernels> eight_wide_kernels();

/// Those of this name, if this processor can run them.
std::optional<PlainKernels> kernels_named(std::string_view name);

/// Those that the environment variable ENFILADE_KERNELS names; the fastest that this processor can run where it is not
/// set, or names none of them (check_kernels()).
PlainKernels chosen_kernels();

/// An error where ENFILADE_KERNELS names no kernels that this processor can run.
Result<void> check_kernels();

/// As PlainKernels::fill_flats, however far: without its limit on depth * step.
void fill_far_flats(const PlainFlats& flats);

/// As PlainKernels::read_flats, however far.
void read_far_flats(const PlainFlats& flats);

/// As PlainKernels::read_walls, one by one.
std::uint32_t read_walls(const PlainWalls& walls);

/// As PlainKernels::lay_walls, one by one.
void lay_walls(const PlainWalls& walls);

/// A layer of sky with holes, laid over what is there already.
void lay_sky(const Run& run, const SkyRun& layer);

void fill_color(const Run& run, std::uint32_t color);

// What the kernels that draw several pixels at a time have in common: which texel, by a shift where a picture's side is
// a power of two, by a product elsewhere, the same numbers; and where a column of a wall begins.

/// size >= 1. (std::has_single_bit() counts all bits where a processor may lack the instruction.)
constexpr bool is_power_of_two(std::uint32_t size) { return (size & (size - 1)) == 0; }

/// Such that size = 2^bits_below(size), where it is a power of two.
constexpr int bits_below(std::uint32_t size) { return std::countr_zero(size); }

/// Whether its rows are found by shifts.
inline bool goes_by_shifts(const Texture& texture) { return texture.height > 1 && is_power_of_two(texture.height); }

/// Where steps down a tile fall among the texels of a picture's column. By shifts only where it goes_by_shifts().
template <bool kByShifts>
class RowNumber {
public:
    explicit RowNumber(std::uint32_t height) : height_(height), shift_(64 - bits_below(height)) {}
    std::size_t operator()(TileSteps v) const { return kByShifts ? v >> shift_ : (v >> 32) * height_ >> 32; }

private:
    std::uint64_t height_;
    int shift_;
};

/// One column of a wall.
struct WallColumn {
    std::uint32_t* pixels;  ///< the first that is drawn
    int count;
    TileSteps v;  ///< of the first, half a place on
    TileSteps step;
};

inline WallColumn column_of(const PlainWalls& w, int i) {
    const int top = w.runs.tops[i];
    return {w.runs.pixels + i * w.runs.pitch + top, w.runs.bottoms[i] - top,
            w.v_at_row_0[i] + w.v_per_row[i] * static_cast<TileSteps>(top) + kHalfPlace, w.v_per_row[i]};
}

// What becomes of a run of pixels once its picture is drawn: the light of lamps, fog, and laying it over what was there
// before. A surface goes through those it needs, one after the other; what it does without costs nothing.
//
// The scalar passes say what is drawn; those for AVX2 draw the same bits, eight pixels at a time.

/// Pixels that lamps light.
struct LitRun {
    Run run;
    /// As painted, where a color table has darkened the run's pixels already: what lamps add comes on top of them
    /// (lit_above()) [count]. Null: the pixels are as painted, and are darkened, too (lit()).
    const std::uint32_t* texels = nullptr;
};

/// Points of light side by side. Lanes as in LightCell: red and blue in one word, green in the other.
struct LightRow {
    std::uint32_t* red_blue;  ///< [count], and kCellsBeyond more on either side that may be read, and written after it
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

/// The light of lamps on a floor or ceiling along one column: position in the grid = base + depth(row) * step. Down the
/// run depths only grow or only shrink, up to the last that is cut off; no position is farther than 2^34 cells.
struct FlatLamplight {
    const LightGrid* grid;
    double base_u, base_v;     ///< under the eye, and kGridShift more [cells]
    double step_u, step_v;     ///< per metre of depth along this column's ray [cells/m]
    double farthest;           ///< depths are cut off here: where the wall behind the flat stands; finite [m]
    const double* row_depths;  ///< by row, and kRowsBeyond more that may be read [m]
    /// Without lamps, by row, in both halves of each word; and as many more.
    const std::uint32_t* row_shades;
};

struct LampPasses {
    /// between() two columns of a grid: to.count points.
    void (*mix_cells)(const LightCell* a, const LightCell* b, LightPart part, const LightRow& to);
    void (*light_wall)(const LitRun& lit, const WallLamplight& lamplight);
    void (*light_flat)(const LitRun& lit, const FlatLamplight& lamplight);
};

struct Passes {
    LampPasses lamps;
    /// Fog of a colour. fog_parts: of each pixel, and kRowsBeyond more that may be read.
    void (*add_fog)(const Run& run, std::uint32_t fog, const FogPart* fog_parts);
    /// Colours laid_over() the run's pixels, as much as the alpha of `texels` says; both [count].
    void (*blend)(const Run& run, const std::uint32_t* colors, const std::uint32_t* texels);
};

/// The definition, pixel by pixel.
const Passes& scalar_passes();
/// Eight pixels at a time, with AVX2; nothing where the processor cannot.
std::optional<Passes> eight_wide_passes();

/// Those that go with these kernels.
Passes passes_beside(const PlainKernels& kernels);

}  // namespace enfilade::column
