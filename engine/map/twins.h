// Finding the wall of a sector that lies on a given edge, the other way round.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// Looks up walls by their ends. The map's walls must not change while it is used.
class TwinIndex {
public:
    explicit TwinIndex(const Map& map);

    /// The wall b -> a of `sector`, or none. Exact. Cost: log of the sector's walls.
    WallId find(SectorId sector, Vec2 a, Vec2 b) const;

    /// The wall of `sector` that runs the other way along the same line and covers all of a -> b, or none.
    /// Cost: the sector's walls, up to a budget in the index's life.
    WallId covering(SectorId sector, Vec2 a, Vec2 b) const;

    /// The wall of `sector` whose ends are nearest to b -> a, for telling the author; none where the budget is spent.
    WallId nearest(SectorId sector, Vec2 a, Vec2 b) const;

private:
    /// Takes `count` from what linear searches may still cost.
    bool may_search(std::size_t count) const;

    const Map& map_;
    std::vector<std::uint32_t> order_;  ///< each sector's walls, sorted by their ends
    mutable std::size_t steps_left_;
};

}  // namespace enfilade
