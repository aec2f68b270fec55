#include "map/sector_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kLeafSize = 8;  ///< fewer sectors than this are looked at one by one

}  // namespace

SectorFinder::SectorFinder(const Map& map, std::vector<std::uint32_t> sectors)
    : map_(map), sectors_(std::move(sectors)) {
    if (!sectors_.empty()) build(0, static_cast<std::uint32_t>(sectors_.size()), true);
}

std::uint32_t SectorFinder::build(std::uint32_t begin, std::uint32_t end, bool along_x) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    TreeNode node{map_.sectors[sectors_[begin]].min, map_.sectors[sectors_[begin]].max, begin, end, 0};
    for (std::uint32_t i = begin; i < end; ++i) {
        const Sector& s = map_.sectors[sectors_[i]];
        node.min = {std::min(node.min.x, s.min.x), std::min(node.min.y, s.min.y)};
        node.max = {std::max(node.max.x, s.max.x), std::max(node.max.y, s.max.y)};
    }
    nodes_.push_back(node);
    if (end - begin <= kLeafSize) return index;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto doubled_centre = [&](std::uint32_t i) {
        const Sector& s = map_.sectors[i];
        return along_x ? s.min.x + s.max.x : s.min.y + s.max.y;
    };
    std::nth_element(sectors_.begin() + begin, sectors_.begin() + middle, sectors_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) { return doubled_centre(i) < doubled_centre(j); });
    build(begin, middle, !along_x);
    nodes_[index].right = build(middle, end, !along_x);
    return index;
}

SectorId SectorFinder::around(Vec2 p) const {
    SectorId best;
    if (!nodes_.empty()) search(0, p, best);
    return best;
}

void SectorFinder::search(std::uint32_t node, Vec2 p, SectorId& best) const {
    const TreeNode& n = nodes_[node];
    if (p.x < n.min.x || p.x > n.max.x || p.y < n.min.y || p.y > n.max.y) return;
    if (n.right != 0) {
        search(node + 1, p, best);
        search(n.right, p, best);
        return;
    }
    for (std::uint32_t i = n.begin; i < n.end; ++i)
        if (sectors_[i] < best.index && is_inside(map_, SectorId(sectors_[i]), p)) best = SectorId(sectors_[i]);
}

namespace {

/// 1 where the half line from p along +x, moved by the tie rule, crosses an a -> b that runs towards +y, -1 where it
/// crosses one that runs towards -y, 0 where it misses. p counts as p + (e, e^2): a vertex at p's height lies above
/// it on the drawing.
int winding_step(const Wall& w, Vec2 p) {
    const bool a_beyond = w.a.y > p.y, b_beyond = w.b.y > p.y;
    if (a_beyond == b_beyond) return 0;
    if (b_beyond) return side_of_line(w.a, w.b, p) > 0 ? 1 : 0;
    return side_of_line(w.a, w.b, p) < 0 ? -1 : 0;
}

}  // namespace

bool is_inside(std::span<const Wall> walls, Vec2 p) {
    int winding = 0;
    for (const Wall& w : walls) winding += winding_step(w, p);
    return winding != 0;
}

bool is_inside(const Map& map, SectorId sector, Vec2 p) {
    const Sector& s = map[sector];
    if (p.x < s.min.x || p.x > s.max.x || p.y < s.min.y || p.y > s.max.y) return false;
    return is_inside(std::span(map.walls).subspan(s.first_wall, s.wall_count), p);
}

SectorId sector_named(const Map& map, std::string_view name) {
    const auto found = std::ranges::find(map.sectors, name, &Sector::name);
    return found == map.sectors.end() ? SectorId{} : SectorId(static_cast<std::size_t>(found - map.sectors.begin()));
}

void settle_shape(Map& map, SectorId id) {
    Sector& sector = map.sectors[id.index];
    sector.min = {kWorldLimit, kWorldLimit};
    sector.max = {-kWorldLimit, -kWorldLimit};
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        Wall& wall = map.walls[i];
        Wall& next = map.walls[wall.next.index];
        wall.sector = id;
        wall.b = next.a;
        wall.length = std::sqrt(dot(wall.b - wall.a, wall.b - wall.a));
        next.previous = WallId(i);
        sector.min = {std::min(sector.min.x, wall.a.x), std::min(sector.min.y, wall.a.y)};
        sector.max = {std::max(sector.max.x, wall.a.x), std::max(sector.max.y, wall.a.y)};
    }
}

void settle_length(Panel& panel) { panel.length = std::sqrt(dot(panel.b - panel.a, panel.b - panel.a)); }

void settle_grid_link(Map& map, const Wall& wall) {
    if (wall.link == Wall::kNoLink) return;
    map.grid_links.resize(map.links.size());
    if (wall.kind == WallKind::mirror) return;  // nobody passes
    const Wall& exit = map[wall.exit];
    map.grid_links[wall.link] = GridMap(map.links[wall.link], (wall.a + wall.b) * 0.5, (exit.a + exit.b) * 0.5);
}

}  // namespace enfilade
