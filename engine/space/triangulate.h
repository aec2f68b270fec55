// The floors of a map as triangles: of one sector, and of all, where triangles know their neighbours.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "map/map.h"

namespace enfilade {

/// Three corners, clockwise on the drawing, never on one line. Each is the `a` of a wall of the sector: where several
/// walls start in one vertex, of the one that bounds the ground around this corner. So corners are the same wall where
/// one can turn about the vertex from one to the other inside the sector, and two walls where they only touch in it;
/// and the edge that is a wall starts with that wall.
using Triangle = std::array<WallId, 3>;

/// Cuts a sector into triangles whose corners are its vertices: they cover it without gap or overlap, and no vertex
/// lies inside an edge of a triangle. Any walls that build_map() accepts: outlines and holes that touch themselves and
/// one another in vertices, walls back to back; which walls make up a loop decides nothing.
///
/// Exact (math/predicates.h). A line sweeps over the sector and cuts off what it has seen whole (Stefan Hertel, Kurt
/// Mehlhorn: "Fast triangulation of simple polygons", 1983).
/// Returns: at least one triangle; two less than there are walls in a sector of one loop that does not touch itself,
/// two more for each hole. Cost: O(n log n) in the number of walls.
std::vector<Triangle> triangulate(const Map& map, SectorId sector);

// All floors of a map as triangles that know their neighbours (tiling.cpp): what shortest ways are searched in.

/// Triangles and their edges have numbers: edge i of tile t, 3 t + i, runs from its corner i to the next; the corners
/// run clockwise, so that the tile is on the right of its edges.
class Tiling {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    /// Cost: that of triangulate(), for every sector.
    explicit Tiling(const Map& map);

    std::uint32_t tile_count() const { return static_cast<std::uint32_t>(corners_.size() / 3); }
    /// The wall of the tile's sector that begins where the edge does; of several, as in Triangle.
    WallId corner(std::uint32_t edge) const { return corners_[edge]; }
    /// The wall that the edge is, or none: it runs through the room.
    WallId wall(std::uint32_t edge) const { return walls_[edge]; }
    /// The same edge as the neighbour in the room has it; only where wall() is none.
    std::uint32_t across(std::uint32_t edge) const { return across_[edge]; }
    std::uint32_t edge_of(WallId wall) const { return edge_of_wall_[wall.index]; }
    /// All walls of the map that begin where this one does, in whatever sector.
    std::span<const WallId> around(WallId wall) const;
    /// A tile of the sector that contains p, its edges included, from `first` on; kNone: there is none left.
    std::uint32_t find(const Map& map, SectorId sector, Vec2 p, std::uint32_t first = 0) const;

private:
    void add_sector(const Map& map, SectorId sector);
    void join_edges(const Map& map, std::uint32_t begin);
    void group_walls(const Map& map);

    std::vector<WallId> corners_, walls_;        ///< by edge
    std::vector<std::uint32_t> across_;          ///< by edge
    std::vector<std::uint32_t> edge_of_wall_;    ///< by wall
    std::vector<std::uint32_t> first_;           ///< tiles of sector i are [first_[i], first_[i + 1])
    std::vector<WallId> by_place_;               ///< walls by where they begin
    std::vector<std::uint32_t> place_;           ///< by wall: which of places_first_
    std::vector<std::uint32_t> places_first_{};  ///< into by_place_, one more than there are places
};

/// The edge before or after this one in its tile.
constexpr std::uint32_t next_edge(std::uint32_t edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
constexpr std::uint32_t previous_edge(std::uint32_t edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }

// Which sectors share ground with others: rooms that are bigger inside.

/// For each sector 1 where it overlaps another one in the plane that it is joined to by any number of plain doorways,
/// else 0. Sectors that are joined by links only may lie on one another as they like: they are never in the same space.
/// Touching does not count. Exact; but sectors of thousands of walls whose bounding boxes overlap count as overlapping.
/// Cost: once for a map; all pairs of sectors side by side, and their triangles.
std::vector<char> overlapping_sectors(const Map& map);

}  // namespace enfilade
