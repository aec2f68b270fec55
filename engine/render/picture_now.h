// Pictures that change with time, shared by all renderers: which one a surface shows at a moment, and how far it has
// moved. Asked once for each surface that is drawn, never for each pixel.
#pragma once
#include "map/map.h"
#include "render/built_in.h"
#include "world/snapshot.h"

namespace enfilade {

/// How one of a wall's surfaces lies at the snapshot's time: its switch turned, its animation's frame, scrolled.
Surface picture_now(const Map& map, const Snapshot& snapshot, WallId wall, LayId surface);

/// A panel's at that time: scrolled.
Surface picture_now(const Snapshot& snapshot, const Panel& panel);

/// A floor or ceiling as it looks at a moment.
struct FlatNow {
    Surface surface;  ///< moved: its own scroll is done
    Vec2 origin;      ///< of the texture, in the plane
    bool sky = false;
    std::uint32_t first_layer = 0, layer_count = 0;  ///< as a Flat's
};

/// A sector's floor and ceiling at the snapshot's time, in the same way.
FlatNow floor_now(const Map& map, const Snapshot& snapshot, SectorId sector);
FlatNow ceiling_now(const Map& map, const Snapshot& snapshot, SectorId sector);

/// A layer of a sky at the snapshot's time, turned.
Surface layer_now(const Map& map, const Snapshot& snapshot, const SkyLayer& layer);

/// Its light then, 0..1.
inline double light_now(const Snapshot& snapshot, SectorId sector) {
    return built_in::kChangingLights ? light_at(snapshot, sector) : snapshot[sector].light;
}

}  // namespace enfilade
