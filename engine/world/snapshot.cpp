#include "world/snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "world/input.h"
#include "world/instant.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

double foot_of(const Thing& thing, const Heights& home) {
    switch (thing.footing) {
        case Footing::floor: return home.floor_z;
        case Footing::ceiling: return home.ceiling_z - thing.height;
        case Footing::fixed: return thing.z;
    }
    return thing.z;
}

/// Its bobs alone say where its floor and ceiling are, so that nobody need ask before somebody looks.
bool only_bobs(const Sector& sector, const ChangesNow& changes) {
    return (sector.floor_bob || sector.ceiling_bob) && !changes.floor && !changes.ceiling;
}

SectorSnapshot sector_now(const Instant& now, SectorId id, const ChangesNow& changes) {
    const Sector& sector = now.map[id];
    const bool bobs = only_bobs(sector, changes);
    const Heights heights = bobs ? Heights{sector.floor.z, sector.ceiling.z} : heights_of(now, id, changes);
    return {heights.floor_z,
            heights.ceiling_z,
            plain_light_of(now, id, changes.light),
            effect_of(now, id, changes.light),
            changed_floor_picture(now, changes.floor),
            bobs ? &sector : nullptr,
            sector.leader};
}

SectorSnapshot sector_at_rest(const Map& map, SectorId id) { return sector_now(map, id, {}); }

/// Of those the history speaks of, and of their groups.
void show_changed(const Instant& now, Snapshot& snapshot) {
    for (const SectorId id : snapshot.changed) snapshot.sectors[id.index] = sector_at_rest(now.map, id);
    snapshot.changed.clear();
    for (const ChangedSector& changed : now.history->changed_sectors()) {
        const ChangesNow changes = changes_of(now, changed);
        each_of_group(now.map, changed.sector, [&](SectorId member) {
            snapshot.sectors[member.index] = sector_now(now, member, changes);
            snapshot.changed.push_back(member);
        });
    }
}

/// A trigger that works once turns its switch for ever, others for a moment.
void find_pressed(const Instant& now, std::vector<WallId>& walls) {
    walls.clear();
    now.history->each_first_firing([&](const Firing& firing) {
        const bool stays = firing.wall && now.map[firing.trigger].once;
        if (stays && static_cast<double>(firing.tick) <= now.tick) walls.push_back(firing.wall);
    });
    now.history->each_last_press(now.tick, [&](const Firing& firing) {
        if (now.tick < static_cast<double>(firing.tick) + kSwitchSeconds * ticks_per_second(rate_of(now)))
            walls.push_back(firing.wall);
    });
    std::sort(walls.begin(), walls.end());
    walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
}

/// A length of time as whole steps of the effect's clock, one at least.
std::uint64_t steps_of(const LightEffectRecord& effect, double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds * effect.clock_hz + 0.5));
}

/// A number for each pair of numbers, as if drawn by lot.
Random random_for(std::uint64_t seed, std::uint64_t number) { return Random(Random(seed).bits() ^ number); }

/// Bright, but for one dark moment in each span, drawn by lot.
bool flickers(const LightEffectRecord& effect, std::uint64_t seed, std::uint64_t now) {
    const std::uint64_t dark = steps_of(effect, effect.bright_s), span = dark + steps_of(effect, effect.dark_s);
    const std::uint64_t begin = random_for(seed, now / span).below(span - dark + 1);
    return now % span >= begin && now % span < begin + dark;
}

/// 0, the brightest, to 3: drawn by lot for each flame.
std::uint64_t level_of_fire(const LightEffectRecord& effect, std::uint64_t seed, double time_s) {
    const auto now = static_cast<std::uint64_t>(time_s * effect.clock_hz);
    return random_for(seed, now / steps_of(effect, effect.bright_s)).below(4);
}

/// How much of the way from dark to bright.
double part_of(const LightEffectRecord& effect, std::uint64_t seed, double time_s) {
    const auto now = static_cast<std::uint64_t>(time_s * effect.clock_hz);
    const std::uint64_t dark = steps_of(effect, effect.dark_s), bright = steps_of(effect, effect.bright_s);
    switch (effect.kind) {
        case LightKind::flicker: return flickers(effect, seed, now) ? 0 : 1;
        case LightKind::strobe:
            return (now + random_for(seed, 0).below(dark + bright)) % (dark + bright) < bright ? 1 : 0;
        case LightKind::fire: return 1 - 0.25 * static_cast<double>(level_of_fire(effect, seed, time_s));
        case LightKind::glow: {
            const double ways = time_s / effect.dark_s + random_for(seed, 0).uniform(0, 2);
            return std::fabs(1 - (ways - 2 * std::floor(ways / 2)));
        }
    }
    return 1;
}

}  // namespace

Snapshot at_rest(const Map& map) {
    Snapshot snapshot;
    snapshot.sectors.reserve(map.sectors.size());
    for (std::size_t i = 0; i < map.sectors.size(); ++i) snapshot.sectors.push_back(sector_at_rest(map, SectorId(i)));
    snapshot.things = presences_of(map);
    return snapshot;
}

void show(const Instant& now, Snapshot& snapshot) {
    snapshot.time_s = now.tick * tick_seconds(rate_of(now));
    if (!now.history) return;
    show_changed(now, snapshot);
    snapshot.way_back = now.history->way_back(now.tick);
    find_pressed(now, snapshot.pressed);
    snapshot.taken.clear();
    now.history->each_taken(now.tick, [&](ThingId thing) { snapshot.taken.push_back(thing); });
}

Snapshot snapshot_at(const Map& map, double time_s) {
    Snapshot snapshot = at_rest(map);
    const History history = begun(map);
    show({map, history, time_s * kTickRate}, snapshot);
    return snapshot;
}

void leave_out(const LeftOut& what, Snapshot& snapshot) {
    if (what.things) snapshot.things = {};
    snapshot.is_light_still |= what.light_effects;
}

double light_at(const Snapshot& snapshot, SectorId id) {
    const SectorSnapshot& sector = snapshot[id];
    if (!sector.effect || snapshot.is_light_still) return sector.light;
    return level_of(*sector.effect, sector.light, sector.light_seed.index, std::max(snapshot.time_s, 0.0));
}

ThingSnapshot thing_at(const Map& map, const Snapshot& snapshot, ThingId id) {
    const Thing& thing = map[id];
    const double foot_z = foot_of(thing, heights_at(snapshot, thing.sector));
    return {thing.bob ? foot_z + offset_at(*thing.bob, snapshot.time_s) : foot_z,
            thing.turn == 0 ? thing.yaw : thing.yaw + Angle::from_degrees(thing.turn * snapshot.time_s),
            thing.light ? *thing.light : light_at(snapshot, thing.sector),
            thing.sprite ? frame_at(map[thing.sprite], snapshot.time_s) : 0};
}

std::size_t frame_at(const Sprite& sprite, double time_s) {
    const double cycle = sprite.frames.back().until_s;
    double at = std::max(time_s, 0.0);
    if (cycle < std::numeric_limits<double>::infinity()) at -= std::floor(at / cycle) * cycle;
    const auto is_over = [](double time, const SpriteFrame& frame) { return time < frame.until_s; };
    const auto shown = std::upper_bound(sprite.frames.begin(), sprite.frames.end() - 1, at, is_over);
    return static_cast<std::size_t>(shown - sprite.frames.begin());
}

double level_of(const LightEffectRecord& effect, double bright, std::uint64_t seed, double time_s) {
    const double dark = std::min(effect.dark, bright);
    const std::uint64_t own_seed = effect.in_step ? 0 : seed;
    if (effect.kind == LightKind::fire && effect.step)
        return std::max(dark, bright - *effect.step * static_cast<double>(level_of_fire(effect, own_seed, time_s)));
    return dark + (bright - dark) * part_of(effect, own_seed, time_s);
}

}  // namespace enfilade
