// The rules by which things are seen, shared by all renderers: which picture, how large, and what hides it.
//
// A thing's picture stands upright through the thing's place, parallel to the picture plane, so all of it has one
// depth. It is part of the rooms it reaches into (space/reach.h): a ray sees it in a room if the ray, while it is in
// that room, reaches the picture's depth between the room's floor and ceiling. Since a ray is in one room at each
// depth, no pixel shows a picture twice, and where it stands in a doorway it is cut at the doorway and goes on behind
// it. What is below the floor, above the ceiling or behind a wall is hidden, as in any world with depth.
//
// Where a map wants things whole (RenderRecord::things), as Doom draws them, a picture is not cut by what it reaches
// into. The thing's middle decides: a ray sees the picture in a room that the thing is in if the middle is behind the
// doorway through which the ray came in and before the wall by which it goes out (is_behind()). There it sees all of
// the picture, whatever the room's floor and ceiling, and however near the wall is in that very direction; nothing but
// steps and edges of doorways that the middle is behind hides a part. A doorway hides nothing that leans out of it:
// where a ray reaches the picture before the doorway, it sees it in the room before. Since a middle is either before a
// doorway or behind it, one of its two rooms shows the picture; through a link it is seen once, on its own side. A
// tilted picture has no columns to say this of; there things are cut.
#pragma once
#include <cstdint>

#include "map/map.h"
#include "map/textures.h"
#include "math/vec.h"
#include "render/built_in.h"
#include "render/exact_ray.h"
#include "render/lighting.h"
#include "space/reach.h"
#include "world/snapshot.h"

namespace enfilade {

/// A picture nearer than this is not shown: who stands in a thing looks through it [m]. Doom's number, 4 units.
inline constexpr double kNearestSprite = 0.125;

/// A ray's way through a room, and which of its ends are farther than a thing, in steps (render/exact_ray.h).
struct RoomCrossing {
    WallId entry, exit;  ///< walls of the room; entry: none in the eye's own
    bool is_entry_farther = false, is_exit_farther = false;

    /// Whether the ray is in the room at the thing's depth: at the entry it is, at the exit it is not, being in the
    /// room behind.
    bool holds_thing() const { return !is_entry_farther && is_exit_farther; }
};

/// The middle of a thing's picture, in a space in which an eye looks.
struct Middle {
    Vec2 eye, forward;  ///< of the eye
    Vec2 place;         ///< of the thing; all three on the point grid but for forward
    double depth = 0;   ///< dot(forward, place - eye) [m]
};

/// How things are drawn in a picture of the map.
constexpr ThingEdges thing_edges(const RenderRecord& render, bool is_tilted) {
    return is_tilted ? ThingEdges::cut : render.things;
}

/// Whether the middle is behind a wall: farther than all of it, or as far as a part of it, in steps, and to the left of
/// a -> b. So it does not count how far the wall is in one column or another, and a wall that ends before the thing
/// hides it also from where its line runs past the thing. Exact but for depth_steps().
bool is_behind(const Middle& middle, Vec2 a, Vec2 b);

/// Whether a ray sees a thing of this middle in a room. Exact but for depth_steps().
bool is_seen_in(const Map& map, const Snapshot& snapshot, const Middle& middle, const RoomCrossing& room);

/// What is to be seen of a thing from one place.
struct SpritePicture {
    TextureId texture;  ///< none: nothing
    Vec2 size_m;        ///< [m]
    Vec2 origin_m;      ///< from the upper left corner, right and down, to the thing's place [m]
    double foot_z = 0;  ///< height of that place, in the space of the presence's sector [m]
    Lighting lighting;
    bool is_mirrored = false;  ///< its left is to the right; `origin_m` is that of the picture as it was painted
};

/// A thing's picture from left to right, in view space.
struct SpriteSpan {
    double left_v = 0;      ///< its left edge [m]
    double width = 0;       ///< [m]
    bool mirrored = false;  ///< its left edge is the picture's right one

    double right_v() const { return left_v + width; }

    /// Whether a ray that meets the picture's plane at x_v meets the picture.
    bool covers(double x_v) const { return left_v <= x_v && x_v < right_v(); }

    /// From the picture's own left edge to its right one: 0..1 on it, but for rounding.
    double along(double x_v) const {
        const double from_left = (x_v - left_v) / width;
        return mirrored ? 1 - from_left : from_left;
    }
};

/// place_x_v: of the thing, to the right of the eye [m]. flip: of the look (Pose::flip).
SpriteSpan span_of(const SpritePicture& picture, double place_x_v, double flip);

/// eye: in the space of the presence's sector, on the point grid.
SpritePicture picture_of(const Map& map, const TextureSet& textures, const Snapshot& snapshot, const Presence& presence,
                         Vec2 eye);

/// From which eighth of a turn the eye sees a thing: 0 from the front, 2 from the thing's left, 4 from behind, 6 from
/// its right; each reaches half an eighth to both sides. Exact, under the tie rule for the eye (math/predicates.h).
std::size_t view_from(Vec2 eye, const Presence& presence, Angle yaw);

// Pictures that change with time, shared by all renderers: which one a surface shows at a moment, and how far it has
// moved. Asked once for each surface that is drawn, never for each pixel.

/// How one of a wall's surfaces lies at the snapshot's time: its switch turned, its animation's frame, scrolled.
Surface picture_now(const Map& map, const Snapshot& snapshot, WallId wall, SurfaceId surface);

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

/// The i-th of its layers at the snapshot's time, scrolled or turned. i < flat.layer_count.
Surface layer_now(const Map& map, const Snapshot& snapshot, const FlatNow& flat, std::uint32_t i);

/// Its light then, 0..1.
inline double light_now(const Snapshot& snapshot, SectorId sector) {
    return built_in::kChangingLights ? light_at(snapshot, sector) : snapshot[sector].light;
}

}  // namespace enfilade
