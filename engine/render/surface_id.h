// Numbers for surfaces, equal in all renderers: what an ids picture shows.
#pragma once
#include <cstdint>

#include "map/map.h"

namespace enfilade {

/// 24 bits; 0 is "nothing was drawn here".
using SurfaceId = std::uint32_t;

inline constexpr SurfaceId kNothing = 0;

/// Where a chain of links was cut and the map's recursion colour shows.
inline constexpr SurfaceId kRecursionEnd = 0xFFFFFF;

enum class WallPart : std::uint8_t { middle, upper, lower };

inline SurfaceId floor_id(SectorId sector) { return 1 + 2 * sector.index; }
inline SurfaceId ceiling_id(SectorId sector) { return 2 + 2 * sector.index; }
inline SurfaceId wall_id(const Map& map, WallId wall, WallPart part) {
    return static_cast<SurfaceId>(1 + 2 * map.sectors.size() + std::size_t{3} * wall.index +
                                  static_cast<unsigned>(part));
}

inline SurfaceId thing_id(const Map& map, ThingId thing) {
    return static_cast<SurfaceId>(1 + 2 * map.sectors.size() + 3 * map.walls.size() + thing.index);
}

inline SurfaceId panel_id(const Map& map, PanelId panel) {
    return static_cast<SurfaceId>(1 + 2 * map.sectors.size() + 3 * map.walls.size() + map.things.size() + panel.index);
}

}  // namespace enfilade
