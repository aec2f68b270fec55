#include "space/mosaic.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/random.h"
#include "math/predicates.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// A cell's edge, from corner to corner, the cell on its right.
struct Edge {
    int from, to;  ///< indices into Mosaic::corners
    int cell;
};

/// Edges of the sector's cells that have no cell of the sector on the other side.
std::vector<Edge> border_of(const Mosaic& mosaic, SectorId id) {
    const int columns = mosaic.plan.columns, rows = mosaic.plan.rows;
    const auto belongs = [&](int column, int row) {
        const bool inside = column >= 0 && row >= 0 && column < columns && row < rows;
        return inside && mosaic.cells[std::size_t(row * columns + column)] == id;
    };
    std::vector<Edge> edges;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            if (!belongs(column, row)) continue;
            const int cell = row * columns + column;
            const int nw = row * (columns + 1) + column, ne = nw + 1, sw = nw + columns + 1, se = sw + 1;
            if (!belongs(column, row - 1)) edges.push_back({nw, ne, cell});
            if (!belongs(column + 1, row)) edges.push_back({ne, se, cell});
            if (!belongs(column, row + 1)) edges.push_back({se, sw, cell});
            if (!belongs(column - 1, row)) edges.push_back({sw, nw, cell});
        }
    return edges;
}

/// The edge that goes on where `last` ends. Where two loops touch in a corner, each stays with its own cell.
std::vector<Edge>::iterator following(std::vector<Edge>& edges, const Edge& last) {
    auto next = edges.end();
    for (auto e = edges.begin(); e != edges.end(); ++e)
        if (e->from == last.to && (next == edges.end() || e->cell == last.cell)) next = e;
    return next;
}

/// One closed loop out of `edges` that visits no corner twice. What it has to leave out for that goes back to them.
std::vector<Edge> take_loop(std::vector<Edge>& edges) {
    std::vector<Edge> loop{edges.back()};
    edges.pop_back();
    while (true) {
        const auto begin = std::find_if(loop.begin(), loop.end(), [&](Edge e) { return e.from == loop.back().to; });
        if (begin != loop.end()) {
            edges.insert(edges.end(), loop.begin(), begin);
            loop.erase(loop.begin(), begin);
            return loop;
        }
        const auto next = following(edges, loop.back());
        loop.push_back(*next);
        edges.erase(next);
    }
}

/// The sector made of the cells that carry its id, or none where there are no such cells.
std::optional<SectorRecord> sector_of(const Mosaic& mosaic, SectorId id) {
    SectorRecord sector;
    sector.name = std::to_string(id.index);
    sector.ceiling.z = 3;
    std::vector<Edge> edges = border_of(mosaic, id);
    while (!edges.empty()) {
        std::vector<Vec2> vertices;
        for (const Edge& edge : take_loop(edges)) vertices.push_back(mosaic.corners[std::size_t(edge.from)]);
        sector.loops.push_back(loop_of(std::move(vertices)));
    }
    if (sector.loops.empty()) return {};
    return sector;
}

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

}  // namespace

SectorId Mosaic::sector_at(Vec2 p) const {
    for (int row = 0; row < plan.rows; ++row)
        for (int column = 0; column < plan.columns; ++column) {
            const Vec2 nw = corner(column, row), ne = corner(column + 1, row);
            const Vec2 se = corner(column + 1, row + 1), sw = corner(column, row + 1);
            if (side_of_line(nw, ne, p) > 0 && side_of_line(ne, se, p) > 0 && side_of_line(se, sw, p) > 0 &&
                side_of_line(sw, nw, p) > 0)
                return cells[std::size_t(row * plan.columns + column)];
        }
    return {};
}

Mosaic lay_mosaic(const MosaicPlan& plan, std::uint64_t seed) {
    Mosaic mosaic;
    mosaic.plan = plan;
    Random random(seed);
    place_corners(mosaic, random);
    for (int i = 0; i < plan.columns * plan.rows; ++i) {
        const bool rock = random.uniform(0, 1) < plan.solid;
        const SectorId label(static_cast<std::size_t>(random.below(std::uint64_t(plan.labels))));
        mosaic.cells.push_back(rock ? SectorId() : label);
    }
    MapFile file = map_of({});
    for (int label = 0; label < plan.labels; ++label) {
        const SectorId id(file.sectors.size());
        std::replace(mosaic.cells.begin(), mosaic.cells.end(), SectorId(std::size_t(label)), id);
        if (auto sector = sector_of(mosaic, id)) file.sectors.push_back(std::move(*sector));
    }
    join_all(file);
    mosaic.map = built(file);
    return mosaic;
}

}  // namespace enfilade::test
