#include "render/sunlight.h"

#include <algorithm>

namespace enfilade {
namespace {

std::uint32_t sum_of(std::uint32_t lane, float light) {
    return static_cast<std::uint32_t>(
        std::min(static_cast<float>(lane) + light + 0.5f, static_cast<float>(kMostLight)));
}

}  // namespace

LightGrid in_sun(LightGrid grid, const LampColor& sun) {
    if (sun == LampColor{}) return grid;
    if (grid.columns == 0) grid = {0, 0, 2, 2, std::vector<LightCell>(4)};
    for (LightCell& cell : grid.cells)
        cell = light_cell(sum_of(lane(cell, 0), sun.red), sum_of(lane(cell, 1), sun.green),
                          sum_of(lane(cell, 2), sun.blue));
    grid.is_dark_before_u = grid.is_dark_after_u = grid.is_dark_before_v = grid.is_dark_after_v = false;
    return grid;
}

}  // namespace enfilade
