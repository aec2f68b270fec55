#include "space/mosaic.h"

#include "base/hash.h"
#include "math/predicates.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

void place_corners(Mosaic& mosaic, Random& random) {
    const MosaicPlan& plan = mosaic.plan;
    const auto range = static_cast<std::uint64_t>(plan.jitter / plan.jitter_step);
    const auto moved = [&] {
        return (static_cast<double>(random.below(2 * range + 1)) - static_cast<double>(range)) * plan.jitter_step;
    };
    for (int row = 0; row <= plan.rows; ++row)
        for (int column = 0; column <= plan.columns; ++column) {
            const bool border = column == 0 || row == 0 || column == plan.columns || row == plan.rows;
            const Vec2 by = border ? Vec2{} : Vec2{moved(), moved()};
            mosaic.corners.push_back(plan.origin + Vec2{column * plan.spacing, row * plan.spacing} + by);
        }
}

void place_cells(Mosaic& mosaic, Random& random) {
    const MosaicPlan& plan = mosaic.plan;
    for (int row = 0; row < plan.rows; ++row)
        for (int column = 0; column < plan.columns; ++column) {
            const bool rock = random.uniform(0, 1) < plan.solid;
            const SectorId label(static_cast<std::size_t>(random.below(std::uint64_t(plan.labels))));
            const int nw = row * (plan.columns + 1) + column, sw = nw + plan.columns + 1;
            mosaic.cells.push_back({{nw, nw + 1, sw + 1, sw}, rock ? SectorId() : label});
        }
}

}  // namespace

SectorId Mosaic::sector_at(Vec2 p) const {
    for (const Cell& cell : cells) {
        const std::size_t count = cell.corners.size();
        bool is_inside = true;
        for (std::size_t i = 0; i < count && is_inside; ++i)
            is_inside = side_of_line(corners[std::size_t(cell.corners[i])],
                                     corners[std::size_t(cell.corners[(i + 1) % count])], p) > 0;
        if (is_inside) return cell.sector;
    }
    return {};
}

Mosaic lay_mosaic(const MosaicPlan& plan, std::uint64_t seed) {
    Mosaic mosaic;
    mosaic.plan = plan;
    Random random(seed);
    place_corners(mosaic, random);
    place_cells(mosaic, random);
    MapFile file = map_of_cells(mosaic.corners, mosaic.cells, plan.labels, {}, random);
    join_all(file);
    mosaic.map = built(file);
    return mosaic;
}

}  // namespace enfilade::test
