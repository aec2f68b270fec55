#include "world/trigger_actions.h"

#include <algorithm>

#include "math/predicates.h"

namespace enfilade {
namespace {

void tell(World& world, PlayerMessageKind kind, std::uint32_t number = 0) {
    world.message = PlayerMessage{kind, number, world.tick};
}

bool has_key(const World& world, std::uint32_t key) { return key == Trigger::kNoKey || (world.keys >> key & 1); }

/// Calls visit(id) for each trigger of a range that the activation is right for.
template <class Visit>
void each_on(const Map& map, TriggerRange range, Activation on, Visit visit) {
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
        if (map.triggers[i].on == on) visit(TriggerId(i));
}

bool has_on(const Map& map, TriggerRange range, Activation on) {
    bool has = false;
    each_on(map, range, on, [&](TriggerId) { has = true; });
    return has;
}

/// The triggers of the sector behind, which one uses as well: not through a way back, which may be shut.
TriggerRange triggers_behind(const Map& map, const Wall& wall) {
    return wall.behind && wall.kind != WallKind::way_back ? map[wall.behind].triggers : TriggerRange();
}

bool can_be_used(const Map& map, const Wall& wall) {
    return has_on(map, wall.triggers, Activation::use) || has_on(map, triggers_behind(map, wall), Activation::use);
}

/// Whether a trigger of a panel works from the side that somebody comes from.
bool works_from(const Map& map, TriggerId trigger, const MetPanel& met) {
    return !map[trigger].one_way || !met.from_behind;
}

bool can_be_used(const Map& map, const MetPanel& met) {
    bool can = false;
    each_on(map, map[met.panel].triggers, Activation::use, [&](TriggerId id) { can |= works_from(map, id, met); });
    return can;
}

void fire_all(const Map& map, World& world, const MetPanel& met, Activation on) {
    each_on(map, map[met.panel].triggers, on, [&](TriggerId id) {
        if (works_from(map, id, met)) fire(map, world, id, WallId());
    });
}

void use(const Map& map, World& world, WallId id) {
    const Wall& wall = map[id];
    each_on(map, wall.triggers, Activation::use, [&](TriggerId trigger) { fire(map, world, trigger, id); });
    each_on(map, triggers_behind(map, wall), Activation::use,
            [&](TriggerId trigger) { fire(map, world, trigger, id); });
}

void shut_way_back(World& world) {
    if (world.history.way_back(static_cast<double>(world.tick))) world.history.add(WayBack{{}, world.tick});
}

/// The way back that the door leaves is there from the beginning of the tick: an eye between the two ticks may be
/// behind the door already.
void open_way_back(const Map& map, World& world, WallId door) {
    const std::optional<WallId> left = way_back_left(map, door);
    if (!left) return;
    shut_way_back(world);
    if (*left) world.history.add(WayBack{*left, world.tick - 1});
}

void cross(const Map& map, World& world, WallId id) {
    const Wall& wall = map[id];
    open_way_back(map, world, id);
    each_on(map, wall.triggers, Activation::cross, [&](TriggerId trigger) { fire(map, world, trigger, id); });
    if (wall.exit)
        each_on(map, map[wall.exit].triggers, Activation::cross, [&](TriggerId trigger) {
            if (!map[trigger].one_way) fire(map, world, trigger, wall.exit);
        });
    each_on(map, map[wall.behind].triggers, Activation::enter,
            [&](TriggerId trigger) { fire(map, world, trigger, WallId()); });
}

/// False where the player was carried off by a teleport.
bool cross(const Map& map, World& world, const Crossing& crossing) {
    const Place before = world.player.place;
    if (crossing.portal)
        cross(map, world, crossing.portal);
    else
        fire_all(map, world, crossing.through, Activation::cross);
    return world.player.place == before;
}

/// Things that the player touches: their discs overlap, and they are neither above nor below.
ShortList<ThingId, 16> things_touched(const Map& map, const World& world) {
    ShortList<ThingId, 16> found;
    const Instant at = now(map, world);
    if (map.touchables.empty()) return found;
    const PlacedBody placed = placed_body_of(at, world.player);
    const Body& body = placed.body;
    for (const ReachedSector& reached : placed.around.sectors) {
        const Sector& sector = map[reached.sector];
        const Vec2 centre = snap_to_point_grid(reached.passage.apply(body.place.point));
        for (std::uint32_t i = sector.first_touchable; i < sector.first_touchable + sector.touchable_count; ++i) {
            const ThingId id = map.touchables[i];
            const Thing& thing = map[id];
            if (world.history.is_taken(id, at.tick)) continue;
            if (!segment_is_nearer(thing.position, thing.position, centre, thing.radius + kBodyRadius + kPointGrid))
                continue;
            const double foot = foot_of(at, id) - reached.passage.rise;
            if (foot < body.feet_z + body.height && foot + thing.height > body.feet_z) found.push_back(id);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase_from(std::unique(found.begin(), found.end()));
    return found;
}

/// Stands the player where the thing is; nothing is drawn of the way there. What it arrives in counts as touched, so
/// that two things which teleport to each other do not throw it to and fro.
void teleport(const Map& map, World& world, ThingId destination) {
    const Thing& there = map[destination];
    const Heights room = heights_of(now(map, world), there.sector);
    const double eye_z = room.floor_z + eye_height(kStandingHeight);
    const Player arrived = player_at(now(map, world), {there.sector, there.position, eye_z, there.yaw});
    world.player = world.before = arrived;
    world.passage = {};
    shut_way_back(world);
    const ShortList<ThingId, 16> touched = things_touched(map, world);
    world.touched.assign(touched.begin(), touched.end());
}

/// Who is well leaves what heals.
void pick_up(const Map& map, World& world, ThingId id) {
    const Thing& thing = map[id];
    const bool is_new_key = thing.gives_key != Trigger::kNoKey && !has_key(world, thing.gives_key);
    const bool heals = thing.gives_health > 0 && world.health < kFullHealth;
    if (!is_new_key && !heals) return;
    if (is_new_key) {
        world.keys |= std::uint64_t{1} << thing.gives_key;
        tell(world, PlayerMessageKind::got_key, thing.gives_key);
    }
    if (heals) {
        world.health = std::min(world.health + thing.gives_health, kFullHealth);
        tell(world, PlayerMessageKind::healed);
    }
    world.history.add(Pickup{id, world.tick});
}

}  // namespace

void fire(const Map& map, World& world, TriggerId id, WallId wall) {
    const Trigger& trigger = map[id];
    if (trigger.once && world.history.has_fired(id)) return;
    if (!has_key(world, trigger.key)) return tell(world, PlayerMessageKind::needs_key, trigger.key);
    if (!carry_out(map, world.history, id, world.tick)) return;
    world.history.add(Firing{id, wall, world.tick});
    if (trigger.action == TriggerAction::teleport) return teleport(map, world, trigger.destination);
    if (trigger.action == TriggerAction::leave_map) world.left_by = id;
}

void use_what_is_ahead(const Map& map, World& world) {
    if (map.triggers.empty()) return;
    const Instant at = now(map, world);
    const Vec2 reach = direction(world.player.yaw) * kArm;
    const auto may_reach = [&](WallId wall, const Rigid&) { return !can_be_used(map, map[wall]) && is_open(at, wall); };
    const auto may_reach_past = [&](const MetPanel& met) { return !can_be_used(map, met); };
    const Vec2 hand = snap_to_point_grid(world.player.place.point + reach);
    const Trace ahead = trace(map, world.player.place, hand, may_reach, may_reach_past);
    if (ahead.barrier.panel) fire_all(map, world, ahead.barrier, Activation::use);
    if (ahead.stopped && can_be_used(map, map[ahead.stopped])) use(map, world, ahead.stopped);
}

void pass(const Map& map, World& world, std::span<const Crossing> crossings) {
    if (map.triggers.empty() && !map.has_ways_back) return;
    for (const Crossing& crossing : crossings)
        if (!cross(map, world, crossing)) return;
}

void touch_what_is_near(const Map& map, World& world) {
    if (map.touchables.empty()) return;
    ShortList<ThingId, 16> before;
    before.append(world.touched);
    const ShortList<ThingId, 16> touched = things_touched(map, world);
    world.touched.assign(touched.begin(), touched.end());
    for (const ThingId id : touched) {
        pick_up(map, world, id);
        if (std::binary_search(before.begin(), before.end(), id)) continue;
        each_on(map, map[id].triggers, Activation::touch,
                [&](TriggerId trigger) { fire(map, world, trigger, WallId()); });
    }
}

}  // namespace enfilade
