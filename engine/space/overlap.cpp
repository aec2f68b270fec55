#include "space/overlap.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "math/predicates.h"
#include "space/triangulate.h"

namespace enfilade {
namespace {

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

std::vector<char> overlapping_sectors(const Map& map) { return Overlaps(map).run(); }

}  // namespace enfilade
