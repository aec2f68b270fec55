#include "space/presence.h"

#include <algorithm>

#include "math/vec.h"
#include "space/reach.h"

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

void spread(const Map& map, ThingId id, std::vector<FoundPresence>& found) {
    const Thing& thing = map[id];
    const std::size_t begin = found.size();
    const double radius = begin < kMostPresences ? reach_of(map[thing.sprite]) : 0;
    for (const ReachedSector& reached : reach(map, {thing.sector, thing.position}, radius).sectors) {
        const Vec2 position = snap_to_point_grid(reached.passage.apply(thing.position));
        const FoundPresence next{reached.sector, {id, reached.passage, position}};
        const auto is_known = [&](const FoundPresence& other) { return is_same(next, other); };
        if (std::none_of(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), is_known))
            found.push_back(next);
    }
}

}  // namespace

Presences presences_of(const Map& map) {
    std::vector<FoundPresence> found;
    for (std::size_t i = 0; i < map.things.size(); ++i)
        if (map.things[i].sprite) spread(map, ThingId(i), found);
    Presences presences;
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
