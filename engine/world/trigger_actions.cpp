#include "world/trigger_actions.h"

#include <algorithm>
#include <limits>

#include "world/input.h"
#include "world/instant.h"

namespace enfilade {
namespace {

/// Longest wait [s]: a day, as much as maps may ask for.
constexpr double kLongestWait = 86400;

std::uint32_t ticks_of(double seconds, TickRate rate) {
    const double per_second = ticks_per_second(rate);
    return static_cast<std::uint32_t>(std::min(seconds * per_second + 0.5, kLongestWait * per_second));
}

/// Everything an action may ask about one target.
struct ActionTarget {
    const Instant& now;
    const Trigger& trigger;
    SectorId sector;     ///< that leads its group
    std::size_t number;  ///< among the targets
    Heights here;

    double per_tick() const { return trigger.speed / ticks_per_second(rate_of(now)); }
    std::uint32_t wait() const { return ticks_of(trigger.wait_s, rate_of(now)); }
    Stop stop(double z) const { return {z, per_tick(), 0}; }
    Stop stop_and_wait(double z) const { return {z, per_tick(), wait()}; }
    double around(HeightLevel level, double here_z) const { return height_of(now, sector, level, here_z); }

    /// Where the floor or ceiling is told to go.
    double goal(double here_z) const {
        if (trigger.z) return *trigger.z + trigger.by;
        if (trigger.like) return heights_of(now, trigger.like).floor_z + trigger.by;
        return around(trigger.to, here_z) + trigger.by;
    }
    double door_top() const { return around(HeightLevel::lowest_ceiling, here.ceiling_z) - kDoorHead; }
};

Track once(double from, Stop stop) { return {0, from, {stop, {}}, 1, false}; }
Track there_and_back(double from, Stop first, Stop second) { return {0, from, {first, second}, 2, false}; }
Track to_and_fro(double from, Stop first, Stop second) { return {0, from, {first, second}, 2, true}; }

Track door_track(const ActionTarget& t) {
    return there_and_back(t.here.ceiling_z, t.stop_and_wait(t.door_top()), t.stop(t.here.floor_z));
}

bool moves_doors(TriggerAction action) {
    return action == TriggerAction::door || action == TriggerAction::open || action == TriggerAction::close ||
           action == TriggerAction::close_then_open;
}

/// A door on its way, or waiting, as whoever uses it finds it.
struct DoorUnderWay {
    TriggerAction action;  ///< what set it off
    bool comes_down;
    bool has_two_ways;  ///< it goes on after a wait
    Stop up, down;
};

DoorUnderWay door_under_way(const ActionTarget& t, const Change& change) {
    const Track& old = change.track;
    const std::size_t heading = std::min<std::size_t>(stop_at(old, t.now.tick), old.count - 1u);
    const Stop& next = old.stops[heading];
    DoorUnderWay door{t.now.map[change.cause].action, next.value < t.here.ceiling_z, old.count == 2, {}, {}};
    door.up = {t.door_top(), next.per_tick, door.action == TriggerAction::door ? t.wait() : 0};
    door.down = {t.here.floor_z, next.per_tick, 0};
    if (!door.has_two_ways) return door;
    const std::size_t lower = door.action == TriggerAction::door ? 1 : 0;
    door.comes_down &= heading == lower;
    door.down = old.stops[lower];
    door.up = old.stops[1 - lower];
    return door;
}

/// A door that is used while it moves or waits, whatever set it off: one that comes down turns round, any other comes
/// down, as fast as it went. What would have gone on after a wait still does.
Track used_again(const ActionTarget& t, const Change& under_way) {
    const DoorUnderWay door = door_under_way(t, under_way);
    const double z = t.here.ceiling_z;
    if (door.comes_down)
        return door.action == TriggerAction::door ? there_and_back(z, door.up, door.down) : once(z, door.up);
    const bool opens_again = door.action == TriggerAction::close_then_open && door.has_two_ways;
    return opens_again ? there_and_back(z, door.down, door.up) : once(z, door.down);
}

Track shuttle_track(const ActionTarget& t) {
    const double high = std::max(t.here.floor_z, t.around(HeightLevel::highest_floor, t.here.floor_z));
    return to_and_fro(t.here.floor_z, t.stop_and_wait(t.around(HeightLevel::lowest_floor, t.here.floor_z)),
                      t.stop_and_wait(high));
}

/// Up to where it was when it was called first.
Track crush_track(const ActionTarget& t) {
    double top = t.here.ceiling_z;
    for (const Change* old = t.now.history->newest_of(t.sector, Channel::ceiling); old;
         old = old->before == Change::kNone ? nullptr : &t.now.history->changes()[old->before])
        if (!old->holds_up_bob() && t.now.map[old->cause].action == TriggerAction::crush && old->track.count == 2)
            top = std::max({top, old->track.stops[0].value, old->track.stops[1].value});
    return to_and_fro(t.here.ceiling_z, t.stop(t.here.floor_z + kCrushedHeight), t.stop(top));
}

/// Each stair is one step higher than the one before, whatever it was before.
Track stair_track(const ActionTarget& t) {
    const double first = heights_of(t.now, t.now.map.targets_of(t.trigger).front()).floor_z;
    return once(t.here.floor_z, t.stop(first + t.trigger.step * static_cast<double>(t.number + 1)));
}

/// What is left of a track that is at z, on its way to a stop.
Track rest_of(const Track& track, double z, std::uint8_t heading) {
    const Stop next = track.stops[heading], other = track.stops[1 - heading];
    return heading == 0 || track.loops ? Track{0, z, {next, other}, track.count, track.loops} : once(z, next);
}

/// The level it gets, at once.
Track light_track(const ActionTarget& t) {
    const double now = plain_light_of(t.now, t.sector);
    const double level = t.trigger.light                           ? *t.trigger.light
                         : t.trigger.light_of != LightLevel::given ? light_of(t.now, t.sector, t.trigger.light_of)
                                                                   : now;
    return once(now, {level, std::numeric_limits<double>::infinity(), 0});
}

Channel channel_of(TriggerAction action) {
    switch (action) {
        case TriggerAction::lift:
        case TriggerAction::shuttle:
        case TriggerAction::floor:
        case TriggerAction::stairs: return Channel::floor;
        case TriggerAction::light: return Channel::light;
        default: return Channel::ceiling;
    }
}

Track track_of(const ActionTarget& t) {
    const double floor_z = t.here.floor_z, ceiling_z = t.here.ceiling_z;
    switch (t.trigger.action) {
        case TriggerAction::door: return door_track(t);
        case TriggerAction::open: return once(ceiling_z, t.stop(t.door_top()));
        case TriggerAction::close: return once(ceiling_z, t.stop(floor_z));
        case TriggerAction::close_then_open:
            return there_and_back(ceiling_z, t.stop_and_wait(floor_z), t.stop(ceiling_z));
        case TriggerAction::lift:
            return there_and_back(floor_z, t.stop_and_wait(t.around(HeightLevel::lowest_floor, floor_z)),
                                  t.stop(floor_z));
        case TriggerAction::shuttle: return shuttle_track(t);
        case TriggerAction::floor: return once(floor_z, t.stop(t.goal(floor_z)));
        case TriggerAction::ceiling: return once(ceiling_z, t.stop(t.goal(ceiling_z)));
        case TriggerAction::crush: return crush_track(t);
        case TriggerAction::stairs: return stair_track(t);
        case TriggerAction::light: return light_track(t);
        default: return {};
    }
}

bool crushes(const Trigger& trigger) { return trigger.crushes || trigger.action == TriggerAction::crush; }

bool stops_at(const Trigger& trigger, const Thing& thing) {
    if (thing.holds_up == HoldsUp::nothing) return false;
    return thing.holds_up == HoldsUp::all || !crushes(trigger);
}

/// How high the tallest of the solid things that it stops at is, as far as there is room for it now [m].
double tallest_thing(const ActionTarget& t) {
    const Map& map = t.now.map;
    double tallest = 0;
    each_of_group(map, t.sector, [&](SectorId member) {
        const Sector& sector = map[member];
        for (std::uint32_t i = sector.first_solid; i < sector.first_solid + sector.solid_count; ++i)
            if (const Thing& thing = map[map.solid_things[i]]; stops_at(t.trigger, thing))
                tallest = std::max(tallest, thing.height);
    });
    return std::min(tallest, t.here.ceiling_z - t.here.floor_z);
}

/// The track, stopping short of solid things and of the other side of the room.
void clip(const ActionTarget& t, Channel channel, Track& track) {
    if (channel == Channel::light) return;
    const double room = tallest_thing(t);
    for (std::uint8_t i = 0; i < track.count; ++i) {
        double& z = track.stops[i].value;
        z = channel == Channel::ceiling ? std::max(z, t.here.floor_z + room) : std::min(z, t.here.ceiling_z - room);
    }
}

/// Where the floor or ceiling is, whatever its track alone says: the other one may hold it up.
double height_now(const Instant& now, SectorId sector, Channel channel) {
    const Heights here = heights_of(now, sector);
    return channel == Channel::floor ? here.floor_z : here.ceiling_z;
}

/// Whether the value is on its way, or about to be.
bool is_busy(const Change* change, std::uint64_t tick) {
    if (!change) return false;
    const auto end = end_of(change->track);
    return !end || *end > tick;
}

/// Whether nothing but its bob moves the floor or ceiling, as far as is known.
bool bobs(const Map& map, const History& history, SectorId sector, Channel channel) {
    const auto& bob = channel == Channel::floor ? map[sector].floor_bob : map[sector].ceiling_bob;
    const Change* change = history.newest_of(sector, channel);
    return bob && (!change || change->holds_up_bob());
}

bool stop_what_loops(const Instant& now, History& history, TriggerId cause, SectorId sector, std::uint64_t tick) {
    bool has_stopped = false;
    for (const Channel channel : {Channel::floor, Channel::ceiling}) {
        const Change* change = history.newest_of(sector, channel);
        if (!bobs(now.map, history, sector, channel) && !(change && change->track.loops)) continue;
        history.add(now.map, {sector, channel, {tick, height_now(now, sector, channel), {}, 0, false}, cause});
        has_stopped = true;
    }
    return has_stopped;
}

/// Whether a trigger gave it a light that no later one changes.
bool has_lasting_light(const Map& map, const Change* light) {
    if (!light) return false;
    const std::optional<LightEffectRecord>& effect = map[light->cause].effect;
    return effect && effect->lasts;
}

/// False where the target takes no orders now.
bool change_target(const Map& map, History& history, TriggerId id, std::size_t number, std::uint64_t tick) {
    const Trigger& trigger = map[id];
    const SectorId sector = map.targets_of(trigger)[number];
    const Instant now(map, history, static_cast<double>(tick));
    if (trigger.action == TriggerAction::stop) return stop_what_loops(now, history, id, sector, tick);
    const Channel channel = channel_of(trigger.action);
    const std::uint64_t start = tick + ticks_of(trigger.after_s, history.rate());
    // What bobs is somewhere else when a track begins later, which sets off from there.
    const Instant there = channel != Channel::light && bobs(map, history, sector, channel)
                              ? Instant(map, history, static_cast<double>(start))
                              : now;
    const ActionTarget target{now, trigger, sector, number, heights_of(there, sector)};
    const Change* present = history.newest_of(sector, channel);
    if (channel == Channel::light && has_lasting_light(map, present)) return true;
    TriggerId cause = id;  // of a door that something else moves it stays that
    Track track;
    if (channel != Channel::light && is_busy(present, tick)) {
        const bool is_door = trigger.action == TriggerAction::door && moves_doors(map[present->cause].action);
        const bool reverses = is_door && trigger.on == Activation::use && trigger.reverses;
        if (!reverses || present->track.count == 0) return false;
        track = used_again(target, *present);
        if (map[present->cause].action != TriggerAction::door) cause = present->cause;
    } else {
        track = track_of(target);
        clip(target, channel, track);
    }
    track.start = start;
    history.add(map, {sector, channel, track, cause});
    return true;
}

}  // namespace

bool carry_out(const Map& map, History& history, TriggerId trigger, std::uint64_t tick) {
    const std::size_t targets = map[trigger].targets.count;
    bool happens = targets == 0;
    for (std::size_t i = 0; i < targets; ++i) happens |= change_target(map, history, trigger, i, tick);
    return happens;
}

History begun(const Map& map, const MotionDials& motion) {
    History history(motion);
    for (const TriggerId trigger : map.at_start) carry_out(map, history, trigger, 0);
    return history;
}

bool crushes(const Map& map, const Change& change) { return crushes(map[change.cause]); }

Answer answer_to(const Instant& now, const Change& in_the_way, std::uint64_t tick) {
    const Track& old = in_the_way.track;
    const double z = height_now(now, in_the_way.sector, in_the_way.channel);
    const std::uint8_t heading = stop_at(old, now.tick);
    const Stop back = old.stops[1 - heading], on = old.stops[heading];
    Answer answer{in_the_way, {}};
    // It may not have left yet; and both stops of a door lie below where it hangs if there is no height to open to.
    const bool can_turn_round = old.count == 2 && (back.value - z) * (on.value - z) < 0;
    if (can_turn_round && now.map[in_the_way.cause].action != TriggerAction::close) {
        // A door that came down opens and closes again; one that only comes down to open afterwards opens.
        answer.at_once.track = old.loops || heading == 1 ? Track{tick, z, {back, on}, 2, old.loops} : once(z, back);
    } else {
        answer.at_once.track = {tick, z, {}, 0, false};
        answer.later = in_the_way;
        answer.later->track = rest_of(old, z, heading);
        answer.later->track.start = tick + patience_at(rate_of(now));
    }
    answer.at_once.track.start = tick;
    return answer;
}

void hold_up_bob(const Map& map, History& history, SectorId sector, Channel channel, std::uint64_t tick) {
    const Instant now(map, history, static_cast<double>(tick));
    const Change* before = change_of(now, sector, channel);
    const Change* newest = history.newest_of(sector, channel);
    const std::optional<Change> ordered = newest == before ? std::nullopt : std::optional(*newest);
    const std::uint64_t lag = (before ? before->lag : 0) + patience_at(history.rate());
    history.add(map, {sector, channel, {tick, height_now(now, sector, channel), {}, 0, false}, TriggerId(), lag});
    if (!ordered) return;
    Change later = *ordered;  // an order that begins later stays one, and sets off from where the bob then is
    later.track.from = height_now({map, history, static_cast<double>(later.track.start)}, sector, channel);
    history.add(map, later);
}

std::optional<Change> slowed(const Instant& now, const Change& crusher, std::uint64_t tick) {
    const std::optional<double>& speed = now.map[crusher.cause].crush_speed;
    const Track& old = crusher.track;
    if (!speed || is_on_first_way(old, now.tick)) return {};
    const std::uint8_t heading = stop_at(old, now.tick);
    const Stop next = old.stops[heading], last = old.stops[1 - heading];
    Change slow = crusher;
    const double z = height_now(now, crusher.sector, crusher.channel);
    const bool goes_back = old.loops || (old.count == 2 && heading == 0);
    slow.track = goes_back ? Track{tick, z, {next, last}, 2, old.loops} : once(z, next);
    slow.track.start = tick;
    slow.track.first_per_tick = *speed / ticks_per_second(rate_of(now));
    return slow;
}

}  // namespace enfilade
