// What lamps and suns throw onto the places that rays meet: from the grids that all renderers share
// (render/light_grids.h), or worked out anew for each place, by sight lines, so that grids can be held against it.
#pragma once
#include <cstdint>
#include <vector>

#include "map/map.h"
#include "render/light_grids.h"
#include "world/snapshot.h"

namespace enfilade {

// Straight ways of light from lamps to places. They share the map and the predicates (math/predicates.h) with the ways
// of render/light_patch.h, and nothing else: no grid, no search, no path.

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

// The light that comes by them.

/// The light at single places, by the rules of maps/FORMAT.md (A light, A sun): no grid, nothing between places.
/// Shared with grids are the lamps' colours at the moment, those of suns, and the units of LightCell.
class OwnLight {
public:
    /// Of one moment. Both outlive this. Cost: seen_lamps().
    OwnLight(const Map& map, const Snapshot& snapshot);

    // Cost: a look at each lamp that may reach the sector, and the walls on the straight way from each that is near.

    /// along: from the wall's or panel's a [m]. z: [m]
    LightCell on_wall(WallId wall, double along, double z) const;
    LightCell on_panel(PanelId panel, double along, double z) const;
    /// place: in the sector [m]
    LightCell on_floor(SectorId sector, Vec2 place) const;
    LightCell on_ceiling(SectorId sector, Vec2 place) const;
    /// The same everywhere on its picture: what arrives in the middle of its body.
    LightCell on_thing(ThingId thing) const;

private:
    LightCell on_flat(const LitPlace& at, const LampColor& sun) const;
    template <class NormalWay>
    LightCell sum_at(const LitPlace& at, const LampColor& sun, NormalWay normal_way) const;

    const Map& map_;
    const Snapshot& snapshot_;
    std::vector<std::vector<SeenLamp>> seen_;  ///< by sector
    std::vector<LampColor> colors_;            ///< by lamp, at the moment
};

/// Either way to know the light. Where the map has neither lamps nor suns, nothing is asked.
class Lamplight {
public:
    Lamplight() = default;
    /// All outlive this. own: null: grids are asked. grids: of the map.
    Lamplight(const Snapshot& snapshot, LightGrids& grids, const OwnLight* own)
        : snapshot_(&snapshot), grids_(grids.where_lit()), own_(own) {}

    LightCell on_wall(WallId wall, double along, double z) const;
    LightCell on_panel(PanelId panel, double along, double z) const;
    LightCell on_floor(SectorId sector, Vec2 place) const;
    LightCell on_ceiling(SectorId sector, Vec2 place) const;
    LightCell on_thing(ThingId thing) const;

private:
    const Snapshot* snapshot_ = nullptr;
    LightGrids* grids_ = nullptr;  ///< null: there is no such light
    const OwnLight* own_ = nullptr;
};

}  // namespace enfilade
