#include "render/reference/cast_ray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "render/sprite.h"

namespace enfilade {

namespace {

/// What a texel does to what is behind it: hides it, shows it, or mixes with it, each colour in its own way.
std::uint32_t effect_of(const Texture& texture, double u, double v) {
    const std::uint32_t color = texel(texture, place_on_tile(u), place_on_tile(v)).color;
    const std::uint32_t alpha = color & 0xFF000000u;
    return alpha == 0 || alpha == 0xFF000000u ? alpha : color;
}

}  // namespace

bool is_at_rim_of_hole(const Texture& texture, TexelPosition at, Vec2 size_m) {
    constexpr double kFloatError = 0x1p-24;  // of the position [tiles]
    const double u = static_cast<double>(at.u), du = kAmbiguous / size_m.x + kFloatError;
    const double v = static_cast<double>(at.v), dv = kAmbiguous / size_m.y + kFloatError;
    const std::uint32_t effect = effect_of(texture, u - du, v - dv);
    return effect_of(texture, u + du, v - dv) != effect || effect_of(texture, u - du, v + dv) != effect ||
           effect_of(texture, u + du, v + dv) != effect;
}

namespace {

bool is_nearer(const MetPane& a, const MetPane& b) { return depth_steps(a.depth) < depth_steps(b.depth); }

/// Would a shift change the order?
bool is_order_close(const MetPane& a, const MetPane& b) {
    return depth_steps(a.depth + kAmbiguous) > depth_steps(b.depth - kAmbiguous) &&
           depth_steps(a.depth) != depth_steps(b.depth);
}

}  // namespace

void add_room_panes(const ReferenceScene& scene, const RoomRay& ray, PanesMet& met) {
    if (met.is_full(scene)) return;
    std::vector<MetPane> things, panels, all;
    const ThingsCloseBy close = find_things_met(scene, ray, things);
    met.ambiguous |= find_panels_met(scene, ray, panels) || close.hit;
    std::merge(things.begin(), things.end(), panels.begin(), panels.end(), std::back_inserter(all), is_nearer);
    const MetPane* last_hit = nullptr;
    for (const MetPane& next : all) {
        if (met.is_full(scene)) {
            met.ambiguous |= close.passed || is_order_close(*(&next - 1), next);
            return;
        }
        ++met.passed;
        if (!next.is_hit) continue;
        met.ambiguous |= next.pane.ambiguous || (last_hit && is_order_close(*last_hit, next));
        met.panes.push_back(next.pane);
        last_hit = &next;
    }
}

namespace {

/// Is the ray at `height` above the eye, or higher, where it meets the panel? A panel through the eye is met an instant
/// after the start, as a wall is.
bool reaches(const RoomRay& ray, const PanelHit& at, double height) {
    if (at.depth == 0 && height == 0) return ray.course.climb >= 0;
    return (ray.course.climb + kTieClimb) * at.depth >= height;
}

/// A level ray, or a panel through the eye, is compared with a height without any rounding.
bool is_close_to(const RoomRay& ray, const PanelHit& at, double height) {
    if (ray.course.climb == 0 || at.depth == 0) return false;
    return std::fabs(ray.course.climb * at.depth - height) < kAmbiguous;
}

Pane pane_of(const ReferenceScene& scene, const RoomRay& ray, const PanelHit& at) {
    const Panel& panel = scene.map[at.panel];
    const Surface surface = picture_now(scene.snapshot, panel);
    const Texture& texture = scene.textures[surface.texture];
    const double top = panel.top - ray.hit.space.eye_z;
    const double u = at.along * panel.length / surface.tile_m.x - surface.offset_tiles.x;
    const double v = (top - ray.course.climb * at.depth) / surface.tile_m.y - surface.offset_tiles.y;
    const Texel shown = texel(texture, place_on_tile(u), place_on_tile(v));
    const Lighting lighting =
        lighting_in(scene.map, panel.sector, light_at(scene.snapshot, panel.sector), panel.contrast);
    const double depth = at.depth * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = panel_id(scene.map, at.panel);
    pane.seen.depth = depth;
    pane.seen.texel = {fraction(u), fraction(v)};
    pane.alpha = shown.color >> 24;
    const double z = ray.hit.space.eye_z + ray.course.climb * at.depth;
    const LightCell lamplight = scene.lamplight.on_panel(at.panel, at.along * panel.length, z);
    pane.seen.color = in_fog(scene, lit(scene, shown, lighting, depth, lamplight), depth);
    pane.ambiguous = is_at_rim_of_hole(texture, pane.seen.texel, surface.tile_m);
    return pane;
}

}  // namespace

bool find_panels_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    bool ambiguous = false;
    const Heights room = heights_at(scene.snapshot, ray.hit.sector);
    const double eye_z = ray.hit.space.eye_z;
    for (const PanelHit& at : ray.hit.panels) {
        const Panel& panel = scene.map[at.panel];
        const double top = std::min(panel.top, room.ceiling_z) - eye_z;
        const double bottom = std::max(panel.bottom, room.floor_z) - eye_z;
        if (bottom >= top) continue;
        ambiguous |= is_close_to(ray, at, top) || is_close_to(ray, at, bottom);
        const bool is_hit = reaches(ray, at, bottom) && !reaches(ray, at, top);
        met.push_back({at.depth, is_hit, is_hit ? pane_of(scene, ray, at) : Pane{}});
    }
    return ambiguous;
}

namespace {

/// Whether all of several conditions hold, and whether they could do otherwise.
struct Verdict {
    bool holds = true;
    bool possible = true;  ///< all hold, or are so close that they might
    bool certain = true;   ///< all hold, and none is close

    void require(bool condition, bool is_close) {
        holds &= condition;
        possible &= condition || is_close;
        certain &= condition && !is_close;
    }
    bool is_ambiguous() const { return possible && !certain; }
};

bool are_close(double a, double b) { return std::fabs(a - b) < kAmbiguous; }

/// Where the view looks in the space where the ray now is: its course may go another way, by quarters.
Vec2 sight_of(const RoomRay& ray) {
    Vec2 sight = ray.hit.space.forward;
    for (int quarters = ray.course.quarters; quarters > 0; --quarters) sight = -right_of(sight) * ray.hit.space.flip;
    return sight;
}

/// How far along `sight` the ray comes per metre of its course; exactly 1 where it goes that way.
double sight_per_course(const RayCourse& course) {
    const double parts[] = {1, -course.slope, -1, course.slope};
    return parts[course.quarters];
}

bool is_whole(const ReferenceScene& scene) {
    return thing_edges(scene.map.render, scene.is_tilted) == ThingEdges::whole;
}

/// That a picture `away` along the sight and `depth` along the course is in the room, and not too near.
void require_in_room(Verdict& verdict, const RoomRay& ray, double away, double depth) {
    const double entry = ray.entry_depth, exit = ray.hit.depth, d = kAmbiguous;
    const auto is_met = [](double at, double from, double to) { return at > 0 && is_between(at, from, to); };
    const bool is_in_room = is_met(depth, entry, exit);
    verdict.require(is_in_room, is_met(depth + d, entry - d, exit - d) != is_in_room ||
                                    is_met(depth - d, entry + d, exit + d) != is_in_room);
    verdict.require(std::fabs(away) >= kNearestSprite, are_close(std::fabs(away), kNearestSprite));
}

/// The same for a picture that is not cut: its middle is.
void require_middle_in_room(Verdict& verdict, const ReferenceScene& scene, const RoomRay& ray, Vec2 place,
                            double away) {
    const Middle middle{ray.hit.space.eye, ray.hit.space.forward, place, away};
    verdict.require(away >= kNearestSprite, are_close(away, kNearestSprite));
    const auto is_seen = [&](double shift) {
        const RoomCrossing room{ray.entry, ray.hit.wall, ray.entry_depth + shift, ray.hit.depth + shift};
        return is_seen_in(scene.map, scene.snapshot, middle, room);
    };
    verdict.require(is_seen(0), is_seen(kAmbiguous) != is_seen(-kAmbiguous));
}

/// A picture where a ray meets its plane.
struct ThingHit {
    ThingId thing;
    double depth;  ///< along the ray's course [m]
    Vec2 place_m;  ///< from the picture's upper left corner, as it was painted, right and down [m]
    bool is_hit;   ///< else it is passed above or below
    Pane pane;
};

/// Of the picture, above the eye [m].
struct Extent {
    double bottom, top;
};

/// What of the picture is between floor and ceiling, where it is cut there.
Extent shown_of(const ReferenceScene& scene, const RoomRay& ray, const SpritePicture& picture) {
    const Heights room = heights_at(scene.snapshot, ray.hit.sector);
    const double eye_z = ray.hit.space.eye_z, top = picture.foot_z - eye_z + picture.origin_m.y;
    const double bottom = top - picture.size_m.y;
    if (is_whole(scene)) return {bottom, top};
    return {std::max(bottom, room.floor_z - eye_z), std::min(top, room.ceiling_z - eye_z)};
}

/// That the ray passes the picture, however high.
void require_beside(Verdict& verdict, const SpritePicture& picture, const ThingHit& at) {
    verdict.require(at.place_m.x >= 0, are_close(at.place_m.x, 0));
    verdict.require(at.place_m.x < picture.size_m.x, are_close(at.place_m.x, picture.size_m.x));
}

/// That it goes through what is shown of it. height: of the ray above the eye [m].
void require_between(Verdict& verdict, const RoomRay& ray, const Extent& shown, double depth, double height) {
    const double passed = height + kTieClimb * depth;
    const bool is_level = ray.course.climb == 0;  // compared with heights without any rounding
    verdict.require(passed < shown.top, !is_level && are_close(height, shown.top));
    verdict.require(passed >= shown.bottom, !is_level && are_close(height, shown.bottom));
}

/// What the ray sees of the picture, if it goes through it.
Pane pane_of(const ReferenceScene& scene, const RoomRay& ray, const SpritePicture& picture, const ThingHit& at) {
    const Texture& texture = scene.textures[picture.texture];
    const double u = at.place_m.x / picture.size_m.x, v = std::clamp(at.place_m.y / picture.size_m.y, 0.0, 1.0);
    const Texel shown = texel(texture, place_on_picture(std::clamp(u, 0.0, 1.0)), place_on_picture(v));
    const double depth = at.depth * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = thing_id(scene.map, at.thing);
    pane.seen.depth = depth;
    pane.seen.texel = {u, v};
    pane.alpha = shown.color >> 24;
    const LightCell lamplight = scene.lamplight.on_thing(at.thing);
    pane.seen.color = in_fog(scene, lit(scene, shown, picture.lighting, depth, lamplight), depth);
    pane.ambiguous = is_at_rim_of_hole(texture, pane.seen.texel, picture.size_m);
    return pane;
}

/// Adds the meeting if the ray passes the picture. Says where it almost does, or almost does not.
ThingsCloseBy meet(const ReferenceScene& scene, const RoomRay& ray, const Presence& presence,
                   std::vector<ThingHit>& met) {
    const EyeSpace& space = ray.hit.space;
    const Vec2 to_it = presence.position - space.eye;
    const Vec2 sight = sight_of(ray);
    const double away = dot(sight, to_it);
    ThingHit at{presence.thing, away / sight_per_course(ray.course), {}, false, {}};
    Verdict verdict;
    if (is_whole(scene))
        require_middle_in_room(verdict, scene, ray, presence.position, away);
    else
        require_in_room(verdict, ray, away, at.depth);
    if (!verdict.possible) return {};
    const SpritePicture picture = picture_of(scene.map, scene.textures, scene.snapshot, presence, space.eye);
    const Extent shown = shown_of(scene, ray, picture);
    if (!picture.texture || shown.bottom >= shown.top) return {};
    const Vec2 from_it = space.direction(ray.course.slope) * at.depth - to_it;
    const double height = ray.course.climb * at.depth;
    const double aside = dot(right_of(sight), from_it);
    at.place_m = {picture.origin_m.x + (picture.is_mirrored ? -aside : aside),
                  picture.origin_m.y + (picture.foot_z - space.eye_z) - height};
    require_beside(verdict, picture, at);
    const Verdict passed = verdict;
    require_between(verdict, ray, shown, at.depth, height);
    at.is_hit = verdict.holds;
    if (at.is_hit) at.pane = pane_of(scene, ray, picture, at);
    if (passed.holds) met.push_back(at);
    return {passed.is_ambiguous(), verdict.is_ambiguous()};
}

/// Of pictures at the same depth the one of the thing with the lower number is the nearer.
bool is_met_sooner(const ThingHit& a, const ThingHit& b) { return depth_steps(a.depth) < depth_steps(b.depth); }

}  // namespace

ThingsCloseBy find_things_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    ThingsCloseBy close;
    std::vector<ThingHit> meetings;
    for (const Presence& presence : scene.snapshot.things.in(ray.hit.sector)) {
        const ThingsCloseBy here = meet(scene, ray, presence, meetings);
        close.passed |= here.passed;
        close.hit |= here.hit;
    }
    std::stable_sort(meetings.begin(), meetings.end(), is_met_sooner);
    for (const ThingHit& meeting : meetings) met.push_back({meeting.depth, meeting.is_hit, meeting.pane});
    return close;
}

}  // namespace enfilade
