#include "render/sprite.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade {

namespace {

constexpr std::uint32_t kEighth = 1u << 29, kHalfEighth = 1u << 28;  ///< of a turn [Angle steps]

/// A portal that one may look through somewhere between floor and ceiling.
bool is_open(const Map& map, const Snapshot& snapshot, const Wall& wall) {
    if (wall.kind != WallKind::portal) return false;
    const double rise = map.passage(wall).rise;
    const Heights here = heights_at(snapshot, wall.sector), there = heights_at(snapshot, wall.behind);
    return std::max(here.floor_z, there.floor_z - rise) < std::min(here.ceiling_z, there.ceiling_z - rise);
}

/// A thing with one picture that turns is seen as narrow as a card that is turned as far from the eye, and mirrored
/// from behind.
void turn_card(SpritePicture& picture, const Presence& presence, Angle yaw, Vec2 eye) {
    const Vec2 to_eye = eye - presence.position, faces = presence.passage.turn(direction(yaw));
    const double distance = std::sqrt(dot(to_eye, to_eye));
    const double shown = distance > 0 ? dot(to_eye, faces) / distance : 0;
    if (shown == 0) picture.texture = TextureId();
    picture.size_m.x *= std::fabs(shown);
    picture.origin_m.x *= std::fabs(shown);
    picture.is_mirrored = shown < 0;
}

}  // namespace

bool is_behind(const Middle& middle, Vec2 a, Vec2 b) {
    const auto [nearest, farthest] = std::minmax(
        {depth_steps(dot(middle.forward, a - middle.eye)), depth_steps(dot(middle.forward, b - middle.eye))});
    const std::int64_t own = depth_steps(middle.depth);
    if (farthest <= own || nearest > own) return farthest <= own;
    return side_of_line(a, b, middle.place) < 0;
}

bool is_seen_in(const Map& map, const Snapshot& snapshot, const Middle& middle, const RoomCrossing& room) {
    const auto leans_out = [&](WallId doorway, bool is_farther) {
        return is_farther && is_open(map, snapshot, map[doorway]);
    };
    // A doorway is a wall of both rooms, a -> b of the one before it and b -> a of the one behind.
    if (room.entry && !is_behind(middle, map[room.entry].b, map[room.entry].a)) return false;
    if (room.entry && leans_out(room.entry, room.is_entry_farther)) return false;
    return !is_behind(middle, map[room.exit].a, map[room.exit].b) || leans_out(room.exit, room.is_exit_farther);
}

SpriteSpan span_of(const SpritePicture& picture, double place_x_v, double flip) {
    const bool mirrored = (flip < 0) != picture.is_mirrored;
    const double left_of_it = mirrored ? picture.size_m.x - picture.origin_m.x : picture.origin_m.x;
    return {place_x_v - left_of_it, picture.size_m.x, mirrored};
}

std::size_t view_from(Vec2 eye, const Presence& presence, Angle yaw) {
    const Vec2 place = presence.position;
    // Growing yaws turn right, so from one view to the next the eye goes round to the left.
    const auto is_right_of_start = [&](std::uint32_t view) {
        const Vec2 start = direction(yaw - Angle{view * kEighth + kHalfEighth});
        return side_of_line(place, place + snap_to_point_grid(presence.passage.turn(start)), eye) > 0;
    };
    for (std::uint32_t view = 0; view < 7; ++view)
        if (is_right_of_start(view) && !is_right_of_start(view + 7)) return view;
    return 7;
}

SpritePicture picture_of(const Map& map, const TextureSet& textures, const Snapshot& snapshot, const Presence& presence,
                         Vec2 eye) {
    const Thing& thing = map[presence.thing];
    const Sprite& sprite = map[thing.sprite];
    const ThingSnapshot now = thing_at(map, snapshot, presence.thing);
    const SpriteFrame& frame = sprite.frames[now.frame];
    const bool is_round = frame.views[0] == frame.views[1];
    SpritePicture picture;
    if (std::binary_search(snapshot.taken.begin(), snapshot.taken.end(), presence.thing)) return picture;
    const std::size_t view = is_round ? 0 : view_from(eye, presence, now.yaw);
    picture.texture = frame.views[view];
    if (!picture.texture) return picture;
    const Texture& texture = textures[picture.texture];
    picture.size_m = Vec2{double(texture.width), double(texture.height)} * (1 / sprite.texels_per_m);
    picture.origin_m = frame.origins_m[view];
    picture.foot_z = presence.passage.apply_height(now.z);
    picture.lighting = lighting_in(map, thing.sector, now.light, 1);
    if (is_round && thing.turn != 0) turn_card(picture, presence, now.yaw, eye);
    return picture;
}

namespace {

/// The frame of the picture's animation; the picture itself shows when it would be its own turn.
TextureId animated(const PictureChanges& pictures, TextureId picture, double time_s) {
    if (!built_in::kAnimation || !picture || pictures.animation_of.empty()) return picture;
    const std::uint32_t number = pictures.animation_of[picture.index];
    if (number == PictureChanges::kNone) return picture;
    const Animation& animation = pictures.animations[number];
    const auto count = static_cast<double>(animation.frames.size());
    const auto own = std::find(animation.frames.begin(), animation.frames.end(), picture) - animation.frames.begin();
    const double shown = std::floor(std::max(time_s, 0.0) / animation.seconds) + static_cast<double>(own);
    return animation.frames[static_cast<std::size_t>(shown - std::floor(shown / count) * count)];
}

TextureId face_of(const Map& map, const Snapshot& snapshot, WallId wall, TextureId picture) {
    if (!built_in::kSwitches || !picture || snapshot.pressed.empty() || map.pictures.other_face.empty()) return picture;
    const TextureId other = map.pictures.other_face[picture.index];
    return other && std::binary_search(snapshot.pressed.begin(), snapshot.pressed.end(), wall) ? other : picture;
}

/// An offset that has grown by some tiles, still less than a tile.
double moved(double offset_tiles, double by) { return offset_tiles + by - std::floor(offset_tiles + by); }

/// Along a wall or panel, and up.
void scroll_upright(Surface& surface, double time_s) {
    const Vec2 scroll = surface.scroll;
    if (!built_in::kScrolling || scroll == Vec2{}) return;
    surface.offset_tiles.x = moved(surface.offset_tiles.x, scroll.x * time_s / surface.tile_m.x);
    surface.offset_tiles.y = moved(surface.offset_tiles.y, -scroll.y * time_s / surface.tile_m.y);
}

/// Along x and y, or round a sky.
void scroll_level(Surface& surface, bool is_sky, double time_s) {
    const Vec2 scroll = surface.scroll;
    if (!built_in::kScrolling || scroll == Vec2{}) return;
    if (is_sky) {
        surface.offset_tiles.x = moved(surface.offset_tiles.x, scroll.x / 360 * time_s * surface.tile_m.x);
        return;
    }
    surface.offset_tiles.x = moved(surface.offset_tiles.x, scroll.x * time_s / surface.tile_m.x);
    surface.offset_tiles.y = moved(surface.offset_tiles.y, scroll.y * time_s / surface.tile_m.y);
}

/// The flat with its picture `given`, if any, animated and moved.
FlatNow flat_now(const Map& map, const Flat& at_rest, TextureId given, double time_s) {
    FlatNow flat{map[at_rest.surface], at_rest.origin, at_rest.sky, at_rest.first_layer, at_rest.layer_count};
    Surface& surface = flat.surface;
    surface.texture = animated(map.pictures, given ? given : surface.texture, time_s);
    scroll_level(surface, flat.sky, time_s);
    return flat;
}

}  // namespace

Surface picture_now(const Map& map, const Snapshot& snapshot, WallId id, SurfaceId at_rest) {
    Surface surface = map[at_rest];
    surface.texture = animated(map.pictures, face_of(map, snapshot, id, surface.texture), snapshot.time_s);
    scroll_upright(surface, snapshot.time_s);
    return surface;
}

Surface picture_now(const Snapshot& snapshot, const Panel& panel) {
    Surface surface = panel.surface;
    scroll_upright(surface, snapshot.time_s);
    return surface;
}

FlatNow floor_now(const Map& map, const Snapshot& snapshot, SectorId sector) {
    return flat_now(map, map[sector].floor, snapshot[sector].floor_picture, snapshot.time_s);
}

FlatNow ceiling_now(const Map& map, const Snapshot& snapshot, SectorId sector) {
    return flat_now(map, map[sector].ceiling, TextureId(), snapshot.time_s);
}

Surface layer_now(const Map& map, const Snapshot& snapshot, const FlatNow& flat, std::uint32_t i) {
    Surface surface = map.flat_layers[flat.first_layer + i];
    surface.texture = animated(map.pictures, surface.texture, snapshot.time_s);
    scroll_level(surface, flat.sky, snapshot.time_s);
    return surface;
}

}  // namespace enfilade
