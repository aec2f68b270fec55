#include "wild/worlds.h"

#include <algorithm>
#include <cmath>

#include "space/cells.h"
#include "support/map_builder.h"
#include "wild/island.h"
#include "wild/plans.h"

namespace enfilade::test {
namespace {

constexpr std::int64_t kLimit = static_cast<std::int64_t>(kWorldLimit / kVertexGrid);
constexpr std::int64_t kSmallest = 10, kLargest = std::int64_t{30'000} << 10;  ///< 1 cm, 30 km [grid steps]

/// Evenly over the orders of magnitude; most islands are as large as rooms.
std::int64_t any_length(Choices& choices) {
    if (choices.one_in(3)) {
        const double octaves = std::log2(static_cast<double>(kLargest) / static_cast<double>(kSmallest));
        return static_cast<std::int64_t>(static_cast<double>(kSmallest) * std::exp2(choices.between(0, octaves)));
    }
    return 1024 * (4 + static_cast<std::int64_t>(choices.below(16)));
}

/// Where an island of that length begins: near the origin, anywhere, or so that it ends at the edge of the world.
std::int64_t any_place(std::int64_t length, Choices& choices) {
    switch (choices.below(4)) {
        case 0: return std::min<std::int64_t>(1024 * static_cast<std::int64_t>(choices.below(32)), kLimit - length);
        case 1: return kLimit - length;
        case 2: return -kLimit;
        default:
            return static_cast<std::int64_t>(choices.below(static_cast<std::uint64_t>(2 * kLimit - length))) - kLimit;
    }
}

Island any_island(Choices& choices) {
    const std::int64_t width = any_length(choices);
    const std::int64_t height = choices.one_in(4) ? any_length(choices) : width;
    Island island({any_place(width, choices), any_place(height, choices)}, width, height, choices.one_in(4));
    for (std::uint64_t points = choices.below(16); points > 0; --points) island.strew(choices);
    if (choices.one_in(8)) island.fan(choices, choices.below(100));
    for (std::uint64_t turns = choices.below(8); turns > 0; --turns) island.turn(choices);
    return island;
}

/// Labels, or rock: that of an earlier triangle, or another.
std::vector<Cell> labelled(const Island& island, std::uint64_t labels, Choices& choices) {
    std::vector<Cell> cells;
    for (const auto& t : island.triangles()) {
        SectorId label(static_cast<std::size_t>(choices.below(labels)));
        if (!cells.empty() && choices.one_in(2)) label = choices.any(cells).sector;
        if (!cells.empty() && choices.one_in(8)) label = {};
        cells.push_back({{t.begin(), t.end()}, label});
    }
    return cells;
}

/// Names the island's sectors after their numbers in the whole plan, and keeps their ground.
void add_island(WorldPlan& plan, Choices& choices) {
    const Island island = any_island(choices);
    std::vector<Vec2> corners;
    for (const GridPoint p : island.points()) corners.push_back(metres(p));
    const std::uint64_t labels = 1 + choices.below(8);
    std::vector<Cell> cells = labelled(island, labels, choices);
    const LoopStyle style{choices.one_in(4), choices.one_in(4) ? 0.1 : 0};
    Random random = choices.random();
    MapFile part = map_of_cells(corners, cells, static_cast<int>(labels), style, random);
    const std::size_t first = plan.file.sectors.size();
    for (SectorRecord& sector : part.sectors) {
        sector.name = "s" + std::to_string(plan.file.sectors.size());
        plan.file.sectors.push_back(std::move(sector));
    }
    for (const Cell& cell : cells)
        if (cell.sector)
            plan.ground.push_back({first + cell.sector.index, corners[std::size_t(cell.corners[0])],
                                   corners[std::size_t(cell.corners[1])], corners[std::size_t(cell.corners[2])]});
    const Vec2 span = corners[2] - corners[0];
    plan.size = std::min({first == 0 ? kWorldLimit : plan.size, span.x, span.y});
    join_neighbours(plan, first, choices);
}

}  // namespace

MapFile wild_world(Choices& choices) {
    WorldPlan plan;
    plan.file = map_of({});
    plan.file.name = "wild";
    for (std::uint64_t islands = 1 + choices.below(3); islands > 0; --islands) add_island(plan, choices);
    for (std::uint64_t joints = choices.below(8); joints > 0; --joints) add_joint(plan, choices);
    furnish(plan, choices);
    return std::move(plan.file);
}

MapFile wild_world(std::uint64_t seed) {
    const std::vector<std::byte> bytes = random_bytes(seed);
    Choices choices(bytes);
    return wild_world(choices);
}

}  // namespace enfilade::test
