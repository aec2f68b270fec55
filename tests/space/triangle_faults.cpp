#include "space/triangle_faults.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace enfilade::test {
namespace {

__extension__ using Int128 = __int128;

/// In steps of the vertex grid.
struct Point {
    std::int64_t x, y;
    bool operator==(const Point&) const = default;
};

Point point_of(Vec2 v) {
    return {static_cast<std::int64_t>(v.x / kVertexGrid), static_cast<std::int64_t>(v.y / kVertexGrid)};
}

/// Twice the area of a triangle, positive where its corners run clockwise on the drawing.
Int128 area(Point a, Point b, Point c) { return Int128{b.x - a.x} * (c.y - a.y) - Int128{b.y - a.y} * (c.x - a.x); }

bool is_inside_edge(Point p, Point a, Point b) {
    if (p == a || p == b || area(a, b, p) != 0) return false;
    return Int128{p.x - a.x} * (p.x - b.x) + Int128{p.y - a.y} * (p.y - b.y) < 0;
}

class Inspection {
public:
    Inspection(const Map& map, const Sector& sector, std::span<const Triangle> triangles)
        : first_wall_(sector.first_wall), triangles_(triangles) {
        for (std::uint32_t i = 0; i < sector.wall_count; ++i) {
            starts_.push_back(point_of(map.walls[first_wall_ + i].a));
            ends_.push_back(point_of(map.walls[first_wall_ + i].b));
        }
    }

    std::string fault() {
        for (const Triangle& t : triangles_)
            for (std::size_t i = 0; i < 3; ++i) {
                if (t[i].index - first_wall_ >= starts_.size()) return "a corner is no wall of the sector";
                edges_.emplace_back(t[i].index - first_wall_, t[(i + 1) % 3].index - first_wall_);
            }
        std::sort(edges_.begin(), edges_.end());
        for (const auto& check :
             {&Inspection::fault_of_areas, &Inspection::fault_of_edges, &Inspection::fault_of_vertices})
            if (std::string fault = (this->*check)(); !fault.empty()) return fault;
        return {};
    }

private:
    /// By the numbers of the walls, from 0, that start where it starts and where it ends.
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    std::string fault_of_areas() {
        Int128 rest = 0;
        for (std::size_t i = 0; i < starts_.size(); ++i) rest += area(starts_[0], starts_[i], ends_[i]);
        for (const Triangle& t : triangles_) {
            const auto corner = [&](std::size_t i) { return starts_[t[i].index - first_wall_]; };
            const Int128 part = area(corner(0), corner(1), corner(2));
            if (part <= 0) return "a triangle is not clockwise";
            rest -= part;
        }
        return rest == 0 ? "" : "the areas do not add up";
    }

    std::string fault_of_edges() {
        std::size_t walls = 0;
        if (std::adjacent_find(edges_.begin(), edges_.end()) != edges_.end()) return "an edge is there twice";
        for (const auto& [from, to] : edges_)
            if (starts_[to] == ends_[from])
                ++walls;
            else if (!std::binary_search(edges_.begin(), edges_.end(), Edge(to, from)))
                return "an edge is no wall and has no reverse";
        return walls == starts_.size() ? "" : "a wall is no edge";
    }

    std::string fault_of_vertices() {
        for (const auto& [from, to] : edges_)
            for (const Point& vertex : starts_)
                if (is_inside_edge(vertex, starts_[from], starts_[to])) return "a vertex lies inside an edge";
        return {};
    }

    std::uint32_t first_wall_;
    std::span<const Triangle> triangles_;
    std::vector<Point> starts_, ends_;  ///< of the walls
    std::vector<Edge> edges_;           ///< of the triangles, sorted
};

}  // namespace

std::string triangle_fault(const Map& map, SectorId sector, std::span<const Triangle> triangles) {
    return Inspection(map, map[sector], triangles).fault();
}

}  // namespace enfilade::test
