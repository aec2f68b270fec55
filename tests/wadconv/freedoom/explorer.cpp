#include "wadconv/freedoom/explorer.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "math/grid.h"
#include "world/body.h"

namespace enfilade::test {
namespace {

constexpr int kPatience = 240;   ///< for one portal [ticks]: across a hall of 30 m at a run
constexpr int kStrayTicks = 90;  ///< of going anywhere
constexpr int kStrayTurn = 20;   ///< between turns while straying [ticks]
constexpr std::uint8_t kMaxFailures = 3;
constexpr double kBeyondPortal = 0.5;  ///< how far behind its line a portal is aimed at [m]

double headroom(const Sector& s) { return s.ceiling.z - s.floor.z; }

/// Headroom of one who stands in the portal [m].
double opening(const Map& map, const Wall& portal) {
    const Sector &here = map[portal.sector], &behind = map[portal.behind];
    return std::min(here.ceiling.z, behind.ceiling.z) - std::max(here.floor.z, behind.floor.z);
}

bool is_walkable(const Map& map, const Wall& wall) {
    return wall.kind == WallKind::portal && !wall.blocks &&
           is_at_most(map[wall.behind].floor.z - map[wall.sector].floor.z, kMaxStep) &&
           is_at_most(kCrouchedHeight, opening(map, wall)) && is_at_most(kCrouchedHeight, headroom(map[wall.behind]));
}

using MayUse = std::function<bool(std::uint32_t wall)>;

/// Breadth first: by sector, the portal it was first reached through; `order` is the order in which they were.
struct Search {
    std::vector<WallId> through;
    std::vector<std::uint32_t> order;
};

Search search_from(const Map& map, SectorId start, const MayUse& may_use) {
    Search search{std::vector<WallId>(map.sectors.size()), {start.index}};
    std::vector<bool> seen(map.sectors.size());
    seen[start.index] = true;
    for (std::size_t i = 0; i < search.order.size(); ++i) {
        const Sector& sector = map.sectors[search.order[i]];
        for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
            const Wall& wall = map.walls[w];
            if (!is_walkable(map, wall) || seen[wall.behind.index] || !may_use(w)) continue;
            seen[wall.behind.index] = true;
            search.through[wall.behind.index] = WallId(std::size_t{w});
            search.order.push_back(wall.behind.index);
        }
    }
    return search;
}

}  // namespace

std::vector<bool> walkable_from(const Map& map, SectorId start) {
    std::vector<bool> reached(map.sectors.size());
    for (std::uint32_t s : search_from(map, start, [](std::uint32_t) { return true; }).order) reached[s] = true;
    return reached;
}

std::string ranges_text(const std::vector<bool>& marked) {
    std::string text;
    for (std::size_t begin = 0, end = 0; begin < marked.size(); begin = end + 1) {
        for (end = begin; end < marked.size() && marked[end];) ++end;
        if (end == begin) continue;
        text += (text.empty() ? "" : " ") + std::to_string(begin);
        if (end - begin > 1) text += "-" + std::to_string(end - 1);
    }
    return text;
}

Explorer::Explorer(const Map& map, std::uint64_t seed)
    : map_(map), random_(seed), visited_(map.sectors.size()), failures_(map.walls.size()) {}

std::size_t Explorer::visited_count() const { return static_cast<std::size_t>(std::ranges::count(visited_, true)); }

TickInput Explorer::next(const World& world) {
    const SectorId here = world.player.place.sector;
    if (!visited_[here.index]) patience_ = kPatience;
    visited_[here.index] = true;
    if (straying_ > 0) return stray();
    follow_plan(here);
    if (--patience_ <= 0 && !plan_.empty()) give_up(here);
    return plan_.empty() || straying_ > 0 ? stray() : walk_to_portal(world.player);
}

/// Takes off what has been passed; makes a new plan where the old one is done or was left. Patience comes back only
/// with new sights: who wavers between two sectors gets nowhere, too.
void Explorer::follow_plan(SectorId here) {
    if (!plan_.empty() && map_[plan_.front()].behind == here) plan_.pop_front();
    if (plan_.empty() || map_[plan_.front()].sector != here) plan_from(here);
}

void Explorer::plan_from(SectorId here) {
    const Search search = search_from(map_, here, [&](std::uint32_t w) { return failures_[w] < kMaxFailures; });
    const auto unseen = std::ranges::find_if(search.order, [&](std::uint32_t s) { return !visited_[s]; });
    std::uint32_t goal = unseen != search.order.end() ? *unseen : search.order[random_.below(search.order.size())];
    plan_.clear();
    while (goal != here.index) {
        plan_.push_front(search.through[goal]);
        goal = map_[search.through[goal]].sector.index;
    }
    if (plan_.empty()) straying_ = kStrayTicks;
}

void Explorer::give_up(SectorId here) {
    ++failures_[plan_.front().index];
    straying_ = kStrayTicks;
    patience_ = kPatience;
    // Nothing is left that may still be tried: forgive everything.
    if (search_from(map_, here, [&](std::uint32_t w) { return failures_[w] < kMaxFailures; }).order.size() == 1)
        std::ranges::fill(failures_, std::uint8_t{0});
    plan_.clear();
}

TickInput Explorer::stray() {
    if (straying_-- % kStrayTurn == 0) {
        stray_keys_ = {.forward = 127, .yaw_steps = static_cast<std::int32_t>(random_.bits()) / kStrayTurn};
        if (random_.below(3) == 0) stray_keys_.buttons = kButtonCrouch;
    }
    return stray_keys_;
}

TickInput Explorer::walk_to_portal(const Player& player) const {
    const Wall& portal = map_[plan_.front()];
    const Vec2 along = portal.b - portal.a;
    // The sector lies on the wall's right; what is behind it on the left.
    const Vec2 behind = Vec2{along.y, -along.x} * (kBeyondPortal / portal.length);
    const Vec2 target = (portal.a + portal.b) * 0.5 + behind;
    TickInput keys{.forward = 127, .buttons = kButtonRun};
    keys.yaw_steps = static_cast<std::int32_t>((angle_of(target - player.place.point) - player.yaw).steps);
    if (std::min(opening(map_, portal), headroom(map_[portal.behind])) < kStandingHeight) keys.buttons = kButtonCrouch;
    return keys;
}

}  // namespace enfilade::test
