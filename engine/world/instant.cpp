#include "world/instant.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/angle.h"
#include "world/input.h"

namespace enfilade {

namespace {

/// What a bob calls now: it stands still while it is held up, and is late from then on.
double bob_time_s(const Instant& now, const Change* held_up) {
    const double seconds = tick_seconds(rate_of(now));
    if (!held_up) return now.tick * seconds;
    const double goes_on = static_cast<double>(held_up->track.start + patience_at(rate_of(now)));
    return (std::max(now.tick, goes_on) - static_cast<double>(held_up->lag)) * seconds;
}

double value_of(const Instant& now, const Change* change, const Flat& flat, const Boxed<BobRecord>& bob) {
    if (change && !change->holds_up_bob()) return value_at(change->track, now.tick);
    return bob ? flat.z + offset_at(*bob, bob_time_s(now, change)) : flat.z;
}

/// What gave a floor what `gives` looks for, the change it follows or one before: a rising floor has it at once,
/// another on arrival. before: the newest change before one that gives it.
template <class Gives>
const Trigger* giver_of(const Instant& now, const Change* change, std::uint32_t Change::* before, Gives gives) {
    while (change) {
        const Track& track = change->track;
        const bool rises = track.count > 0 && track.stops[0].value > track.from;
        const bool has_come = rises || stop_at(track, now.tick) > 0;
        if (!change->holds_up_bob() && gives(now.map[change->cause]) && has_come) return &now.map[change->cause];
        change = change->*before == Change::kNone ? nullptr : &now.history->changes()[change->*before];
    }
    return nullptr;
}

}  // namespace

const Change* change_of(const Instant& now, SectorId sector, Channel channel) {
    return now.history ? now.history->change_of(now.map[sector].leader, channel, now.tick) : nullptr;
}

ChangesNow changes_of(const Instant& now, const ChangedSector& sector) {
    const auto of = [&](Channel channel) { return now.history->change_of(sector, channel, now.tick); };
    return {of(Channel::floor), of(Channel::ceiling), of(Channel::light)};
}

Heights heights_of(const Instant& now, SectorId id) {
    const ChangedSector* changed = now.history ? now.history->changed(now.map[id].leader) : nullptr;
    return heights_of(now, id, changed ? changes_of(now, *changed) : ChangesNow{});
}

Heights heights_of(const Instant& now, SectorId id, const ChangesNow& changes) {
    const Sector& sector = now.map[id];
    const double floor_z = value_of(now, changes.floor, sector.floor, sector.floor_bob);
    // Both may be on their way towards each other: where they meet, the floor carries the ceiling.
    return {floor_z, std::max(floor_z, value_of(now, changes.ceiling, sector.ceiling, sector.ceiling_bob))};
}

bool is_portal(const Instant& now, WallId id) {
    const WallKind kind = now.map[id].kind;
    if (kind != WallKind::way_back) return kind == WallKind::portal;
    if (now.way_back) return *now.way_back == id;
    return now.history && now.history->way_back(now.tick) == id;
}

namespace {

/// Whether the portal leads elsewhere than to the next room, or nobody comes back by it.
bool is_door(const Map& map, WallId id) {
    const Wall& portal = map[id];
    return portal.link != Wall::kNoLink || portal.kind == WallKind::way_back || !portal.exit ||
           map[portal.exit].exit != id || map[portal.exit].kind == WallKind::way_back;
}

}  // namespace

// The way back that stood open is there no more when somebody has left by a door.
std::optional<WallId> way_back_left(const Map& map, WallId portal) {
    if (!map.has_ways_back || !is_door(map, portal)) return {};
    const WallId exit = map[portal].exit;
    const bool leaves_one = map[portal].kind == WallKind::portal && exit && map[exit].kind == WallKind::way_back &&
                            map[exit].exit == portal;
    return leaves_one ? exit : WallId();
}

bool is_open(const Instant& now, WallId id) {
    if (!is_portal(now, id)) return false;
    const Wall& portal = now.map[id];
    const Heights here = heights_of(now, portal.sector), behind = heights_of(now, portal.behind);
    const double rise = now.map.passage(portal).rise;
    return std::min(here.ceiling_z, behind.ceiling_z - rise) > std::max(here.floor_z, behind.floor_z - rise);
}

double foot_of(const Instant& now, ThingId id) {
    const Thing& thing = now.map[id];
    if (thing.footing == Footing::fixed) return thing.z;
    const Heights here = heights_of(now, thing.sector);
    return thing.footing == Footing::floor ? here.floor_z : here.ceiling_z - thing.height;
}

int damage_of(const Instant& now, SectorId sector) {
    const Change* floor = change_of(now, sector, Channel::floor);
    const auto heals = [](const Trigger& t) { return t.heals; };
    return giver_of(now, floor, &Change::before_that_heals, heals) ? 0 : now.map[sector].damage;
}

TextureId changed_floor_picture(const Instant& now, const Change* floor) {
    const auto has_picture = [](const Trigger& t) { return bool(t.texture); };
    const Trigger* giver = giver_of(now, floor, &Change::before_with_picture, has_picture);
    return giver ? giver->texture : TextureId();
}

namespace {

/// Whether the portal leads from one sector of a group into another.
bool is_within_group(const Map& map, const Wall& portal) {
    return portal.behind != portal.sector && map[portal.behind].leader == map[portal.sector].leader;
}

/// Calls visit(wall) for each portal that leads out of the sector's group.
template <class Visit>
void each_portal(const Map& map, SectorId id, Visit visit) {
    each_of_group(map, id, [&](SectorId member) {
        const Sector& sector = map[member];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i)
            if (map.walls[i].kind == WallKind::portal && !is_within_group(map, map.walls[i])) visit(map.walls[i]);
    });
}

/// The best of a height of all sectors around, by an order, among those that may count.
template <class Better, class Counts>
std::optional<double> best_around(const Instant& now, SectorId sector, double Heights::* which, Better better,
                                  Counts counts) {
    std::optional<double> best;
    each_portal(now.map, sector, [&](const Wall& portal) {
        const double height = heights_of(now, portal.behind).*which - now.map.passage(portal).rise;
        if (counts(height) && (!best || better(height, *best))) best = height;
    });
    return best;
}

std::optional<double> found_around(const Instant& now, SectorId sector, HeightLevel level) {
    const auto [floor_z, ceiling_z] = heights_of(now, sector);
    const auto any = [](double) { return true; };
    const auto higher = [own = floor_z](double z) { return z > own; };
    const auto lower = [own = floor_z](double z) { return z < own; };
    const std::less<double> less;
    const std::greater<double> more;
    switch (level) {
        case HeightLevel::lowest_floor:
            return best_around(now, sector, &Heights::floor_z, less, lower).value_or(floor_z);
        case HeightLevel::highest_floor: return best_around(now, sector, &Heights::floor_z, more, any);
        case HeightLevel::next_floor_up: return best_around(now, sector, &Heights::floor_z, less, higher);
        case HeightLevel::next_floor_down: return best_around(now, sector, &Heights::floor_z, more, lower);
        case HeightLevel::lowest_ceiling: return best_around(now, sector, &Heights::ceiling_z, less, any);
        case HeightLevel::highest_ceiling: return best_around(now, sector, &Heights::ceiling_z, more, any);
        case HeightLevel::floor: return floor_z;
        case HeightLevel::ceiling: return ceiling_z;
        case HeightLevel::lowest_ceiling_or_own:
            return std::min(best_around(now, sector, &Heights::ceiling_z, less, any).value_or(ceiling_z), ceiling_z);
        case HeightLevel::here: return {};
    }
    return {};
}

}  // namespace

double height_of(const Instant& now, SectorId sector, HeightLevel level, double here) {
    return found_around(now, sector, level).value_or(here);
}

const LightEffectRecord* effect_of(const Instant& now, SectorId sector, const Change* light) {
    const Boxed<LightEffectRecord>& own = now.map[sector].light_effect;
    if (own && own->lasts) return &*own;
    if (!light) return own ? &*own : nullptr;
    const std::optional<LightEffectRecord>& effect = now.map[light->cause].effect;
    return effect ? &*effect : nullptr;
}

double plain_light_of(const Instant& now, SectorId sector) {
    return plain_light_of(now, sector, change_of(now, sector, Channel::light));
}

double plain_light_of(const Instant& now, SectorId sector, const Change* light) {
    const Boxed<LightEffectRecord>& own = now.map[sector].light_effect;
    if (own && own->lasts) return now.map[sector].light;
    return light ? value_at(light->track, now.tick) : now.map[sector].light;
}

double light_of(const Instant& now, SectorId sector, LightLevel level) {
    double light = plain_light_of(now, sector);
    each_portal(now.map, sector, [&](const Wall& portal) {
        const double other = plain_light_of(now, portal.behind);
        light = level == LightLevel::brightest ? std::max(light, other) : std::min(light, other);
    });
    return light;
}

namespace {

/// The triangle that goes through the same points as the sine where that is 0, 1 and -1. part: of the period, 0..1.
double triangle(double part) {
    if (part < 0.25) return 4 * part;
    return part < 0.75 ? 2 - 4 * part : 4 * part - 4;
}

double height_of(const Flat& flat, const Boxed<BobRecord>& bob, double time_s) {
    return bob ? flat.z + offset_at(*bob, time_s) : flat.z;
}

}  // namespace

double offset_at(const BobRecord& bob, double time_s) {
    const double periods = time_s / bob.period + bob.phase;
    const double part = periods - std::floor(periods);
    if (bob.shape == BobShape::triangle) return bob.amplitude * triangle(part);
    return bob.amplitude * direction(Angle::from_degrees(part * 360)).y;
}

Heights bobbing_heights(const Sector& sector, double time_s) {
    const double floor_z = height_of(sector.floor, sector.floor_bob, time_s);
    return {floor_z, std::max(floor_z, height_of(sector.ceiling, sector.ceiling_bob, time_s))};
}

}  // namespace enfilade
