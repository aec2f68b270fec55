// What point lights throw onto a surface: values at evenly spaced points, fixed to the surface, and the
// rules by which a place between them is lit. Shared by all renderers.
#pragma once
#include <cstdint>
#include <vector>

#include "formats/dials.h"
#include "render/shade.h"

namespace enfilade {

/// Red, green and blue light that is added to a surface's shade, each 0..kMostLight, in steps of kLightSteps to one of
/// Shade. Lanes of kLaneBits: red, blue and green from the lowest on, for red and blue lie side by side where every
/// second byte of a pixel is taken.
using LightCell = std::uint64_t;

inline constexpr int kLaneBits = 16;
inline constexpr std::uint32_t kLightSteps = 16;

/// What a lane holds at most: 13 bits, so that four times a difference still fits it. Almost twice as bright as
/// painted.
inline constexpr std::uint32_t kMostLight = (1u << 13) - 1;

/// Brighter than this nothing gets: twice as painted.
inline constexpr Shade kBrightest = 512;

constexpr LightCell light_cell(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return LightCell{red} | LightCell{blue} << kLaneBits | LightCell{green} << 2 * kLaneBits;
}

/// channel: 0 red, 1 green, 2 blue.
constexpr std::uint32_t lane(LightCell cell, int channel) {
    constexpr int kLaneOf[] = {0, 2, 1};
    return static_cast<std::uint32_t>(cell >> kLaneOf[channel] * kLaneBits) & kMostLight;
}

/// Whether it makes no surface brighter; then neither does anything between two such cells.
constexpr bool is_dark(LightCell cell) {
    constexpr std::uint32_t kSeen = kMostLight & ~(kLightSteps - 1);
    return (cell & light_cell(kSeen, kSeen, kSeen)) == 0;
}

/// Between two cells, `part` of 256 of the way from a to b. part: 0..256.
constexpr LightCell between(LightCell a, LightCell b, std::uint32_t part) {
    constexpr LightCell kEven = light_cell(kMostLight, kMostLight, 0);  // two lanes apart, so that products fit
    const LightCell even = ((a & kEven) * (256 - part) + (b & kEven) * part) >> 8 & kEven;
    const LightCell blue = (lane(a, 2) * (256 - part) + lane(b, 2) * part) >> 8;
    return even | blue << kLaneBits;
}

/// The colour 0xAABBGGRR in this shade and this light. Alpha becomes opaque.
constexpr std::uint32_t lit(std::uint32_t color, Shade shade, LightCell light) {
    std::uint32_t result = 0xFF000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t sum = shade + lane(light, channel) / kLightSteps;
        const std::uint32_t bright = (color >> 8 * channel & 0xFF) * (sum < kBrightest ? sum : kBrightest) >> 8;
        result |= (bright < 255 ? bright : 255) << 8 * channel;
    }
    return result;
}

/// The colour in a light that comes on top of what it has without, which is `darkened`: as much is added as lit() would
/// add to the shade. Alpha becomes opaque.
constexpr std::uint32_t lit_above(std::uint32_t darkened, std::uint32_t color, Shade shade, LightCell light) {
    std::uint32_t result = 0xFF000000u;
    for (int channel = 0; channel < 3; ++channel) {
        const std::uint32_t more = lane(light, channel) / kLightSteps, most = kBrightest - shade;
        const std::uint32_t added = (color >> 8 * channel & 0xFF) * (more < most ? more : most) >> 8;
        const std::uint32_t bright = (darkened >> 8 * channel & 0xFF) + added;
        result |= (bright < 255 ? bright : 255) << 8 * channel;
    }
    return result;
}

/// What the grid of a surface covers at most as densely as is asked for [m^2]: 362 m each way. Where lamps on one
/// surface lie farther apart, the points of its grid do, too.
inline constexpr double kMostGridArea = 0x1p17;

/// The light on a rectangle of a surface. A place is (u, v) on it: walls and panels (metres along from a, height z),
/// flats (x, y), all in the space of the surface's own sector.
struct LightGrid {
    double u = 0, v = 0;                                     ///< of the first point [m]
    double per_m = kUsualLightPoints;                        ///< points along a metre
    int columns = 0, rows = 0;                               ///< points along u and along v, each >= 2
    std::vector<LightCell> cells;                            ///< by column: cells[column * rows + row]
    bool is_dark_before_u = false, is_dark_after_u = false;  ///< all points of the first, or last, column are dark
    bool is_dark_before_v = false, is_dark_after_v = false;  ///< the same of rows
};

/// Where a place is between the points of one direction.
struct GridStep {
    int cell = 0;            ///< 0..count - 2: the point before it
    std::uint32_t part = 0;  ///< of the way to the next, 0..256
};

/// cells: position counted in points from the first; beyond the ends counts as at them. count >= 2.
constexpr GridStep grid_step(double cells, int count) {
    const double last = count - 1;
    const double inside = cells > 0 ? (cells < last ? cells : last) : 0;
    const int whole = static_cast<int>(inside) < count - 2 ? static_cast<int>(inside) : count - 2;
    return {whole, static_cast<std::uint32_t>((inside - whole) * 256)};
}

/// Even between four points.
inline LightCell light_between(const LightGrid& grid, GridStep across, GridStep along) {
    const LightCell* first = &grid.cells[static_cast<std::size_t>(across.cell) * static_cast<std::size_t>(grid.rows) +
                                         static_cast<std::size_t>(along.cell)];
    const LightCell* second = first + grid.rows;
    return between(between(first[0], second[0], across.part), between(first[1], second[1], across.part), along.part);
}

/// Whether a place is so far beyond the grid that it is dark. Counted in points from the first.
inline bool is_beyond_light(const LightGrid& grid, double across, double along) {
    return (grid.is_dark_before_u && across <= 0) || (grid.is_dark_after_u && across >= grid.columns - 1) ||
           (grid.is_dark_before_v && along <= 0) || (grid.is_dark_after_v && along >= grid.rows - 1);
}

/// The light at a place: even between the four points around it; beyond the grid that of its edge.
inline LightCell light_on(const LightGrid& grid, double u, double v) {
    return light_between(grid, grid_step((u - grid.u) * grid.per_m, grid.columns),
                         grid_step((v - grid.v) * grid.per_m, grid.rows));
}

}  // namespace enfilade
