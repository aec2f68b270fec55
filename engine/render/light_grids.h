// The light of all point lights on the surfaces of a map, worked out when somebody looks at a surface, and kept.
//
// A surface's grid is a function of the map and the snapshot alone: of the heights of the rooms that light passes on
// its way, and of the colours its lights have at that moment. What depends on neither, which light comes which way to
// which place, is found once.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "render/light_patch.h"

namespace enfilade {

/// Grids of one map at one moment after another. Several threads may ask at the same time, about the same moment. A map
/// without lights and suns costs nothing: no memory, no time.
class LightGrids {
public:
    /// Nothing is worked out yet. The map outlives this. points_per_m: 1..kMostLightPoints.
    explicit LightGrids(const Map& map, int points_per_m = kUsualLightPoints);

    /// These, or null: the map has no lights and no suns, so there is nothing to ask for.
    LightGrids* where_lit() { return memos_.empty() ? nullptr : this; }

    // What falls on a surface, or null: nothing, as on a sky. Valid until another moment is asked about.
    // Cost: of the first look at a surface, a look for each point that a light's reach covers; when
    // something moves on the way of its light, a comparison for each; else one for each sector on the way.

    const LightGrid* on_wall(const Snapshot& snapshot, WallId wall);
    const LightGrid* on_panel(const Snapshot& snapshot, PanelId panel);
    const LightGrid* on_floor(const Snapshot& snapshot, SectorId sector);
    const LightGrid* on_ceiling(const Snapshot& snapshot, SectorId sector);
    /// The same everywhere on the thing's picture: what arrives in the middle of its body.
    const LightGrid* on_thing(const Snapshot& snapshot, ThingId thing);

private:
    /// A wall, a panel, a thing, or a sector's floor and ceiling.
    struct Memo {
        Lock lock;
        bool is_new = true;
        double per_m = 0;  ///< points along a metre
        std::vector<LampOnSurface> lamps;
        std::vector<SectorId> sectors;       ///< whose heights count
        std::vector<double> heights;         ///< of the moment that patches are of [m]
        std::vector<LampColor> colors;       ///< of the moment that grids are of
        std::vector<LightPatch> patches[2];  ///< by lamp; of a sector: floor, ceiling
        LightGrid grids[2];
    };

    const LightGrid* on_flat(const Snapshot& snapshot, SectorId sector, int side);
    Memo& memo(std::size_t number);
    template <class Make>
    void note_lamps(std::span<const LightImage> images, Make make, Memo& memo) const;
    void note_sectors(SectorId home, Memo& memo) const;
    static bool heights_changed(const Snapshot& snapshot, Memo& memo, double own_height);
    bool colors_changed(const Snapshot& snapshot, Memo& memo) const;
    using Suns = std::array<LampColor, 2>;  ///< that falls on each side of a memo
    template <class Make, class Patch>
    const LightGrid* grid(const Snapshot& snapshot, std::size_t number, SectorId home, int side, double own_height,
                          const Suns& suns, Make make, Patch patch);

    const Map& map_;
    double per_m_;
    Lock lock_;
    LightImages images_;
    std::vector<std::unique_ptr<Memo>> memos_;  ///< of walls, then panels, things, sectors
};

}  // namespace enfilade
