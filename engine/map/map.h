// The world that never changes: sectors, walls and portals, resolved and checked. Read this first.
//
// A Map is built once (map/load.h) and then only looked at. Everything is a value in a vector, joined by ids. What
// moves or changes light is not here but in world/: functions take the heights of the moment beside the map.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/id.h"
#include "formats/map_file.h"
#include "math/angle.h"
#include "math/rigid.h"
#include "math/vec.h"

namespace enfilade {

/// How a picture lies on a wall, flat or sky. Texel coordinates are tiles * picture size, wrapped.
///   wall:  u = distance along the wall from a / tile_m.x,  v = (peg height - z) / tile_m.y
///   flat:  u = (x - origin) / tile_m.x,                    v = (y - origin) / tile_m.y
///   sky:   u = turns * tile_m.x,                           v = 1 - tan(elevation) / tile_m.y, clamped to the picture
/// and then minus offset.
struct Surface {
    TextureId texture;       ///< none: no texture ("-" or not given)
    Vec2 tile_m{1, 1};       ///< metres per tile (sky: wraps per turn, tangent of the height)
    Vec2 offset_tiles;       ///< subtracted; in [0, 1) but for a portal's middle, which does not repeat upwards [tiles]
    Peg peg = Peg::ceiling;  ///< walls only
};

enum class WallKind : std::uint8_t { solid, portal, mirror };

/// A directed edge a -> b of a sector, the sector on its right.
struct Wall {
    Vec2 a;         ///< on the vertex grid
    Vec2 b;         ///< equals the next wall's a
    double length;  ///< |b - a| [m]
    SectorId sector;
    WallId next;      ///< the wall that starts at b
    WallId previous;  ///< the wall that ends at a
    WallKind kind = WallKind::solid;
    SectorId behind;               ///< portal: the sector it leads into; else none
    WallId exit;                   ///< portal: the wall of `behind` one comes out of; equals -edge for plain adjacency
    std::uint32_t link = kNoLink;  ///< index into Map::links, or kNoLink where nothing is transformed
    /// Light by direction, so that corners can be seen. Smooth light: a factor, from 0.8 along x to 1 along y. Classic
    /// light: 0.8 exactly along x (one step darker), 1.2 exactly along y (one step brighter), else 1.
    double contrast = 1;
    Surface texture;               ///< solid
    Surface upper, lower, middle;  ///< portal
    static constexpr std::uint32_t kNoLink = 0xFFFFFFFFu;
};

struct Flat {
    double z = 0;  ///< at rest [m]
    Surface surface;
    Vec2 origin;  ///< of the texture, in the plane
    bool sky = false;
};

struct Sector {
    std::string name;
    std::uint32_t first_wall = 0;  ///< its walls are [first_wall, first_wall + wall_count) of Map::walls
    std::uint32_t wall_count = 0;
    double light = 1;  ///< at rest, 0..1
    Flat floor, ceiling;
    Vec2 min, max;  ///< bounding box
};

/// Where the player starts.
struct PlayerStart {
    SectorId sector;
    Vec2 position;     ///< on the point grid
    double eye_z = 0;  ///< [m]
    Angle yaw;
};

struct Map {
    std::string name;
    std::vector<Sector> sectors;
    std::vector<Wall> walls;
    std::vector<Rigid> links;  ///< what each linked portal or mirror does to what passes or is seen through it
    std::optional<PlayerStart> player;
    RenderRecord render;

    const Sector& operator[](SectorId id) const { return sectors[id.index]; }
    const Wall& operator[](WallId id) const { return walls[id.index]; }
    /// The link's transform, or the identity.
    Rigid passage(const Wall& wall) const { return wall.link == Wall::kNoLink ? Rigid{} : links[wall.link]; }
};

}  // namespace enfilade
