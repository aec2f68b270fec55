// The rules by which things are seen, shared by all renderers: which picture, how large, and what hides it.
//
// A thing's picture stands upright through the thing's place, parallel to the picture plane, so all of it has one
// depth. It is part of the rooms it reaches into (space/presence.h): a ray sees it in a room if the ray, while it is in
// that room, reaches the picture's depth between the room's floor and ceiling. Since a ray is in one room at each
// depth, no pixel shows a picture twice, and where it stands in a doorway it is cut at the doorway and goes on behind
// it. What is below the floor, above the ceiling or behind a wall is hidden, as in any world with depth.
#pragma once
#include <algorithm>
#include <cstdint>

#include "map/map.h"
#include "map/textures.h"
#include "math/vec.h"
#include "space/presence.h"
#include "world/snapshot.h"

namespace enfilade {

/// A picture nearer than this is not shown: who stands in a thing looks through it [m]. Doom's number, 4 units.
inline constexpr double kNearestSprite = 0.125;

/// Whether a picture is met before or behind a wall, or another picture, is decided in whole steps of depth. A thing
/// that stands in the very plane of a doorway is as deep as the doorway, however the look got there: what rounding
/// leaves behind a link, some 1e-12 m, is far below half a step [m].
inline constexpr double kDepthStep = 0x1p-20;

/// Infinity allowed; what is not ahead counts as 0.
inline std::int64_t depth_steps(double depth) {
    constexpr double kFarthest = 0x1p40;  // [m]; farther than anything, and its steps fit
    return static_cast<std::int64_t>(std::clamp(depth, 0.0, kFarthest) / kDepthStep + 0.5);
}

/// Whether something at `depth` is in a room that is entered at depth `entry` and left at depth `exit`: at the entry it
/// is, at the exit it is not, being in the room behind.
inline bool is_between(double depth, double entry, double exit) {
    return depth_steps(depth) >= depth_steps(entry) && depth_steps(depth) < depth_steps(exit);
}

/// Whether it is met there, too: a picture that is `depth` ahead of the eye.
inline bool is_met_between(double depth, double entry, double exit) {
    return depth >= kNearestSprite && is_between(depth, entry, exit);
}

/// What is to be seen of a thing from one place.
struct SpritePicture {
    TextureId texture;  ///< none: nothing
    Vec2 size_m;        ///< [m]
    Vec2 origin_m;      ///< from the upper left corner, right and down, to the thing's place [m]
    double foot_z = 0;  ///< height of that place, in the space of the presence's sector [m]
    double light = 1;   ///< 0..1
};

/// eye: in the space of the presence's sector, on the point grid.
SpritePicture picture_of(const Map& map, const TextureSet& textures, const Snapshot& snapshot, const Presence& presence,
                         Vec2 eye);

/// From which eighth of a turn the eye sees a thing: 0 from the front, 2 from the thing's left, 4 from behind, 6 from
/// its right; each reaches half an eighth to both sides. Exact, under the tie rule for the eye (math/predicates.h).
std::size_t view_from(Vec2 eye, const Presence& presence, Angle yaw);

}  // namespace enfilade
