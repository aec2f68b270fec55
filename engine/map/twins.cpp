#include "map/twins.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// Linear searches are for findings only; a hostile file must not make them quadratic [walls looked at, about 0.1 s].
constexpr std::size_t kSearchBudget = 20'000'000;

auto key(const Wall& w) { return std::tuple(w.a.x, w.a.y, w.b.x, w.b.y); }

/// The square of how far the ends of w are from b -> a, the larger of the two.
double distance(const Wall& w, Vec2 a, Vec2 b) {
    const Vec2 from_b = w.a - b, from_a = w.b - a;
    return std::max(dot(from_b, from_b), dot(from_a, from_a));
}

/// True where v lies between the ends of w, which is on a line with it.
bool spans(const Wall& w, Vec2 v) {
    return std::min(w.a.x, w.b.x) <= v.x && v.x <= std::max(w.a.x, w.b.x) && std::min(w.a.y, w.b.y) <= v.y &&
           v.y <= std::max(w.a.y, w.b.y);
}

}  // namespace

TwinIndex::TwinIndex(const Map& map) : map_(map), order_(map.walls.size()), steps_left_(kSearchBudget) {
    std::iota(order_.begin(), order_.end(), 0u);
    for (const Sector& s : map.sectors)
        std::sort(order_.begin() + s.first_wall, order_.begin() + s.first_wall + s.wall_count,
                  [&](std::uint32_t i, std::uint32_t j) {
                      return std::tuple(key(map.walls[i]), i) < std::tuple(key(map.walls[j]), j);
                  });
}

WallId TwinIndex::find(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    const auto begin = order_.begin() + s.first_wall, end = begin + s.wall_count;
    const auto wanted = std::tuple(b.x, b.y, a.x, a.y);
    const auto it = std::lower_bound(begin, end, wanted,
                                     [&](std::uint32_t i, const auto& ends) { return key(map_.walls[i]) < ends; });
    return it != end && key(map_.walls[*it]) == wanted ? WallId(*it) : WallId();
}

bool TwinIndex::may_search(std::size_t count) const {
    if (count > steps_left_) return false;
    steps_left_ -= count;
    return true;
}

WallId TwinIndex::covering(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    if (!may_search(s.wall_count)) return {};
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& w = map_.walls[i];
        const bool is_on_line = w.a != w.b && corner(w.a, w.b, a) == 0 && corner(w.a, w.b, b) == 0;
        if (is_on_line && dot(w.b - w.a, b - a) < 0 && spans(w, a) && spans(w, b)) return WallId(i);
    }
    return {};
}

WallId TwinIndex::nearest(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    if (s.wall_count == 0 || !may_search(s.wall_count)) return {};
    std::uint32_t best = s.first_wall;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (distance(map_.walls[i], a, b) < distance(map_.walls[best], a, b)) best = i;
    return WallId(best);
}

}  // namespace enfilade
