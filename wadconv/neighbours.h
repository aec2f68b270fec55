// What lies around Doom's sectors, line by line: what its actions look at when they look around.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "wadconv/map_lumps.h"

namespace enfilade::wadconv {

/// A line of a sector with another sector, or the same, on its other side.
struct Neighbour {
    std::uint32_t line;
    std::uint32_t sector;
    bool is_front;  ///< the sector that is asked about is in front of the line, on its right
};

/// Lines marked two-sided with two sides and sectors that exist; of the others nothing is known.
class Neighbours {
public:
    /// Cost: the lines.
    explicit Neighbours(const DoomMap& doom);

    /// In the order of the lines; a line with the sector on both sides is there twice.
    std::span<const Neighbour> of(std::uint32_t sector) const;

    /// The darkest light around, not brighter than its own [0..255].
    std::int16_t darkest(std::uint32_t sector) const;

    /// The lowest floor, not higher than its own [map units].
    std::int16_t lowest_floor(std::uint32_t sector) const;

private:
    const DoomMap& doom_;
    std::vector<Neighbour> all_;
    std::vector<std::uint32_t> first_;  ///< those of sector s are all_[first_[s]] to all_[first_[s + 1]]
};

}  // namespace enfilade::wadconv
