#include "map/sweep_line.h"

#include <algorithm>
#include <tuple>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// 1 where f, which starts no earlier than e, lies after e (towards +y), -1 where before, 0 where on one line.
int side_of_later(const SweptEdge& e, const SweptEdge& f) {
    const int at_left = corner(e.left, e.right, f.left);
    return at_left != 0 ? at_left : corner(e.left, e.right, f.right);
}

}  // namespace

bool is_left_of(Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

SweptEdge swept(const Wall& wall) {
    const bool forward = is_left_of(wall.a, wall.b);
    return forward ? SweptEdge{wall.a, wall.b, true} : SweptEdge{wall.b, wall.a, false};
}

std::vector<SweptEdge> swept(std::span<const Wall> walls) {
    std::vector<SweptEdge> edges;
    edges.reserve(walls.size());
    for (const Wall& wall : walls) edges.push_back(swept(wall));
    return edges;
}

bool SweepOrder::operator()(std::uint32_t i, std::uint32_t j) const {
    const SweptEdge &e = (*edges)[i], &f = (*edges)[j];
    const int side = is_left_of(f.left, e.left) ? -side_of_later(f, e) : side_of_later(e, f);
    if (side != 0) return side > 0;
    return std::tie(e.forward, i) < std::tie(f.forward, j);
}

std::vector<SweepEvent> sweep_events(const std::vector<SweptEdge>& edges) {
    std::vector<SweepEvent> events;
    events.reserve(2 * edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (edges[i].left == edges[i].right) continue;
        events.push_back({edges[i].left, true, i});
        events.push_back({edges[i].right, false, i});
    }
    std::sort(events.begin(), events.end(), [](const SweepEvent& a, const SweepEvent& b) {
        return std::tie(a.point.x, a.point.y, a.starts, a.edge) < std::tie(b.point.x, b.point.y, b.starts, b.edge);
    });
    return events;
}

}  // namespace enfilade
