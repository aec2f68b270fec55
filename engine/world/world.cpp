#include "world/world.h"

#include <algorithm>

#include "base/hash.h"
#include "formats/text_parts.h"
#include "math/vec.h"
#include "world/trigger_actions.h"

namespace enfilade {

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

std::optional<World> start_of(const Map& map) {
    if (!map.player) return {};
    World world;
    world.history = begun(map);
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
