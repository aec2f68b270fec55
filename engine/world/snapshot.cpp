#include "world/snapshot.h"

namespace enfilade {

Snapshot at_rest(const Map& map) {
    Snapshot snapshot;
    snapshot.sectors.reserve(map.sectors.size());
    for (const Sector& s : map.sectors) snapshot.sectors.push_back({s.floor.z, s.ceiling.z, s.light});
    return snapshot;
}

}  // namespace enfilade
