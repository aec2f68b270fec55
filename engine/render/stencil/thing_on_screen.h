// Where a thing's picture stands on the screen, as seen in one sector of one layer.
#pragma once
#include <limits>
#include <optional>

#include "render/sprite.h"
#include "render/stencil/wall_on_screen.h"
#include "render/stencil/wall_parts.h"
#include "render/surface_id.h"

namespace enfilade::stencil {

/// A picture that is met in a room. Its place is like a wall's that faces the eye squarely: all of it has one depth.
struct ThingOnScreen {
    WallOnScreen place;
    ThingId thing;
    Vec2 position;  ///< of the thing, in the sector's space
    SurfaceId id = kNothing;
    TextureId texture;
    Lighting lighting;
    double depth = 0;            ///< along `forward`; in tilted pictures maybe behind the eye, below 0 [m]
    double top = 0, height = 0;  ///< of the whole picture; top: above the eye [m]
    Heights shown;               ///< the part of it that no floor or ceiling cuts off, above the eye
};

/// In no column yet. none: too near, or no picture, or all of it is cut off. room: above the eye; what cuts the
/// picture.
std::optional<ThingOnScreen> in_view(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                     const Presence& presence, const Pose& pose, const Heights& room);

/// The room of a thing that nothing cuts.
inline constexpr Heights kNoRoom{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// Finds the columns of a thing ahead of the eye. False: there are none.
bool put_on_screen(ThingOnScreen& thing, const Screen& screen);

}  // namespace enfilade::stencil
