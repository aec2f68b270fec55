#include "space/cells.h"

#include <algorithm>
#include <string>
#include <utility>

#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// A cell's edge, from corner to corner, the cell on its right.
struct Edge {
    int from, to, cell;
};

using Edges = std::vector<Edge>;

Edges edges_of(const std::vector<Cell>& cells, SectorId id) {
    Edges edges;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const std::vector<int>& corners = cells[cell].corners;
        if (cells[cell].sector != id) continue;
        for (std::size_t i = 0; i < corners.size(); ++i)
            edges.push_back({corners[i], corners[(i + 1) % corners.size()], static_cast<int>(cell)});
    }
    return edges;
}

/// Takes out edges that have a cell of the sector on the other side, too, but for some slits.
void keep_walls(Edges& edges, double slits, Random& random) {
    using Ends = std::pair<int, int>;
    std::vector<Ends> ends, kept;
    for (const Edge& e : edges) ends.emplace_back(e.from, e.to);
    std::sort(ends.begin(), ends.end());
    const auto is_in = [](const std::vector<Ends>& sorted, int from, int to) {
        return std::binary_search(sorted.begin(), sorted.end(), Ends(from, to));
    };
    for (const auto& [from, to] : ends)
        if (from < to && slits > 0 && random.uniform(0, 1) < slits) kept.emplace_back(from, to);
    std::erase_if(edges, [&](const Edge& e) {
        return is_in(ends, e.to, e.from) && !is_in(kept, std::min(e.from, e.to), std::max(e.from, e.to));
    });
}

/// The edge that goes on where `last` ends. Where two loops touch in a corner, each stays with its own cell.
Edges::iterator following(Edges& edges, const Edge& last) {
    auto next = edges.end();
    for (auto e = edges.begin(); e != edges.end(); ++e)
        if (e->from == last.to && (next == edges.end() || e->cell == last.cell)) next = e;
    return next;
}

/// One closed loop out of `edges` that visits no corner twice. What it has to leave out for that goes back to them.
Edges take_loop(Edges& edges) {
    Edges loop{edges.back()};
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

/// One closed loop out of `edges` that goes on anyhow where it can. Of two edges only if it cannot go on.
Edges take_tangle(Edges& edges, Random& random) {
    Edges loop{edges.back()};
    edges.pop_back();
    while (true) {
        std::vector<std::size_t> ways;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (edges[i].from == loop.back().to) ways.push_back(i);
        const bool may_close = loop.back().to == loop.front().from && loop.size() > 2;
        if (ways.empty() || (may_close && random.below(2) == 0)) return loop;
        const std::size_t way = ways[random.below(ways.size())];
        loop.push_back(edges[way]);
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(way));
    }
}

std::vector<LoopRecord> loops_of(const std::vector<Vec2>& corners, Edges edges, bool is_tangled, Random& random) {
    std::vector<LoopRecord> loops;
    while (!edges.empty()) {
        std::vector<Vec2> vertices;
        for (const Edge& edge : is_tangled ? take_tangle(edges, random) : take_loop(edges))
            vertices.push_back(corners[std::size_t(edge.from)]);
        if (vertices.size() > 2) loops.push_back(loop_of(std::move(vertices)));  // a lone slit is no loop
    }
    return loops;
}

}  // namespace

MapFile map_of_cells(const std::vector<Vec2>& corners, std::vector<Cell>& cells, int labels, const LoopStyle& style,
                     Random& random) {
    MapFile file = map_of({});
    for (int label = 0; label < labels; ++label) {
        Edges edges = edges_of(cells, SectorId(std::size_t(label)));
        if (edges.empty()) continue;
        const SectorId id(file.sectors.size());
        for (Cell& cell : cells)
            if (cell.sector == SectorId(std::size_t(label))) cell.sector = id;
        keep_walls(edges, style.slits, random);
        SectorRecord sector;
        sector.name = std::to_string(id.index);
        sector.ceiling.z = 3;
        sector.loops = loops_of(corners, std::move(edges), style.is_tangled, random);
        file.sectors.push_back(std::move(sector));
    }
    return file;
}

}  // namespace enfilade::test
