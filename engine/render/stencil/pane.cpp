#include "render/stencil/pane.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::stencil {

namespace {

/// A picture behind the eye, seen when one looks down past one's feet, has its left end to the right.
WallOnScreen place_of(double left_x, double width, double depth, bool mirrored) {
    WallOnScreen place;
    place.left_v = {left_x, depth};
    place.right_v = {left_x + width, depth};
    if (depth < 0) std::swap(place.left_v, place.right_v);
    place.shown_left_v = place.left_v;
    place.shown_right_v = place.right_v;
    place.cross = width * std::fabs(depth);
    place.swapped = mirrored != (depth < 0);
    return place;
}

}  // namespace

std::optional<ThingOnScreen> in_view(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                     const Presence& presence, const Pose& pose, const RelativeHeights& room) {
    const Vec2 to_it = presence.position - pose.eye;
    ThingOnScreen thing;
    thing.depth = dot(pose.forward, to_it);
    if (std::fabs(thing.depth) < kNearestSprite) return {};
    const SpritePicture picture = picture_of(map, textures, snapshot, presence, pose.eye);
    if (!picture.texture) return {};
    const bool mirrored = (pose.flip < 0) != picture.is_mirrored;
    const double left_of_it = mirrored ? picture.size_m.x - picture.origin_m.x : picture.origin_m.x;
    thing.place = place_of(dot(pose.right, to_it) - left_of_it, picture.size_m.x, thing.depth, mirrored);
    thing.thing = presence.thing;
    thing.position = presence.position;
    thing.id = thing_id(map, presence.thing);
    thing.texture = picture.texture;
    thing.lighting = picture.lighting;
    thing.top = picture.foot_z - pose.eye_z + picture.origin_m.y;
    thing.height = picture.size_m.y;
    thing.shown = {std::max(thing.top - thing.height, room.floor), std::min(thing.top, room.ceiling)};
    if (thing.shown.is_empty()) return {};
    return thing;
}

bool put_on_screen(ThingOnScreen& thing, const Screen& screen) {
    if (thing.depth < kNearestSprite) return false;
    const ColumnRays rays{screen.slopes, screen.per_slope()};
    thing.place.begin = first_column_from(thing.place.left_v.x, thing.depth, rays);
    thing.place.end = first_column_from(thing.place.right_v.x, thing.depth, rays);
    return thing.place.begin < thing.place.end;
}

PanelOnScreen in_view(const Map& map, const Snapshot& snapshot, PanelId id, const Pose& pose) {
    const Panel& panel = map[id];
    const Segment seen = facing(panel, pose.eye);
    const RelativeHeights room = heights_of(snapshot, panel.sector, pose.eye_z);
    PanelOnScreen shown{id, in_view(seen, pose), {}};
    if (seen.a != panel.a) shown.place.swapped = !shown.place.swapped;
    shown.shown = {std::max(panel.bottom - pose.eye_z, room.floor), std::min(panel.top - pose.eye_z, room.ceiling)};
    return shown;
}

}  // namespace enfilade::stencil
