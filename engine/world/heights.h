// Floors, ceilings and feet of things at this moment. The one place where the world asks for them.
#pragma once
#include "map/map.h"

namespace enfilade {

struct Heights {
    double floor_z;    ///< [m]
    double ceiling_z;  ///< [m]
};

/// Nothing moves yet: the heights at rest.
inline Heights heights_of(const Map& map, SectorId sector) { return {map[sector].floor.z, map[sector].ceiling.z}; }

/// Height of a thing's foot [m].
inline double foot_of(const Map& map, ThingId thing) { return map[thing].z; }

}  // namespace enfilade
