// The wall that stands in for one that rounding lost: shared by the renderers that draw walls as a whole.
#pragma once
#include "map/map.h"
#include "render/view.h"

namespace enfilade {

/// For a ray that no wall of the sector covers: the wall that comes nearest to it, preferably one beyond `entry`, which
/// may be none. The eye is rounded onto its grid behind a link, and the tie rule moves it there in that space's own
/// way, which can put a ray that came in at the very edge of the doorway just outside it; without this its pixels would
/// never be drawn. Cost: the walls of the sector.
WallId least_missed(const Map& map, SectorId sector, const Pose& pose, double slope, WallId entry);

}  // namespace enfilade
