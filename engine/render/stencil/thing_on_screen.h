// Where a thing's picture stands on the screen, as seen in one sector of one layer.
#pragma once
#include <optional>

#include "render/sprite.h"
#include "render/stencil/wall_on_screen.h"
#include "render/surface_id.h"

namespace enfilade::stencil {

/// A picture that is met in a room. Its place is like a wall's that faces the eye squarely: all of it has one depth.
struct ThingOnScreen {
    WallOnScreen place;  ///< its columns are whole ones
    SurfaceId id = kNothing;
    TextureId texture;
    double light = 1;
    double depth = 0;               ///< [m]
    double top = 0, height = 0;     ///< of the whole picture; top: above the eye [m]
    double floor = 0, ceiling = 0;  ///< the part of it that is inside the room, above the eye [m]
};

/// none: too near, or no picture, or none of it in the room's heights or the picture's columns.
/// room_floor, room_ceiling: above the eye [m].
std::optional<ThingOnScreen> on_screen(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                       const Presence& presence, const Eye& eye, const Screen& screen,
                                       double room_floor, double room_ceiling);

}  // namespace enfilade::stencil
