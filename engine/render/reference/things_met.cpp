#include "render/reference/things_met.h"

#include <algorithm>
#include <cmath>

#include "render/sprite.h"

namespace enfilade {
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

bool is_whole(const Scene& scene) { return thing_edges(scene.map.render, scene.is_tilted) == ThingEdges::whole; }

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
void require_middle_in_room(Verdict& verdict, const Scene& scene, const RoomRay& ray, Vec2 place, double away) {
    const Middle middle{ray.hit.space.eye, ray.hit.space.forward, place, away};
    verdict.require(away >= kNearestSprite, are_close(away, kNearestSprite));
    const auto is_seen = [&](double shift) {
        const RoomCrossing room{ray.entry, ray.hit.wall, ray.entry_depth + shift, ray.hit.depth + shift};
        return is_seen_in(scene.map, scene.snapshot, middle, room);
    };
    verdict.require(is_seen(0), is_seen(kAmbiguous) != is_seen(-kAmbiguous));
}

/// A picture where a ray meets its plane.
struct Meeting {
    ThingId thing;
    double depth;  ///< along the ray's course [m]
    Vec2 place_m;  ///< from the picture's upper left corner, as it was painted, right and down [m]
    Pane pane;
};

/// That the ray goes through the picture, if that is cut between floor and ceiling. height: of the ray above the eye
/// [m].
void require_on_picture(Verdict& verdict, const Scene& scene, const RoomRay& ray, const SpritePicture& picture,
                        const Meeting& at, double height) {
    const Heights room = heights_at(scene.snapshot, ray.hit.sector);
    const double eye_z = ray.hit.space.eye_z, top = picture.foot_z - eye_z + picture.origin_m.y;
    const double bottom = top - picture.size_m.y;
    verdict.require(at.place_m.x >= 0, are_close(at.place_m.x, 0));
    verdict.require(at.place_m.x < picture.size_m.x, are_close(at.place_m.x, picture.size_m.x));
    const double passed = height + kTieClimb * at.depth;
    const bool is_level = ray.course.climb == 0;  // compared with heights without any rounding
    const auto require_between = [&](double lower, double upper) {
        verdict.require(passed < upper, !is_level && are_close(height, upper));
        verdict.require(passed >= lower, !is_level && are_close(height, lower));
    };
    require_between(bottom, top);
    if (!is_whole(scene)) require_between(room.floor_z - eye_z, room.ceiling_z - eye_z);
}

/// What the ray sees of the picture, if it goes through it.
Pane pane_of(const Scene& scene, const RoomRay& ray, const SpritePicture& picture, const Meeting& at) {
    const Texture& texture = scene.textures[picture.texture];
    const double u = at.place_m.x / picture.size_m.x, v = std::clamp(at.place_m.y / picture.size_m.y, 0.0, 1.0);
    const Texel shown = texel(texture, place_on_picture(std::clamp(u, 0.0, 1.0)), place_on_picture(v));
    const double depth = at.depth * ray.course.depth_scale;
    Pane pane;
    pane.seen.id = thing_id(scene.map, at.thing);
    pane.seen.depth = depth;
    pane.seen.texel = {static_cast<float>(u), static_cast<float>(v)};
    pane.alpha = shown.color >> 24;
    const LightGrid* grid = scene.lights ? scene.lights->on_thing(scene.map, scene.snapshot, at.thing) : nullptr;
    pane.seen.color = lit(scene, shown, picture.lighting, depth, glow_on(grid, 0, 0));
    pane.ambiguous = is_at_rim_of_hole(texture, pane.seen.texel, picture.size_m);
    return pane;
}

/// Adds the meeting if the ray goes through the picture. True where it almost does, or almost does not.
bool meet(const Scene& scene, const RoomRay& ray, const Presence& presence, std::vector<Meeting>& met) {
    const EyeSpace& space = ray.hit.space;
    const Vec2 to_it = presence.position - space.eye;
    const Vec2 sight = sight_of(ray);
    const double away = dot(sight, to_it);
    Meeting at{presence.thing, away / sight_per_course(ray.course), {}, {}};
    Verdict verdict;
    if (is_whole(scene))
        require_middle_in_room(verdict, scene, ray, presence.position, away);
    else
        require_in_room(verdict, ray, away, at.depth);
    if (!verdict.possible) return false;
    const SpritePicture picture = picture_of(scene.map, scene.textures, scene.snapshot, presence, space.eye);
    if (!picture.texture) return false;
    const Vec2 from_it = space.direction(ray.course.slope) * at.depth - to_it;
    const double height = ray.course.climb * at.depth;
    const double aside = dot(right_of(sight), from_it);
    at.place_m = {picture.origin_m.x + (picture.is_mirrored ? -aside : aside),
                  picture.origin_m.y + (picture.foot_z - space.eye_z) - height};
    require_on_picture(verdict, scene, ray, picture, at, height);
    if (verdict.holds) {
        at.pane = pane_of(scene, ray, picture, at);
        met.push_back(at);
    }
    return verdict.is_ambiguous();
}

/// Of pictures at the same depth the one of the thing with the lower number is the nearer.
bool is_nearer(const Meeting& a, const Meeting& b) { return depth_steps(a.depth) < depth_steps(b.depth); }

}  // namespace

bool find_things_met(const Scene& scene, const RoomRay& ray, std::vector<MetPane>& met) {
    bool ambiguous = false;
    std::vector<Meeting> meetings;
    for (const Presence& presence : scene.snapshot.things.in(ray.hit.sector))
        ambiguous |= meet(scene, ray, presence, meetings);
    std::stable_sort(meetings.begin(), meetings.end(), is_nearer);
    for (const Meeting& meeting : meetings) met.push_back({meeting.depth, meeting.pane});
    return ambiguous;
}

}  // namespace enfilade
