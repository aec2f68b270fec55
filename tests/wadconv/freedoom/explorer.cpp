#include "wadconv/freedoom/explorer.h"

#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "world/body.h"

namespace enfilade::test {
namespace {

constexpr int kPatience = 60;    ///< for one point of the way [ticks]
constexpr int kStrayTicks = 40;  ///< of going anywhere
constexpr int kStrayTurn = 20;   ///< between turns while straying [ticks]
constexpr std::uint8_t kMaxTries = 4;
constexpr double kNear = 0.4;             ///< who is so near to a point has passed it [m]
constexpr double kLost = 1.25;            ///< who is so far from the next point has left the way [m]
constexpr std::size_t kAim = 2;           ///< how far ahead it looks where it walks [points]
constexpr std::size_t kRunAhead = 6;      ///< how much of the way has to be straight for a run [points]
constexpr double kStraightCosine = 0.95;  ///< of the bend that is still straight [1]

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

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

}  // namespace

std::vector<bool> walkable_from(const Map& map, SectorId start) {
    std::vector<bool> reached(map.sectors.size());
    std::vector<std::uint32_t> order{start.index};
    reached[start.index] = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Sector& sector = map.sectors[order[i]];
        for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
            const Wall& wall = map.walls[w];
            if (!is_walkable(map, wall) || reached[wall.behind.index]) continue;
            reached[wall.behind.index] = true;
            order.push_back(wall.behind.index);
        }
    }
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
    : map_(map), random_(seed), grid_(map), visited_(map.sectors.size()), tries_(map.sectors.size()) {}

std::size_t Explorer::visited_count() const { return static_cast<std::size_t>(std::ranges::count(visited_, true)); }

std::vector<bool> Explorer::in_reach(const Player& player) {
    std::vector<bool> reached(map_.sectors.size());
    const auto mark = [&](SectorId sector) {
        reached[sector.index] = true;
        return false;
    };
    if (const auto start = grid_.point_near(body_of(map_, player))) grid_.way_to(*start, mark);
    return reached;
}

TickInput Explorer::next(const World& world) {
    look_around(world.player);
    if (straying_ > 0) return stray();
    follow(world.player);
    if (way_.empty()) plan(world.player);
    return straying_ > 0 ? stray() : walk(world.player);
}

/// Notes the sector it is in, and those it passed over in the last tick.
void Explorer::look_around(const Player& player) {
    if (last_.sector)
        for (const Crossing& crossing : trace(map_, last_, player.place.point).crossings)
            visited_[map_[crossing.portal].behind.index] = true;
    last_ = player.place;
    visited_[last_.sector.index] = true;
}

/// Sets out for the nearest sector that is still to be seen; where there is none, for anywhere.
void Explorer::plan(const Player& player) {
    at_ = 0;
    patience_ = kPatience;
    const auto start = grid_.point_near(body_of(map_, player));
    if (!start) return give_up();
    std::vector<std::uint32_t> reached;
    goal_ = {};
    const auto is_wanted = [&](SectorId sector) {
        if (visited_[sector.index] || tries_[sector.index] >= kMaxTries) return false;
        goal_ = sector;
        return true;
    };
    // Who drops into a pit first sees nothing else any more.
    way_ = grid_.way_to(*start, is_wanted, Drops::avoided);
    if (way_.empty()) way_ = grid_.way_to(*start, is_wanted, Drops::taken, &reached);
    if (goal_) ++tries_[goal_.index];
    if (way_.empty()) way_ = grid_.way_back(reached[random_.below(reached.size())]);
    if (way_.size() == 1) give_up();
}

void Explorer::give_up() {
    way_.clear();
    straying_ = kStrayTicks;
}

/// Takes off what has been passed, and the whole way where its end is reached, its goal seen, or it was left.
void Explorer::follow(const Player& player) {
    const auto distance = [&] { return length(grid_[way_[at_]].place.point - player.place.point); };
    // The last point is where the goal begins; only who has been in it is done.
    while (at_ + (goal_ ? 1 : 0) < way_.size() && distance() < kNear) {
        ++at_;
        patience_ = kPatience;
    }
    if (at_ >= way_.size() || (goal_ && visited_[goal_.index]) || distance() > kLost) return way_.clear();
    if (--patience_ > 0) return;
    if (at_ > 0 && at_ < way_.size()) grid_.close(way_[at_ - 1], way_[at_]);
    give_up();
}

TickInput Explorer::stray() {
    if (straying_-- % kStrayTurn == 0) {
        stray_keys_ = {.forward = 127, .yaw_steps = static_cast<std::int32_t>(random_.bits()) / kStrayTurn};
        if (random_.below(3) == 0) stray_keys_.buttons = kButtonCrouch;
    }
    return stray_keys_;
}

/// The point so many further along the way, or a bit beyond its end.
Vec2 Explorer::ahead(std::size_t points) const {
    const Vec2 end = grid_[way_.back()].place.point;
    if (at_ + points + 1 >= way_.size()) return end + (end - grid_[way_[way_.size() - 2]].place.point);
    return grid_[way_[at_ + points]].place.point;
}

bool Explorer::goes_straight(const Player& player) const {
    const Vec2 half = ahead(kRunAhead / 2) - player.place.point, all = ahead(kRunAhead) - player.place.point;
    return dot(half, all) >= kStraightCosine * length(half) * length(all);
}

bool Explorer::has_to_crouch() const {
    const std::size_t begin = at_ > 0 ? at_ - 1 : 0, end = std::min(at_ + kRunAhead, way_.size());
    return std::any_of(way_.begin() + static_cast<std::ptrdiff_t>(begin),
                       way_.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](std::uint32_t point) { return grid_[point].is_low(); });
}

TickInput Explorer::walk(const Player& player) const {
    const Vec2 target = ahead(grid_[way_[at_]].is_free() ? kAim : 0);
    TickInput keys{.forward = 127};
    keys.yaw_steps = static_cast<std::int32_t>((angle_of(target - player.place.point) - player.yaw).steps);
    if (has_to_crouch())
        keys.buttons = kButtonCrouch;
    else if (goes_straight(player))
        keys.buttons = kButtonRun;
    return keys;
}

}  // namespace enfilade::test
