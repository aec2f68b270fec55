// What a disc around a place touches: the sectors it overlaps and the walls it meets, through every portal on the way.
// This is how a body stands in several rooms at once, also on both sides of a link.
//
// A point is touched where it can be reached from the middle of the disc on a straight way that is shorter than the
// radius and passes only portals that may be passed. So of two rooms that overlap on the map, only the one
// that the portals lead to counts. A wall or panel that stands behind another wall of the same room is reported, too:
// then the other one is nearer.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/containers.h"
#include "map/map.h"
#include "space/trace.h"

namespace enfilade {

// What can be seen of a wall from a point, through the portal one looks through: cones of sight, decided exactly.

/// The directions from a point between two points, left and right as seen from it: less than half a turn apart, left
/// included, right not. Under the tie rule the point never lies in line with the two.
struct Cone {
    Vec2 left, right;
};

/// A wall, or one side of a panel: an edge a -> b that is seen from its right.
struct Face {
    Vec2 a, b;  ///< on the vertex grid

    Face(Vec2 start, Vec2 end) : a(start), b(end) {}
    Face(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// The part of the cone in which the wall is seen from its own side, or none. `window` none: all directions.
/// p: where the eye is, on the point grid.
std::optional<Cone> cone_of(const Face& wall, Vec2 p, const std::optional<Cone>& window);

/// True where every direction of the cone is in `wide`, too. Both are parts of what is seen of one wall from p.
bool is_within(const Cone& cone, const Cone& wide, Vec2 p);

/// What is left of a cone without another one, from left to right. Exact, as the cones are.
ShortList<Cone, 2> without(const Cone& cone, const Cone& other, Vec2 p);

/// A stretch of a wall; neither end needs to be on a grid, unless it is an end of the wall.
struct Stretch {
    Vec2 a, b;
};

/// The stretch of the wall inside a cone that cone_of() gave for it. Ends that the cone does not cut are exact.
Stretch stretch_in(const Face& wall, Vec2 p, const Cone& cone);

/// The point of the stretch that is nearest to p, rounded.
Vec2 nearest_point(const Stretch& stretch, Vec2 p);

/// True where the wall, inside a cone that lies within `window_wall`, is farther from p than that one: seen through
/// it, not before it. Where both lie on one line, the wall bounds a part of its room on the side of p, and is not. The
/// two do not cross.
bool is_beyond(const Face& wall, const Face& window_wall, Vec2 p, const Cone& cone);

/// The same for a panel: what lies in the window belongs to the room the panel is in.
bool is_panel_beyond(const Face& panel, const Face& window_wall, Vec2 p, const Cone& cone);

/// A wall that a disc touches and that nothing passes: solid, a mirror, or a portal that may not be passed; or a panel
/// that blocks. Where only its end is touched, around the corner of an open portal, the stretch is that one point.
struct ReachedWall {
    WallId wall;      ///< none: a panel
    PanelId panel;    ///< where it is no wall
    Vec2 a, b;        ///< its ends, a panel's turned so that the middle of the disc is on the right
    Rigid passage;    ///< from the space of the place into that of the wall
    Vec2 centre;      ///< the middle of the disc in the space of the wall, on the point grid
    Stretch stretch;  ///< the part that can be reached at any radius
    bool is_cut;      ///< the stretch is not the whole wall
};

/// A sector that a disc overlaps.
struct ReachedSector {
    SectorId sector;
    Rigid passage;                   ///< from the space of the place into that of the sector
    std::uint32_t rooms_on_way = 0;  ///< that a straight look from the place into it goes through, itself the last
    std::uint32_t walls_on_way = 0;  ///< of these together
};

struct Reach {
    ShortList<ReachedWall, 16> walls;      ///< and panels
    ShortList<ReachedSector, 16> sectors;  ///< the place's own first; one that is overlapped in two ways is there twice
    std::size_t walls_looked_at = 0;       ///< what it cost: those of sectors, and those at the ends of portals
};

/// Everything nearer to the place than `radius`; touching at exactly that distance does not count. Exact where a wall
/// is reached whole; a distance to a stretch of a wall is rounded.
///
/// radius   : on the point grid [m]; 0 reaches the place's own sector only
/// may_pass : asked for each portal or way back the disc touches; empty: every portal may be passed, no way back
/// Cost: the walls of the sectors overlapped, and their panels where some block, once for each look into one that shows
/// more than those before; and once around each end of a portal that is touched, at most 256 rooms. Reach says how many
/// walls that were. Takes no memory where they are few. Beyond kMaxReachedSectors looks, portals count as walls,
/// and beyond kMaxReachedLinks through links, links do.
Reach reach(const Map& map, const Place& place, double radius, const MayPass& may_pass = {});

/// A disc as large as a body overlaps a dozen sectors on a fine stair, and 615 on the finest ramp there can be.
inline constexpr std::size_t kMaxReachedSectors = 1024;

/// Around a point where links meet at a small angle a disc overlaps one sector many times: at one of two degrees, 90.
inline constexpr std::size_t kMaxReachedLinks = 128;

// In which sectors things are to be seen (presence.cpp): their own, and every one that their pictures reach into
// through portals. So a thing in a doorway is on both sides of it.

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
/// (reach()), whatever the heights there are; in one that it reaches in two ways that put it at different
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
