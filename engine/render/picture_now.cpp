#include "render/picture_now.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
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

/// The flat with its picture `given`, if any, animated and moved.
FlatNow flat_now(const Map& map, const Flat& at_rest, TextureId given, double time_s) {
    FlatNow flat{map[at_rest.surface], at_rest.origin, at_rest.sky, at_rest.first_layer, at_rest.layer_count};
    Surface& surface = flat.surface;
    const Vec2 scroll = surface.scroll;
    surface.texture = animated(map.pictures, given ? given : surface.texture, time_s);
    if (!built_in::kScrolling || scroll == Vec2{}) return flat;
    if (flat.sky) {
        surface.offset_tiles.x = moved(surface.offset_tiles.x, scroll.x / 360 * time_s * surface.tile_m.x);
        return flat;
    }
    surface.offset_tiles.x = moved(surface.offset_tiles.x, scroll.x * time_s / surface.tile_m.x);
    surface.offset_tiles.y = moved(surface.offset_tiles.y, scroll.y * time_s / surface.tile_m.y);
    return flat;
}

}  // namespace

Surface picture_now(const Map& map, const Snapshot& snapshot, WallId id, LayId at_rest) {
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

Surface layer_now(const Map& map, const Snapshot& snapshot, const SkyLayer& layer) {
    Surface surface = layer.surface;
    surface.texture = animated(map.pictures, surface.texture, snapshot.time_s);
    surface.offset_tiles.x = moved(surface.offset_tiles.x, layer.turn / 360 * snapshot.time_s * surface.tile_m.x);
    return surface;
}

}  // namespace enfilade
