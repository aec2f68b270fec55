// The world at one instant, as renderers see it: plain values, nothing that ticks.
#pragma once
#include <vector>

#include "map/map.h"

namespace enfilade {

/// A sector at one instant.
struct SectorSnapshot {
    double floor_z = 0;    ///< [m]
    double ceiling_z = 0;  ///< [m]; >= floor_z
    double light = 1;      ///< 0..1
};

/// Everything that can differ from the map at rest.
struct Snapshot {
    std::vector<SectorSnapshot> sectors;  ///< indexed by SectorId
    double time_s = 0;

    const SectorSnapshot& operator[](SectorId id) const { return sectors[id.index]; }
};

/// The map at rest.
Snapshot at_rest(const Map& map);

}  // namespace enfilade
