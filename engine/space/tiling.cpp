#include "space/tiling.h"

#include <algorithm>
#include <tuple>

#include "base/result.h"
#include "math/predicates.h"
#include "space/triangulate.h"

namespace enfilade {
namespace {

/// An edge that runs through the room, by the corners it runs between: they are the same walls for both its tiles.
struct InnerEdge {
    WallId from, to;
    std::uint32_t number;
};

bool is_before(const InnerEdge& s, const InnerEdge& t) { return std::tie(s.from, s.to) < std::tie(t.from, t.to); }

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

}  // namespace enfilade
