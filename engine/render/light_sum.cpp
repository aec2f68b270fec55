// What all lamps together throw onto a surface.
#include <algorithm>

#include "render/light_patch.h"

namespace enfilade {
namespace {

/// The box around all of them.
LightBox box_around(std::span<const LightPatch> patches) {
    LightBox all;
    for (const auto& [box, arrives] : patches) {
        if (arrives.empty()) continue;
        if (all.columns == 0) all = box;
        const int right = std::max(all.column + all.columns, box.column + box.columns);
        const int end = std::max(all.row + all.rows, box.row + box.rows);
        all.column = std::min(all.column, box.column);
        all.row = std::min(all.row, box.row);
        all.columns = right - all.column;
        all.rows = end - all.row;
    }
    return all;
}

std::uint32_t lane_of(float light) {
    return static_cast<std::uint32_t>(std::min(light, static_cast<float>(kMostLight) - 0.5f) + 0.5f);
}

/// Where in a grid there is light: points [column, column + columns) x [row, row + rows), none where all is dark.
LightBox lit_points(const LightGrid& grid) {
    LightBox lit;
    int right = 0, end = 0;
    for (int i = 0; i < grid.columns; ++i)
        for (int j = 0; j < grid.rows; ++j) {
            if (is_dark(grid.cells[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid.rows) +
                                   static_cast<std::size_t>(j)]))
                continue;
            lit.column = right == 0 ? i : lit.column;
            lit.row = right == 0 ? j : std::min(lit.row, j);
            right = i + 1;
            end = std::max(end, j + 1);
        }
    lit.columns = right - lit.column;
    lit.rows = end - lit.row;
    return lit;
}

/// Without what is dark around the light, but for a rim one point wide.
LightGrid trimmed(const LightGrid& grid) {
    const LightBox lit = lit_points(grid);
    if (lit.columns == 0) return {};
    const int left = std::max(lit.column - 1, 0), right = std::min(lit.column + lit.columns + 1, grid.columns);
    const int first = std::max(lit.row - 1, 0), end = std::min(lit.row + lit.rows + 1, grid.rows);
    LightGrid part{grid.u + left * kLightCell, grid.v + first * kLightCell, right - left, end - first, {}};
    part.is_dark_before_u = left < lit.column;
    part.is_dark_after_u = right > lit.column + lit.columns;
    part.is_dark_before_v = first < lit.row;
    part.is_dark_after_v = end > lit.row + lit.rows;
    part.cells.reserve(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
    for (int i = left; i < right; ++i) {
        const auto column = grid.cells.begin() + std::ptrdiff_t{i} * grid.rows;
        part.cells.insert(part.cells.end(), column + first, column + end);
    }
    return part;
}

}  // namespace

LightGrid sum_of(std::span<const LightPatch> patches, std::span<const LampColor> colors) {
    const LightBox all = box_around(patches);
    LightGrid grid{all.column * kLightCell, all.row * kLightCell, all.columns, all.rows, {}};
    std::vector<LampColor> sums(static_cast<std::size_t>(all.columns) * static_cast<std::size_t>(all.rows));
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const float* arrives = patches[p].arrives.data();
        const LightBox& box = patches[p].box;
        if (patches[p].arrives.empty()) continue;
        for (int i = box.column - all.column; i < box.column - all.column + box.columns; ++i)
            for (int j = box.row - all.row; j < box.row - all.row + box.rows; ++j, ++arrives) {
                LampColor& sum = sums[static_cast<std::size_t>(i) * static_cast<std::size_t>(all.rows) +
                                      static_cast<std::size_t>(j)];
                sum.red += *arrives * colors[p].red;
                sum.green += *arrives * colors[p].green;
                sum.blue += *arrives * colors[p].blue;
            }
    }
    grid.cells.reserve(sums.size());
    for (const LampColor& sum : sums)
        grid.cells.push_back(light_cell(lane_of(sum.red), lane_of(sum.green), lane_of(sum.blue)));
    return trimmed(grid);
}

}  // namespace enfilade
