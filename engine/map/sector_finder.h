// Which sector is around a point, when there are many sectors and many points.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// A tree of the sectors' bounding boxes, halved in turn along x and along y. The map must not change while it is
/// used. Memory: about 40 bytes a sector.
class SectorFinder {
public:
    /// Only the given sectors are looked at.
    SectorFinder(const Map& map, std::vector<std::uint32_t> sectors);

    /// The sector with the lowest number that contains p, or none.
    /// Cost: log of the number of sectors, and the walls of those whose boxes p is in.
    SectorId around(Vec2 p) const;

private:
    struct TreeNode {
        Vec2 min, max;             ///< of all sectors below
        std::uint32_t begin, end;  ///< they are sectors_[begin, end)
        std::uint32_t right;       ///< index of the second child; the first is the next node; 0: a leaf
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end, bool along_x);
    void search(std::uint32_t node, Vec2 p, SectorId& best) const;

    const Map& map_;
    std::vector<std::uint32_t> sectors_;
    std::vector<TreeNode> nodes_;
};

// Is a point inside these walls? The one definition of "inside" that all of the engine uses.

/// True where the loops of `walls` wind around the moving point p. Exact, under the tie rule (math/predicates.h): of
/// sectors that share an edge exactly one contains each point. Cost: the walls.
bool is_inside(std::span<const Wall> walls, Vec2 p);

/// The same for a sector of a map, looking at its bounding box first.
bool is_inside(const Map& map, SectorId sector, Vec2 p);

/// The first sector of that name, or none. Cost: the sectors.
SectorId sector_named(const Map& map, std::string_view name);

// What follows from the rest of a map and is worked out again where one was read from bytes. Private to map/.

/// Fills in the other ends, lengths, previous walls and sector of the sector's walls, and its bounding box, from where
/// each wall begins and which wall is next.
void settle_shape(Map& map, SectorId sector);

/// Fills in the length, from the ends.
void settle_length(Panel& panel);

/// Fills in what the wall's link does to what moves, from what it does to what is seen. Nothing for a wall without one.
void settle_grid_link(Map& map, const Wall& wall);

}  // namespace enfilade
