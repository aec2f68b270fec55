// In which sectors things are to be seen: their own, and every one that their pictures reach into through portals. So
// a thing in a doorway is on both sides of it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// One way in which a thing is in a sector.
struct Presence {
    ThingId thing;
    Rigid passage;  ///< from the space of the thing's own sector into that of this one
    Vec2 position;  ///< of the thing in the space of this sector, on the point grid; may lie outside it
};

/// All of them, by sector.
struct Presences {
    std::vector<Presence> all;
    std::vector<std::uint32_t> first;  ///< those of sector i are all[first[i]] to all[first[i + 1]]; empty where no
                                       ///< thing has a picture
    std::size_t steps = 0;             ///< what it took to find them [walls looked at, and presences compared]

    /// In the order of the things' numbers.
    std::span<const Presence> in(SectorId sector) const {
        if (first.empty()) return {};
        return std::span(all).subspan(first[sector.index], first[sector.index + 1] - first[sector.index]);
    }
};

/// Where the things with pictures are. A thing is in every sector that a disc as wide as its widest picture reaches
/// (space/reach.h), whatever the heights there are; in one that it reaches in two ways that put it at different
/// places, as through two links, it is twice.
/// Cost: the walls of the sectors that the pictures reach. Beyond kMostPresences or kMostPresenceSteps things are in
/// their own sector only.
Presences presences_of(const Map& map);

/// Far more than there are in any honest map; a file full of pictures a thousand metres wide must not fill the memory.
inline constexpr std::size_t kMostPresences = 1u << 20;

/// A quarter of a second, which no honest map comes near; pictures as wide as a thousand narrow rooms do [as
/// Presences::steps].
inline constexpr std::size_t kMostPresenceSteps = std::size_t{1} << 26;

/// Pictures reach no further into other rooms [m].
inline constexpr double kWidestReach = 1024;

}  // namespace enfilade
