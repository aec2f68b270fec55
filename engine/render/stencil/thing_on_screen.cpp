#include "render/stencil/thing_on_screen.h"

#include <algorithm>
#include <cmath>

namespace enfilade::stencil {
namespace {

/// What is as deep as a thing hides it, as walls do that a thing stands against; in the depth buffer's floats, too.
constexpr double kBehindEquals = 1 + 0x1p-20;

/// The edge between two columns before the first one whose centre is at px or after it.
double column_edge(const Screen& screen, double px) {
    return std::clamp(std::ceil(px - 0.5), 0.0, double(screen.width));
}

WallOnScreen place_of(double left_x, double width, double depth, bool mirrored, const Screen& screen) {
    WallOnScreen place;
    place.left_v = {left_x, depth};
    place.right_v = {left_x + width, depth};
    place.cross = width * depth * kBehindEquals;
    place.swapped = mirrored;
    place.begin_px = column_edge(screen, screen.px_of(left_x / depth));
    place.end_px = column_edge(screen, screen.px_of((left_x + width) / depth));
    return place;
}

}  // namespace

std::optional<ThingOnScreen> on_screen(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                       const Presence& presence, const Eye& eye, const Screen& screen,
                                       double room_floor, double room_ceiling) {
    const Vec2 to_it = presence.position - eye.place;
    ThingOnScreen thing;
    thing.depth = dot(eye.forward, to_it);
    if (thing.depth < kNearestSprite) return {};
    const SpritePicture picture = picture_of(map, textures, snapshot, presence, eye.place);
    if (!picture.texture) return {};
    const bool mirrored = eye.flip < 0;
    const double left_of_it = mirrored ? picture.size_m.x - picture.origin_m.x : picture.origin_m.x;
    thing.place = place_of(dot(eye.right, to_it) - left_of_it, picture.size_m.x, thing.depth, mirrored, screen);
    thing.id = thing_id(map, presence.thing);
    thing.texture = picture.texture;
    thing.light = picture.light;
    thing.top = picture.foot_z - eye.z + picture.origin_m.y;
    thing.height = picture.size_m.y;
    thing.floor = std::max(thing.top - thing.height, room_floor);
    thing.ceiling = std::min(thing.top, room_ceiling);
    if (thing.place.begin_px >= thing.place.end_px || thing.floor >= thing.ceiling) return {};
    return thing;
}

}  // namespace enfilade::stencil
