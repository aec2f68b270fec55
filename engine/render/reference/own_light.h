// What lamps and suns throw onto the places that rays meet: from the grids that all renderers share
// (render/light_grids.h), or worked out anew for each place, by sight lines, so that grids can be held against it.
#pragma once
#include <memory>
#include <vector>

#include "render/light_grids.h"
#include "render/reference/sight_line.h"

namespace enfilade {

/// Which of a sector's two flats.
enum class FlatSide : std::uint8_t { floor, ceiling };

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
    LightCell on_flat(SectorId sector, FlatSide side, Vec2 place) const;
    /// The same everywhere on its picture: what arrives in the middle of its body.
    LightCell on_thing(ThingId thing) const;

private:
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
    LightCell on_flat(SectorId sector, FlatSide side, Vec2 place) const;
    LightCell on_thing(ThingId thing) const;

private:
    const Snapshot* snapshot_ = nullptr;
    LightGrids* grids_ = nullptr;  ///< null: there is no such light
    const OwnLight* own_ = nullptr;
};

}  // namespace enfilade
