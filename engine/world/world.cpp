#include "world/world.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "formats/text_parts.h"
#include "math/vec.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

constexpr double kStandingEye = 1.55, kCrouchedEye = 0.85;  ///< above the feet [m]

/// Tries to leave walls that are nearer than the radius. In a room that is narrower than the body there is nothing to
/// be won; a few tries find the way out of a corner.
constexpr int kTriesToGetFree = 8;

/// Rounding that a place which was moved off a wall may lose again [grid steps].
constexpr double kStepsToSpare = 4;

/// The way off the nearest of the walls found.
struct WayOff {
    Vec2 direction;                 ///< unit vector
    double distance = kWorldLimit;  ///< from the wall [m]
};

WayOff way_off(const ReachedWall& reached) {
    const Vec2 away = reached.centre - nearest_point(reached.stretch, reached.centre);
    const double distance = std::sqrt(dot(away, away));
    const Vec2 along = reached.b - reached.a;
    const Vec2 direction = distance > 0 ? away * (1 / distance) : right_of(along) * (1 / std::sqrt(dot(along, along)));
    return {inverse(reached.passage).turn(direction), distance};
}

WayOff way_off_nearest(const Reach& found) {
    WayOff nearest;
    for (const ReachedWall& reached : found.walls) {
        const WayOff off = way_off(reached);
        if (off.distance < nearest.distance) nearest = off;
    }
    return nearest;
}

/// The body, which is as wide as there is room, moved to a full radius from the wall that is nearest.
Body moved_off(const Instant& now, const Body& narrow) {
    Body wide = narrow;
    wide.radius = kBodyRadius;
    const WayOff off = way_off_nearest(around(now, wide));
    const double by = kBodyRadius - off.distance + kStepsToSpare * kPointGrid;
    // Not through a link: then heights and yaw would have to follow.
    const auto may_pass = [&](WallId portal, const Rigid& passage) {
        return now.map[portal].link == Wall::kNoLink && can_pass(now, narrow, portal, passage);
    };
    const Vec2 target = snap_to_point_grid(narrow.place.point + off.direction * by);
    wide.place = trace(now.map, narrow.place, target, may_pass, bodies_may_cross(now.map)).end;
    return squeezed(now, wide);
}

/// The widest body found on the way off walls that are nearer than its radius.
Body moved_free(const Instant& now, const Body& body) {
    Body best = squeezed(now, body), last = best;
    for (int i = 0; i < kTriesToGetFree && best.radius < kBodyRadius; ++i) {
        last = moved_off(now, last);
        if (last.radius > best.radius) best = last;
    }
    return best;
}

}  // namespace

double eye_height(double height) {
    if (height < kCrouchedHeight) return kCrouchedEye * height;
    const double standing = (height - kCrouchedHeight) / (kStandingHeight - kCrouchedHeight);
    return kCrouchedEye + (kStandingEye - kCrouchedEye) * standing;
}

PlacedBody placed_body_of(const Instant& now, const Player& player) {
    return placed(now, {player.place, player.feet_z, player.height, kBodyRadius, kWorldLimit});
}

Clearance come_to_rest(const Instant& now, Player& player) {
    Clearance free{};
    double footing_z = 0;
    for (int lifts = 0; lifts <= kMostLifts; ++lifts) {
        const PlacedBody there = placed_body_of(now, player);
        free = there.free;
        footing_z = std::max(free.floor_z, lowest_feet_in(now, there.entered));
        const double feet_z = std::max(player.feet_z, free.floor_z);
        const double height = std::clamp(free.ceiling_z - feet_z, 0.0, player.height);
        if (feet_z == player.feet_z && height == player.height) break;
        player.eye_lag -= feet_z - player.feet_z;
        player.feet_z = feet_z;
        player.height = height;
    }
    player.on_ground = player.feet_z <= footing_z;
    if (player.on_ground) player.fall_speed = 0;
    return free;
}

double eye_z_of(const Player& player, double ceiling_z) {
    const double feet_to_eye = eye_height(player.height);
    const double highest = std::max(player.feet_z + feet_to_eye, ceiling_z - kEyeBelowCeiling);
    const double lowest = player.feet_z + std::min(feet_to_eye, kEyeBelowCeiling);
    return std::clamp(player.feet_z + feet_to_eye + player.eye_lag, lowest, highest);
}

Player player_at(const Instant& now, const PlayerStart& start) {
    const Heights here = heights_of(now, start.sector);
    Body body{{start.sector, start.position}, start.eye_z - kStandingEye, kStandingHeight, kBodyRadius, kWorldLimit};
    body.feet_z = std::max(here.floor_z, std::min(body.feet_z, here.ceiling_z - body.height));
    body = moved_free(now, body);

    Player player;
    player.place = body.place;
    player.height = body.height;
    player.feet_z = body.feet_z;
    const Clearance free = come_to_rest(now, player);
    player.eye_lag = 0;
    player.yaw = start.yaw;
    player.eye_z = eye_z_of(player, free.ceiling_z);
    return player;
}

namespace {

template <class Tag>
std::uint64_t digest(const std::vector<Id<Tag>>& ids) {
    Hash hash;
    for (const Id<Tag> id : ids) hash.add(id.index);
    return hash.value();
}

/// Calls visit(name, value of a, value of b) for everything that the state consists of, in a fixed order.
template <class Visit>
void each_value(const World& a, const World& b, Visit visit) {
    const Player &p = a.player, &q = b.player;
    visit("tick", a.tick, b.tick);
    visit("player.sector", p.place.sector.index, q.place.sector.index);
    visit("player.x", p.place.point.x, q.place.point.x);
    visit("player.y", p.place.point.y, q.place.point.y);
    visit("player.feet_z", p.feet_z, q.feet_z);
    visit("player.velocity.x", p.velocity.x, q.velocity.x);
    visit("player.velocity.y", p.velocity.y, q.velocity.y);
    visit("player.fall_speed", p.fall_speed, q.fall_speed);
    visit("player.height", p.height, q.height);
    visit("player.eye_lag", p.eye_lag, q.eye_lag);
    visit("player.eye_z", p.eye_z, q.eye_z);
    visit("player.yaw", p.yaw.steps, q.yaw.steps);
    visit("player.yaw_rest", p.yaw_rest, q.yaw_rest);
    visit("player.pitch", p.pitch_steps, q.pitch_steps);
    visit("player.on_ground", p.on_ground, q.on_ground);
    visit("history", a.history.digest(), b.history.digest());
    visit("health", a.health, b.health);
    visit("keys", a.keys, b.keys);
    visit("held", std::uint32_t{a.held}, std::uint32_t{b.held});
    visit("touched", digest(a.touched), digest(b.touched));
    visit("secrets", digest(a.secrets), digest(b.secrets));
    visit("left_by", a.left_by.value_or(TriggerId()).index, b.left_by.value_or(TriggerId()).index);
}

std::string text(double x) { return number_text(x); }
std::string text(bool x) { return x ? "yes" : "no"; }
template <class Whole>
std::string text(Whole x) {
    return std::to_string(x);
}

}  // namespace

std::optional<World> start_of(const Map& map, const MotionDials& motion) {
    if (!map.player) return {};
    World world;
    world.history = begun(map, motion);
    world.player = world.before = player_at(now(map, world), *map.player);
    return world;
}

std::uint64_t hash(const World& world) {
    Hash sum;
    each_value(world, world, [&](const char*, auto value, auto) { sum.add(value); });
    return sum.value();
}

std::string difference(const World& a, const World& b) {
    std::string lines;
    each_value(a, b, [&](const char* name, auto x, auto y) {
        if (x != y) lines += std::string(name) + ": " + text(x) + " / " + text(y) + "\n";
    });
    return lines;
}

namespace {

double between(double a, double b, double part) { return a + (b - a) * part; }

/// Over the shorter arc.
Angle between(Angle a, Angle b, double part) {
    const auto arc = static_cast<std::int32_t>((b - a).steps);
    return {a.steps + static_cast<std::uint32_t>(static_cast<std::int64_t>(arc * part))};
}

Angle turn_of(const Rigid& passage) { return angle_of({passage.c, passage.s}); }

}  // namespace

Eye eye_between_ticks(const Map& map, const World& world, double part) {
    const Player &before = world.before, &now = world.player;
    if (part >= 1) return {now.place, now.eye_z, now.yaw, now.pitch_steps};
    // In the space of the tick before; from there the eye goes its way again.
    const Rigid back = inverse(world.passage);
    const Vec2 way = back.apply(now.place.point) - before.place.point;
    const Instant then{map, world.history, static_cast<double>(world.tick) - 1 + part};
    const Trace path = trace(map, before.place, snap_to_point_grid(before.place.point + way * part),
                             [&](WallId portal, const Rigid&) { return is_portal(then, portal); });
    const double z = between(before.eye_z, back.apply_height(now.eye_z), part) + path.passage.rise;
    const Heights here = heights_of(then, path.end.sector);
    return {path.end, std::max(here.floor_z, std::min(z, here.ceiling_z)),
            between(before.yaw, now.yaw - turn_of(world.passage), part) + turn_of(path.passage),
            static_cast<std::int32_t>(between(before.pitch_steps, now.pitch_steps, part))};
}

}  // namespace enfilade
