#include "space/triangulate.h"

#include <algorithm>
#include <cstddef>

#include "base/check.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

/// A corner of a ring: the sector lies on the right of the way from one node to the next.
struct Node {
    Vec2 p;
    WallId wall;
    std::size_t previous, next;
};

bool is_before(Vec2 p, Vec2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

bool is_between(Vec2 p, Vec2 a, Vec2 b) { return p != a && p != b && corner(a, b, p) == 0 && dot(p - a, p - b) < 0; }

bool cross_properly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return corner(a, b, c) * corner(a, b, d) < 0 && corner(c, d, a) * corner(c, d, b) < 0;
}

bool is_in_triangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
    return corner(a, b, p) >= 0 && corner(b, c, p) >= 0 && corner(c, a, p) >= 0;
}

class Triangulator {
public:
    Triangulator(const Map& map, SectorId sector) : map_(map) { make_rings(map[sector]); }

    std::vector<Triangle> run() {
        join_holes();
        for (const std::size_t outline : outlines_) cut_ears(outline);
        return std::move(triangles_);
    }

private:
    /// Walls become nodes of the same order; each ring is an outline or a hole, known by its first node from the left.
    void make_rings(const Sector& sector) {
        for (std::uint32_t i = 0; i < sector.wall_count; ++i) {
            const WallId id(sector.first_wall + i);
            const Wall& wall = map_[id];
            nodes_.push_back(
                {wall.a, id, wall.previous.index - sector.first_wall, wall.next.index - sector.first_wall});
        }
        std::vector<char> seen(nodes_.size(), 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (seen[i]) continue;
            std::size_t first = i;
            for (std::size_t n = i; !seen[n]; n = nodes_[n].next) {
                seen[n] = 1;
                if (is_before(nodes_[n].p, nodes_[first].p)) first = n;
            }
            (turn_at(first) > 0 ? outlines_ : holes_).push_back(first);
        }
    }

    Vec2 before(std::size_t n) const { return nodes_[nodes_[n].previous].p; }
    Vec2 after(std::size_t n) const { return nodes_[nodes_[n].next].p; }
    int turn_at(std::size_t n) const { return corner(before(n), nodes_[n].p, after(n)); }

    /// From the left, so that whatever a hole can see to its left is part of an outline by then.
    void join_holes() {
        std::sort(holes_.begin(), holes_.end(),
                  [&](std::size_t a, std::size_t b) { return is_before(nodes_[a].p, nodes_[b].p); });
        std::vector<std::size_t> joined;
        for (const std::size_t outline : outlines_) add_ring(joined, outline);
        for (const std::size_t hole : holes_) {
            const std::size_t node = visible_from(hole, joined);
            add_ring(joined, hole);
            join(node, hole, joined);
        }
    }

    void add_ring(std::vector<std::size_t>& nodes, std::size_t first) const {
        std::size_t n = first;
        do nodes.push_back(n);
        while ((n = nodes_[n].next) != first);
    }

    /// The nearest of the nodes that the hole's first node sees, or touches, to its left.
    std::size_t visible_from(std::size_t hole, const std::vector<std::size_t>& joined) const {
        const Vec2 p = nodes_[hole].p;
        std::vector<std::size_t> candidates;
        for (const std::size_t n : joined)
            if (!is_before(p, nodes_[n].p)) candidates.push_back(n);
        const auto distance = [&](std::size_t n) { return dot(nodes_[n].p - p, nodes_[n].p - p); };
        std::stable_sort(candidates.begin(), candidates.end(),
                         [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
        const auto sees = [&](std::size_t n) {
            if (nodes_[n].p == p) return is_inside_corner(n, after(hole));
            return is_inside_corner(n, p) && is_free(nodes_[n].p, p);
        };
        const auto found = std::find_if(candidates.begin(), candidates.end(), sees);
        ENFILADE_CHECK(found != candidates.end());  // checked on load: a hole is inside an outline
        return *found;
    }

    /// Does the way from the node to q begin inside the sector?
    bool is_inside_corner(std::size_t n, Vec2 q) const {
        const bool right_of_way_in = corner(before(n), nodes_[n].p, q) > 0;
        const bool right_of_way_out = corner(nodes_[n].p, after(n), q) > 0;
        return turn_at(n) > 0 ? right_of_way_in && right_of_way_out : right_of_way_in || right_of_way_out;
    }

    bool is_free(Vec2 a, Vec2 b) const {
        return std::none_of(nodes_.begin(), nodes_.end(), [&](const Node& n) {
            return is_between(n.p, a, b) || cross_properly(a, b, n.p, nodes_[n.next].p);
        });
    }

    void link(std::size_t from, std::size_t to) {
        nodes_[from].next = to;
        nodes_[to].previous = from;
    }

    /// Makes one ring of two: node, the hole from its first node around to it again, node again.
    void join(std::size_t node, std::size_t hole, std::vector<std::size_t>& joined) {
        const std::size_t after_node = nodes_[node].next;
        if (nodes_[node].p == nodes_[hole].p) {
            link(node, nodes_[hole].next);
            link(hole, after_node);
            return;
        }
        const std::size_t hole_again = nodes_.size(), node_again = hole_again + 1;
        const std::size_t end_of_hole = nodes_[hole].previous;
        nodes_.push_back(nodes_[hole]);
        nodes_.push_back(nodes_[node]);
        link(node, hole);
        link(end_of_hole, hole_again);
        link(hole_again, node_again);
        link(node_again, after_node);
        joined.insert(joined.end(), {hole_again, node_again});
    }

    void cut_ears(std::size_t start) {
        std::size_t n = start, left = 0, tried = 0;
        do ++left;
        while ((n = nodes_[n].next) != start);
        while (left > 2) {
            ENFILADE_CHECK(tried <= left);  // a ring that encloses ground has an ear
            const std::size_t previous = nodes_[n].previous, next = nodes_[n].next;
            if (nodes_[previous].p == nodes_[next].p) {  // there and back: encloses nothing
                link(previous, nodes_[next].next);
                left -= 2;
                tried = 0;
                n = previous;
            } else if (is_ear(n)) {
                triangles_.push_back({nodes_[previous].wall, nodes_[n].wall, nodes_[next].wall});
                link(previous, next);
                --left;
                tried = 0;
                n = next;  // going on, not back, keeps the triangles from becoming a fan of slivers
            } else {
                ++tried;
                n = next;
            }
        }
    }

    bool is_ear(std::size_t n) const {
        if (turn_at(n) <= 0) return false;
        const std::size_t previous = nodes_[n].previous, next = nodes_[n].next;
        for (std::size_t other = nodes_[next].next; other != previous; other = nodes_[other].next)
            if (is_in_the_way(other, n)) return false;
        return true;
    }

    /// A vertex inside the ear, or at its tip with a wall that runs into it. What is at its two other corners is not:
    /// a wall from there into the ear has its other end in the ear.
    bool is_in_the_way(std::size_t other, std::size_t n) const {
        const Vec2 a = before(n), tip = nodes_[n].p, b = after(n), p = nodes_[other].p;
        if (p == a || p == b) return false;
        const auto runs_into = [&](Vec2 q) { return corner(a, tip, q) > 0 && corner(tip, b, q) > 0; };
        if (p == tip) return runs_into(before(other)) || runs_into(after(other));
        return is_in_triangle(p, a, tip, b);
    }

    const Map& map_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> outlines_, holes_;  ///< first nodes
    std::vector<Triangle> triangles_;
};

}  // namespace

std::vector<Triangle> triangulate(const Map& map, SectorId sector) { return Triangulator(map, sector).run(); }

}  // namespace enfilade
