#include "world/snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/input.h"
#include "world/instant.h"
#include "world/light.h"

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
        if (now.tick < static_cast<double>(firing.tick) + kSwitchSeconds * kTickRate) walls.push_back(firing.wall);
    });
    std::sort(walls.begin(), walls.end());
    walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
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
    snapshot.time_s = now.tick * kTickSeconds;
    if (!now.history) return;
    show_changed(now, snapshot);
    snapshot.way_back = now.history->way_back(now.tick);
    find_pressed(now, snapshot.pressed);
    snapshot.taken.clear();
    now.history->each_taken(now.tick, [&](ThingId thing) { snapshot.taken.push_back(thing); });
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

}  // namespace enfilade
