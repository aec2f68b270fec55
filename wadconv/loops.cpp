#include "wadconv/parts.h"

#include <algorithm>
#include <map>

#include "map/edge_sweep.h"

namespace enfilade::wadconv {
namespace {

/// An edge as seen from one of its ends.
struct Spoke {
    Point hub;           ///< the end it is seen from
    Point rim;           ///< the other end
    std::uint32_t edge;  ///< index into the list of edges that are traced
    bool is_leaving;     ///< the edge starts at the hub
};

/// 0 for directions from +x over -y (up on the drawing) to just before -x, 1 for the other half turn.
int half_turn(const Spoke& s) {
    const std::int32_t dx = s.rim.x - s.hub.x, dy = s.rim.y - s.hub.y;
    return dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
}

/// Orders spokes by hub, then counter-clockwise on the drawing; where an arriving and a leaving edge lie on each other
/// the leaving one comes first, so that turning back on the spot is the last choice.
bool comes_before(const Spoke& s, const Spoke& t) {
    if (s.hub != t.hub) return s.hub < t.hub;
    if (half_turn(s) != half_turn(t)) return half_turn(s) < half_turn(t);
    if (const std::int64_t turn = cross(s.hub, s.rim, t.rim); turn != 0) return turn < 0;
    if (s.is_leaving != t.is_leaving) return s.is_leaving;
    return s.edge < t.edge;
}

std::vector<Spoke> sorted_spokes(std::span<const Edge> edges, std::span<const std::uint32_t> own) {
    std::vector<Spoke> spokes;
    for (std::uint32_t i = 0; i < own.size(); ++i) {
        const Edge& e = edges[own[i]];
        spokes.push_back({e.a, e.b, i, true});
        spokes.push_back({e.b, e.a, i, false});
    }
    std::ranges::sort(spokes, comes_before);
    return spokes;
}

/// Gives every arriving edge of one hub its successor, like brackets around a circle: arriving opens, leaving closes.
/// In a sound map the two always alternate; in a tangled one brackets still pair everything.
void pair_spokes(std::span<const Spoke> around, std::vector<std::uint32_t>& next) {
    std::vector<std::uint32_t> arrived;
    std::vector<bool> is_paired(around.size());
    for (int lap = 0; lap < 2; ++lap)
        for (std::size_t i = 0; i < around.size(); ++i) {
            if (!around[i].is_leaving && lap == 0) arrived.push_back(around[i].edge);
            if (around[i].is_leaving && !is_paired[i] && !arrived.empty()) {
                next[arrived.back()] = around[i].edge;
                arrived.pop_back();
                is_paired[i] = true;
            }
        }
}

/// Calls visit(spokes of one hub) for every hub.
template <class Visit>
void for_each_hub(std::span<const Spoke> spokes, const Visit& visit) {
    for (std::size_t begin = 0, end = 0; begin < spokes.size(); begin = end) {
        while (end < spokes.size() && spokes[end].hub == spokes[begin].hub) ++end;
        visit(spokes.subspan(begin, end - begin));
    }
}

std::vector<OpenEnd> find_open_ends(std::span<const Spoke> spokes) {
    std::vector<OpenEnd> open;
    for_each_hub(spokes, [&](std::span<const Spoke> around) {
        int surplus = 0;
        for (const Spoke& s : around) surplus += s.is_leaving ? 1 : -1;
        if (surplus != 0) open.push_back({around[0].hub, surplus});
    });
    return open;
}

using Walk = std::vector<std::uint32_t>;

/// Follows `next`, which is a permutation, into its cycles.
std::vector<Walk> cycles_of(std::span<const std::uint32_t> next) {
    std::vector<bool> seen(next.size());
    std::vector<Walk> walks;
    for (std::uint32_t first = 0; first < next.size(); ++first) {
        if (seen[first]) continue;
        Walk& walk = walks.emplace_back();
        for (std::uint32_t e = first; !seen[e]; e = next[e]) {
            seen[e] = true;
            walk.push_back(e);
        }
    }
    return walks;
}

/// The cycles of the boundary, as indices into `edges`.
std::vector<Walk> walk_around(std::span<const Edge> edges, std::span<const std::uint32_t> own) {
    std::vector<std::uint32_t> next(own.size());
    for_each_hub(sorted_spokes(edges, own), [&](std::span<const Spoke> around) { pair_spokes(around, next); });
    std::vector<Walk> walks = cycles_of(next);
    for (Walk& walk : walks)
        for (std::uint32_t& e : walk) e = own[e];
    return walks;
}

/// Edges of which both directions are in one walk.
std::vector<std::uint32_t> find_lone(std::span<const Edge> edges, const std::vector<Walk>& walks) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> walk_of;
    for (std::uint32_t w = 0; w < walks.size(); ++w)
        for (std::uint32_t e : walks[w]) walk_of.emplace_back(e, w);
    std::ranges::sort(walk_of);
    std::vector<std::uint32_t> lone;
    for (const auto& [e, w] : walk_of)
        if (std::ranges::binary_search(walk_of, std::pair(edges[e].opposite, w))) lone.push_back(e);
    return lone;
}

/// Adds the loop with its lowest edge in front.
void add_loop(std::span<const Edge> edges, Walk loop, std::vector<Loop>& loops) {
    std::ranges::rotate(loop, std::ranges::min_element(loop));
    std::int64_t area = 0;
    for (std::uint32_t e : loop) area += cross({0, 0}, edges[e].a, edges[e].b);
    loops.push_back({std::move(loop), area});
}

/// Cuts a walk at every point it passes twice.
void cut_at_pinches(std::span<const Edge> edges, const Walk& walk, std::vector<Loop>& loops) {
    std::vector<std::uint32_t> open;
    std::map<Point, std::size_t> depth_of;  // how many open edges came before the point
    for (std::uint32_t e : walk) {
        depth_of[edges[e].a] = open.size();
        open.push_back(e);
        const auto passed = depth_of.find(edges[e].b);
        if (passed == depth_of.end()) continue;
        const auto begin = open.begin() + static_cast<std::ptrdiff_t>(passed->second);
        for (auto it = begin; it != open.end(); ++it) depth_of.erase(edges[*it].a);
        add_loop(edges, Walk(begin, open.end()), loops);
        open.erase(begin, open.end());
    }
}

/// Says whether the horizontal ray from p to the right, p being moved by the tie rule, meets the edge a -> b.
bool ray_meets(Point a, Point b, Point p) {
    // (e, e^2) moves p down by less than anything: a corner at p's own height lies above the ray.
    if ((a.y > p.y) == (b.y > p.y)) return false;
    const std::int64_t turn = cross(a, b, p);
    return b.y > a.y ? turn > 0 : turn < 0;
}

/// How often lone edges are looked for. In a plane map once is enough; lines that cross may bring up new ones.
constexpr int kMaxRounds = 8;

}  // namespace

Tracing trace_loops(std::span<const Edge> edges, std::span<const std::uint32_t> own) {
    Tracing tracing;
    tracing.open_ends = find_open_ends(sorted_spokes(edges, own));
    if (!tracing.open_ends.empty()) return tracing;
    Walk left(own.begin(), own.end());
    std::vector<Walk> walks = walk_around(edges, left);
    for (int round = 0; round < kMaxRounds; ++round) {
        const std::vector<std::uint32_t> lone = find_lone(edges, walks);
        if (lone.empty()) break;
        std::erase_if(left, [&](std::uint32_t e) { return std::ranges::binary_search(lone, e); });
        tracing.lone.insert(tracing.lone.end(), lone.begin(), lone.end());
        walks = walk_around(edges, left);
    }
    tracing.is_tangled = !find_lone(edges, walks).empty();
    for (const Walk& walk : walks) cut_at_pinches(edges, walk, tracing.loops);
    std::ranges::sort(tracing.loops, {}, [](const Loop& loop) { return loop.edges.front(); });
    return tracing;
}

bool loop_contains(std::span<const Edge> edges, const Loop& loop, Point fine) {
    bool inside = false;
    for (std::uint32_t e : loop.edges) inside ^= ray_meets(to_fine(edges[e].a), to_fine(edges[e].b), fine);
    return inside;
}

std::vector<std::uint32_t> clashing_lines(std::span<const Edge> edges, std::span<const std::uint32_t> own) {
    std::vector<Wall> walls(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Edge& edge = edges[own[i]];
        walls[i].a = {edge.a.x / kUnitsPerMetre, edge.a.y / kUnitsPerMetre};
        walls[i].b = {edge.b.x / kUnitsPerMetre, edge.b.y / kUnitsPerMetre};
    }
    std::vector<std::uint32_t> lines;
    for (const Clash& clash : sweep_edges(walls).clashes)
        for (const std::uint32_t i : {clash.first, clash.second})
            if (edges[own[i]].line != kNone) lines.push_back(edges[own[i]].line);
    std::ranges::sort(lines);
    lines.erase(std::ranges::unique(lines).begin(), lines.end());
    return lines;
}

}  // namespace enfilade::wadconv
