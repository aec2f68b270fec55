#include "space/triangulate.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/result.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

/// An edge that runs through the room, by the corners it runs between: they are the same walls for both its tiles.
struct InnerEdge {
    WallId from, to;
    std::uint32_t number;
};

bool is_before(const InnerEdge& s, const InnerEdge& t) { return std::tie(s.from, s.to) < std::tie(t.from, t.to); }

/// More walls than this are not cut into triangles.
constexpr std::uint32_t kMostWalls = 4096;

/// Sets of sectors joined by doorways (disjoint sets, with paths halved).
class Spaces {
public:
    explicit Spaces(const Map& map) : parent_(map.sectors.size()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (const Wall& wall : map.walls)
            if (wall.kind == WallKind::portal && wall.link == Wall::kNoLink)
                parent_[root(wall.sector.index)] = root(wall.behind.index);
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

private:
    std::vector<std::uint32_t> parent_;
};

struct Corners {
    Vec2 a, b, c;
};

/// Is all of t on the left of a -> b, or on the line?
bool is_left(Vec2 a, Vec2 b, const Corners& t) {
    return corner(a, b, t.a) <= 0 && corner(a, b, t.b) <= 0 && corner(a, b, t.c) <= 0;
}

/// Do an edge of s and its line keep the two apart?
bool separates(const Corners& s, const Corners& t) {
    return is_left(s.a, s.b, t) || is_left(s.b, s.c, t) || is_left(s.c, s.a, t);
}

class Overlaps {
public:
    explicit Overlaps(const Map& map)
        : map_(map), spaces_(map), result_(map.sectors.size(), 0), triangles_(map.sectors.size()) {}

    std::vector<char> run() {
        std::vector<std::uint32_t> by_left(map_.sectors.size()), open;
        std::iota(by_left.begin(), by_left.end(), 0u);
        std::sort(by_left.begin(), by_left.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return map_.sectors[a].min.x < map_.sectors[b].min.x; });
        for (const std::uint32_t i : by_left) {
            std::erase_if(open, [&](std::uint32_t o) { return map_.sectors[o].max.x <= map_.sectors[i].min.x; });
            for (const std::uint32_t o : open) look_at(i, o);
            open.push_back(i);
        }
        return std::move(result_);
    }

private:
    void look_at(std::uint32_t i, std::uint32_t o) {
        const Sector &a = map_.sectors[i], &b = map_.sectors[o];
        if (a.min.y >= b.max.y || b.min.y >= a.max.y || (result_[i] && result_[o])) return;
        if (spaces_.root(i) == spaces_.root(o) && overlap(i, o)) result_[i] = result_[o] = 1;
    }

    bool overlap(std::uint32_t i, std::uint32_t o) {
        if (std::max(map_.sectors[i].wall_count, map_.sectors[o].wall_count) > kMostWalls) return true;
        const std::vector<Corners>&ours = triangles(i), &theirs = triangles(o);
        return std::any_of(ours.begin(), ours.end(), [&](const Corners& s) {
            return std::any_of(theirs.begin(), theirs.end(),
                               [&](const Corners& t) { return !separates(s, t) && !separates(t, s); });
        });
    }

    const std::vector<Corners>& triangles(std::uint32_t sector) {
        std::optional<std::vector<Corners>>& known = triangles_[sector];
        if (known) return *known;
        known.emplace();
        for (const Triangle& t : triangulate(map_, SectorId(sector)))
            known->push_back({map_[t[0]].a, map_[t[1]].a, map_[t[2]].a});
        return *known;
    }

    const Map& map_;
    Spaces spaces_;
    std::vector<char> result_;
    std::vector<std::optional<std::vector<Corners>>> triangles_;  ///< by sector, where they were asked for
};

}  // namespace

Tiling::Tiling(const Map& map) : edge_of_wall_(map.walls.size(), kNone), first_(1, 0) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i) add_sector(map, SectorId(i));
    group_walls(map);
}

void Tiling::add_sector(const Map& map, SectorId sector) {
    const auto begin = static_cast<std::uint32_t>(corners_.size());
    for (const Triangle& triangle : triangulate(map, sector))
        corners_.insert(corners_.end(), triangle.begin(), triangle.end());
    walls_.resize(corners_.size());
    across_.resize(corners_.size(), kNone);
    join_edges(map, begin);
    first_.push_back(tile_count());
}

void Tiling::join_edges(const Map& map, std::uint32_t begin) {
    std::vector<InnerEdge> inner;
    for (std::uint32_t e = begin; e < corners_.size(); ++e) {
        const WallId from = corners_[e], to = corners_[next_edge(e)];
        if (map[from].b == map[to].a) {
            walls_[e] = from;
            edge_of_wall_[from.index] = e;
        } else {
            inner.push_back({from, to, e});
        }
    }
    std::sort(inner.begin(), inner.end(), is_before);
    for (const InnerEdge& edge : inner) {
        const InnerEdge reverse{edge.to, edge.from, 0};
        const auto other = std::lower_bound(inner.begin(), inner.end(), reverse, is_before);
        ENFILADE_CHECK(other != inner.end() && !is_before(reverse, *other));  // triangles cover without gaps
        across_[edge.number] = other->number;
    }
}

void Tiling::group_walls(const Map& map) {
    for (std::size_t i = 0; i < map.walls.size(); ++i) by_place_.emplace_back(i);
    const auto key = [&](WallId id) { return std::pair(map[id].a.x, map[id].a.y); };
    std::stable_sort(by_place_.begin(), by_place_.end(), [&](WallId s, WallId t) { return key(s) < key(t); });
    place_.resize(map.walls.size());
    for (std::uint32_t i = 0; i < by_place_.size(); ++i) {
        if (i == 0 || key(by_place_[i]) != key(by_place_[i - 1])) places_first_.push_back(i);
        place_[by_place_[i].index] = static_cast<std::uint32_t>(places_first_.size() - 1);
    }
    places_first_.push_back(static_cast<std::uint32_t>(by_place_.size()));
}

std::span<const WallId> Tiling::around(WallId wall) const {
    const std::uint32_t place = place_[wall.index];
    return std::span(by_place_).subspan(places_first_[place], places_first_[place + 1] - places_first_[place]);
}

std::uint32_t Tiling::find(const Map& map, SectorId sector, Vec2 p, std::uint32_t first) const {
    const auto is_right_of = [&](std::uint32_t edge) {
        return exact_cross(map[corners_[edge]].a, map[corners_[next_edge(edge)]].a, p) >= 0;
    };
    for (std::uint32_t t = std::max(first, first_[sector.index]); t < first_[sector.index + 1]; ++t)
        if (is_right_of(3 * t) && is_right_of(3 * t + 1) && is_right_of(3 * t + 2)) return t;
    return kNone;
}

std::vector<char> overlapping_sectors(const Map& map) { return Overlaps(map).run(); }

}  // namespace enfilade
