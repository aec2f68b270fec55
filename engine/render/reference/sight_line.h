// Straight ways of light from lamps to places: what the reference's own light goes by. They share the map and the
// predicates (math/predicates.h) with the ways of render/light_patch.h, and nothing else: no grid, no search, no path.
#pragma once
#include <cstdint>
#include <vector>

#include "map/map.h"
#include "world/snapshot.h"

namespace enfilade {

/// A lamp as one sector sees it: in its own place or, through links, somewhere else.
struct SeenLamp {
    std::uint32_t lamp = 0;  ///< index into Map::lights
    Rigid passage;           ///< from the space of the lamp's sector into that of this one
    Vec2 place;              ///< where it seems to be, on the point grid
    double z = 0;            ///< [m]
};

/// Most looks into rooms for one lamp: what folds space so often that it has more within a lamp's reach gets the light
/// of the first.
inline constexpr std::size_t kMostLampRooms = 1u << 12;

/// By sector: every lamp that might shine there by a straight way, whatever the heights. Rooms are entered through
/// portals that face the lamp and are within its reach; whether a straight way passes them all is not asked here.
/// One lamp is there once for each place and each direction in which its space is turned there.
/// Cost: the walls of the sectors within reach.
std::vector<std::vector<SeenLamp>> seen_lamps(const Map& map);

/// Nearer to each other than this, two places of one lamp are one: chains of links that lead to the same room agree
/// but for rounding [m].
inline constexpr double kSameLampPlace = 0x1p-10;

/// A place that light may fall on, in the space of its sector.
struct LitPlace {
    SectorId sector;
    Vec2 place;   ///< [m]
    double z;     ///< [m]
    WallId wall;  ///< of the sector, and faces the lamp: the place is on it; none: it is in the sector, or on a panel
};

/// Whether the lamp's light comes to the place: every portal on the straight way there is open at the height at which
/// the way passes, and nothing else is on it. A portal is open above both floors and below both ceilings; where both
/// rooms are under the sky, nothing is above. The lamp must be in its room.
///
/// Which walls the way crosses is decided in whole numbers, with the place rounded to the point grid, and once more
/// behind each link. What is within kAmbiguous of the way's end does not stand before it.
/// Cost: the walls of the sectors passed.
bool is_lit(const Map& map, const Snapshot& snapshot, const SeenLamp& lamp, const LitPlace& at);

}  // namespace enfilade
