// Which solid things a body may touch, by the sector that its middle is in: worked out once, from the things, so that
// nobody who moves has to look for them. A wide thing among a thousand narrow rooms would else take each step of a walk
// through all of them.
#include <algorithm>
#include <vector>

#include "map/draft.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

/// Rooms that one thing is told for; as many as a body reaches (space/reach.h).
constexpr std::size_t kMostRooms = 1024;

/// Links one behind the other through which a thing is told. Around a point where links meet at a small angle there is
/// no end of them; who comes nearer passes some, and is then told of it.
constexpr int kMostLinksInARow = 16;

/// Two ways that put a thing this near to the same place are one: links that were made to agree differ by rounding [m].
constexpr double kSamePlace = 0x1p-16;

/// What all things together may cost: a quarter of a second, hundreds of times as much as any honest map needs [walls
/// looked at, and rooms compared]. Once it is spent, things are told for their own sectors only: bodies come as near to
/// them as the doorway lets their middles.
constexpr std::size_t kMostSteps = std::size_t{1} << 26;

/// What links may round away [m].
constexpr double kSlack = 16 * kPointGrid;

/// A sector with a thing near it.
struct NearRoom {
    SectorId sector;
    Rigid passage;  ///< from its space into that of the thing
    Vec2 thing;     ///< where that is, in the space of the sector
    int links = 0;  ///< passed from there to the thing
};

/// The portals by which one comes out of each wall; also one-way portals, to which the wall itself does not lead back.
class WaysIn {
public:
    explicit WaysIn(const Map& map) : first_(map.walls.size() + 1) {
        for (const Wall& wall : map.walls)
            if (wall.kind == WallKind::portal) ++first_[wall.exit.index + 1];
        for (std::size_t i = 0; i < map.walls.size(); ++i) first_[i + 1] += first_[i];
        portals_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < map.walls.size(); ++i)
            if (map.walls[i].kind == WallKind::portal) portals_[next[map.walls[i].exit.index]++] = WallId(i);
    }

    std::span<const WallId> into(WallId exit) const {
        return std::span(portals_).subspan(first_[exit.index], first_[exit.index + 1] - first_[exit.index]);
    }

private:
    std::vector<std::uint32_t> first_;
    std::vector<WallId> portals_;
};

class NearThings {
public:
    explicit NearThings(const Map& map) : map_(map), ways_in_(map) {}

    /// The rooms near the thing, its own first. Valid until the next call.
    std::span<const NearRoom> rooms_near(ThingId id) {
        const Thing& thing = map_[id];
        radius_ = snap_to_point_grid(thing.radius + kWidestBody + kSlack);
        rooms_.assign(1, {thing.sector, {}, thing.position});
        for (std::size_t i = 0; i < rooms_.size() && steps_ < kMostSteps; ++i) {
            const NearRoom room = rooms_[i];
            const Sector& sector = map_[room.sector];
            steps_ += sector.wall_count;
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
                if (is_near(map_.walls[w], room.thing)) go_back_through(room, WallId(w));
        }
        return rooms_;
    }

private:
    bool is_near(const Wall& wall, Vec2 p) const {
        const bool is_in_box =
            std::max(wall.a.x, wall.b.x) > p.x - radius_ && std::min(wall.a.x, wall.b.x) < p.x + radius_ &&
            std::max(wall.a.y, wall.b.y) > p.y - radius_ && std::min(wall.a.y, wall.b.y) < p.y + radius_;
        return is_in_box && segment_is_nearer(wall.a, wall.b, p, radius_) &&
               (side_of_line(wall.a, wall.b, p) > 0 || segment_is_nearer(wall.a, wall.b, p, kSlack));
    }

    /// Into the rooms from which one comes out of the wall.
    void go_back_through(const NearRoom& room, WallId exit) {
        for (const WallId id : ways_in_.into(exit)) {
            const Wall& portal = map_[id];
            NearRoom next{portal.sector, room.passage, room.thing, room.links};
            if (portal.link != Wall::kNoLink) {
                if (++next.links > kMostLinksInARow) continue;
                const Rigid passage = map_.passage(portal);
                next.passage = then(passage, room.passage);
                next.thing = snap_to_point_grid(inverse(passage).apply(room.thing));
            }
            add(next);
        }
    }

    void add(const NearRoom& next) {
        if (rooms_.size() >= kMostRooms) return;
        steps_ += rooms_.size();
        const auto is_it = [&](const NearRoom& r) { return are_same(r, next); };
        if (std::ranges::none_of(rooms_, is_it)) rooms_.push_back(next);
    }

    static bool are_same(const NearRoom& a, const NearRoom& b) {
        const Vec2 apart = a.thing - b.thing;
        return a.sector == b.sector && a.passage.rise == b.passage.rise && dot(apart, apart) < kSamePlace * kSamePlace;
    }

    const Map& map_;
    WaysIn ways_in_;
    double radius_ = 0;
    std::vector<NearRoom> rooms_;
    std::size_t steps_ = 0;
};

struct FoundThing {
    SectorId sector;
    NearThing thing;
};

}  // namespace

void list_near_things(Map& map) {
    map.near_things.clear();
    map.first_near.clear();
    if (map.solid_things.empty()) return;
    std::vector<FoundThing> found;
    NearThings near(map);
    for (const ThingId id : map.solid_things)
        for (const NearRoom& room : near.rooms_near(id)) found.push_back({room.sector, {id, room.passage}});
    std::ranges::stable_sort(found, {}, &FoundThing::sector);
    map.first_near.assign(map.sectors.size() + 1, 0);
    for (const FoundThing& f : found) {
        map.near_things.push_back(f.thing);
        ++map.first_near[f.sector.index + 1];
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) map.first_near[i + 1] += map.first_near[i];
}

}  // namespace enfilade
