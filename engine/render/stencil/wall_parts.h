// The parts of a wall by height: what of it is drawn, and what one sees through.
#pragma once
#include "map/map.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

/// Heights of a room, or of a part of a wall, above the eye [m].
struct Heights {
    double floor = 0;
    double ceiling = 0;

    bool is_empty() const { return floor >= ceiling; }
};

/// How high the parts of a wall are.
struct WallParts {
    Heights room;
    Heights behind;                     ///< of the room behind a portal; of a solid wall or a mirror, its own
    Heights opening;                    ///< what one sees through: empty for a solid wall or a closed portal
    bool lower = false, upper = false;  ///< the steps that are drawn
};
WallParts parts_of(const Map& map, const Snapshot& snapshot, WallId wall, double eye_z);

/// A room's heights above the eye.
Heights heights_of(const Snapshot& snapshot, SectorId room, double eye_z);

/// Height above the eye that a surface hangs from [m].
double peg_height(const WallParts& parts, Peg peg);

/// How high the picture in a portal hangs or stands, which is shown once from top to bottom.
Heights picture_in(const WallParts& parts, const Surface& middle);

}  // namespace enfilade::stencil
