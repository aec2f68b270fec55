#include "render/reference/cast_ray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "render/sprite.h"

namespace enfilade {

namespace {

bool is_met_before(const MetPane& a, const MetPane& b) { return a.steps < b.steps; }

}  // namespace

void add_room_panes(const ReferenceScene& scene, const RoomRay& ray, PanesMet& met) {
    if (met.is_full(scene)) return;
    std::vector<MetPane> things, panels, all;
    find_things_met(scene, ray, things);
    find_panels_met(scene, ray, panels);
    std::merge(things.begin(), things.end(), panels.begin(), panels.end(), std::back_inserter(all), is_met_before);
    for (const MetPane& next : all) {
        if (met.is_full(scene)) return;
        ++met.passed;
        if (next.is_hit) met.panes.push_back(next.pane);
    }
}

namespace {

Pane pane_of(const ReferenceScene& scene, const RoomRay& ray, const PanelHit& at) {
    const Panel& panel = scene.map[at.panel];
    const Surface surface = picture_now(scene.snapshot, panel);
    const Texture& texture = scene.textures[surface.texture];
    const double top = panel.top - ray.hit.space.eye_z;
    const double u = at.along * panel.length / surface.tile_m.x - surface.offset_tiles.x;
    const double v = (top - ray.course.climb * at.depth.value) / surface.tile_m.y - surface.offset_tiles.y;
    const Texel shown = texel(texture, place_on_tile(u), place_on_tile(v));
    const Lighting lighting =
        lighting_in(scene.map, panel.sector, light_at(scene.snapshot, panel.sector), panel.contrast);
    const double depth = at.depth.value * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = panel_id(scene.map, at.panel);
    pane.seen.depth = depth;
    pane.seen.texel = {fraction(u), fraction(v)};
    pane.alpha = shown.color >> 24;
    const double z = ray.hit.space.eye_z + ray.course.climb * at.depth.value;
    const LightCell lamplight = scene.lamplight.on_panel(at.panel, at.along * panel.length, z);
    pane.seen.color = in_fog(scene, lit(scene, shown, lighting, depth, lamplight), depth);
    return pane;
}

}  // namespace

void find_panels_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    const Heights room = heights_at(scene.snapshot, ray.hit.sector);
    const double eye_z = ray.hit.space.eye_z;
    for (const PanelHit& at : ray.hit.panels) {
        const Panel& panel = scene.map[at.panel];
        const double top = std::min(panel.top, room.ceiling_z) - eye_z;
        const double bottom = std::max(panel.bottom, room.floor_z) - eye_z;
        if (bottom >= top) continue;
        const RowClimb& climb = ray.course.tied_climb;
        const bool is_hit = reaches(climb, at.depth, bottom) && !reaches(climb, at.depth, top);
        met.push_back({depth_steps(at.depth), is_hit, is_hit ? pane_of(scene, ray, at) : Pane{}});
    }
}

namespace {

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

/// How far to the right of the sight the ray comes per metre of its course.
double right_per_course(const RayCourse& course) {
    const double parts[] = {course.slope, 1, -course.slope, -1};
    return parts[course.quarters];
}

/// Whether a picture `away` along the sight and `depth` along the course is seen in the room.
bool is_in_room(const ReferenceScene& scene, const RoomRay& ray, Vec2 place, double away, double depth) {
    const std::int64_t steps = depth_steps(depth);
    const RoomCrossing room{ray.entry, ray.hit.wall, ray.entry_steps > steps, depth_steps(ray.hit.depth) > steps};
    if (!is_whole(scene)) return std::fabs(away) >= kNearestSprite && depth > 0 && room.holds_thing();
    const Middle middle{ray.hit.space.eye, ray.hit.space.forward, place, away};
    return away >= kNearestSprite && is_seen_in(scene.map, scene.snapshot, middle, room);
}

/// A picture where a ray meets its plane.
struct ThingHit {
    ThingId thing;
    double depth;   ///< along the ray's course [m]
    double along;   ///< from the picture's left edge to its right one, as it was painted, 0..1
    double down_m;  ///< from its upper edge [m]
    bool is_hit;    ///< else it is passed above or below
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

/// What the ray sees of the picture, if it goes through it.
Pane pane_of(const ReferenceScene& scene, const RoomRay& ray, const SpritePicture& picture, const ThingHit& at) {
    const Texture& texture = scene.textures[picture.texture];
    const double u = std::clamp(at.along, 0.0, 1.0), v = std::clamp(at.down_m / picture.size_m.y, 0.0, 1.0);
    const Texel shown = texel(texture, place_on_picture(u), place_on_picture(v));
    const double depth = at.depth * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = thing_id(scene.map, at.thing);
    pane.seen.depth = depth;
    pane.seen.texel = {u, v};
    pane.alpha = shown.color >> 24;
    const LightCell lamplight = scene.lamplight.on_thing(at.thing);
    pane.seen.color = in_fog(scene, lit(scene, shown, picture.lighting, depth, lamplight), depth);
    return pane;
}

/// Adds the meeting if the ray passes the picture, at any height.
void meet(const ReferenceScene& scene, const RoomRay& ray, const Presence& presence, std::vector<ThingHit>& met) {
    const Pose& space = ray.hit.space;
    const Vec2 to_it = presence.position - space.eye, sight = sight_of(ray);
    const double away = dot(sight, to_it), depth = away / sight_per_course(ray.course);
    if (!is_in_room(scene, ray, presence.position, away, depth)) return;
    const SpritePicture picture = picture_of(scene.map, scene.textures, scene.snapshot, presence, space.eye);
    const Extent shown = shown_of(scene, ray, picture);
    if (!picture.texture || shown.bottom >= shown.top) return;
    const SpriteSpan span = span_of(picture, dot(right_of(sight) * space.flip, to_it), space.flip);
    const double met_x_v = right_per_course(ray.course) * depth;
    if (!span.covers(met_x_v)) return;
    const double top = picture.foot_z - space.eye_z + picture.origin_m.y;
    ThingHit at{presence.thing, depth, span.along(met_x_v), top - ray.course.climb * depth, false, {}};
    const RowClimb& climb = ray.course.tied_climb;
    at.is_hit = reaches(climb, {depth}, shown.bottom) && !reaches(climb, {depth}, shown.top);
    if (at.is_hit) at.pane = pane_of(scene, ray, picture, at);
    met.push_back(at);
}

/// Of pictures at the same depth the one of the thing with the lower number is the nearer.
bool is_met_sooner(const ThingHit& a, const ThingHit& b) { return depth_steps(a.depth) < depth_steps(b.depth); }

}  // namespace

void find_things_met(const ReferenceScene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    std::vector<ThingHit> meetings;
    for (const Presence& presence : scene.snapshot.things.in(ray.hit.sector)) meet(scene, ray, presence, meetings);
    std::stable_sort(meetings.begin(), meetings.end(), is_met_sooner);
    for (const ThingHit& meeting : meetings) met.push_back({depth_steps(meeting.depth), meeting.is_hit, meeting.pane});
}

}  // namespace enfilade
