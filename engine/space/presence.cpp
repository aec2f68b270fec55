#include "space/reach.h"

#include <algorithm>

#include "math/vec.h"

namespace enfilade {
namespace {

/// Two ways into a sector that put a thing this near to the same place are one way: links that were made to agree
/// differ by rounding [m]. Nobody sees a shift of a hundredth of a millimetre.
constexpr double kSamePlace = 0x1p-16;

struct FoundPresence {
    SectorId sector;
    Presence presence;
};

bool is_same(const FoundPresence& a, const FoundPresence& b) {
    const Vec2 apart = a.presence.position - b.presence.position;
    return a.sector == b.sector && dot(apart, apart) < kSamePlace * kSamePlace;
}

/// Wide enough for the picture at any turn, rounded up to the grid [m].
double reach_of(const Sprite& sprite) {
    return sprite.reach_m > 0 ? snap_to_point_grid(std::min(sprite.reach_m, kWidestReach)) + kPointGrid : 0;
}

class Spreading {
public:
    explicit Spreading(const Map& map) : map_(map) {}

    void add(ThingId id) {
        const Thing& thing = map_[id];
        const std::size_t begin = found.size();
        const bool may_spread = begin < kMostPresences && steps < kMostPresenceSteps;
        const double radius = may_spread ? reach_of(map_[thing.sprite]) : 0;
        const Reach reached = reach(map_, {thing.sector, thing.position}, radius);
        steps += may_spread ? reached.walls_looked_at : 0;
        for (const ReachedSector& there : reached.sectors) {
            const Vec2 position = snap_to_point_grid(there.passage.apply(thing.position));
            add_new({there.sector, {id, there.passage, position}}, begin);
        }
    }

    std::vector<FoundPresence> found;
    std::size_t steps = 0;

private:
    /// Unless it is among those from `begin` on.
    void add_new(const FoundPresence& next, std::size_t begin) {
        steps += found.size() - begin;
        const auto is_known = [&](const FoundPresence& other) { return is_same(next, other); };
        if (std::none_of(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), is_known))
            found.push_back(next);
    }

    const Map& map_;
};

}  // namespace

Presences presences_of(const Map& map) {
    Spreading spreading(map);
    for (std::size_t i = 0; i < map.things.size(); ++i)
        if (map.things[i].sprite) spreading.add(ThingId(i));
    std::vector<FoundPresence>& found = spreading.found;
    Presences presences;
    presences.steps = spreading.steps;
    if (found.empty()) return presences;
    std::stable_sort(found.begin(), found.end(),
                     [](const FoundPresence& a, const FoundPresence& b) { return a.sector < b.sector; });
    presences.first.assign(map.sectors.size() + 1, 0);
    for (const FoundPresence& f : found) {
        presences.all.push_back(f.presence);
        ++presences.first[f.sector.index + 1];
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) presences.first[i + 1] += presences.first[i];
    return presences;
}

}  // namespace enfilade
