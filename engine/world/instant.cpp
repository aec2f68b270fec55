#include "world/instant.h"

#include <algorithm>

namespace enfilade {
namespace {

double value_of(const Instant& now, const Change* change, double at_rest) {
    return change ? value_at(change->course, now.tick) : at_rest;
}

/// What gave a floor what `gives` looks for, the change it follows or one before: a rising floor has it at once,
/// another on arrival.
template <class Gives>
const Trigger* giver_of(const Instant& now, const Change* change, Gives gives) {
    while (change) {
        const Course& course = change->course;
        const bool rises = course.count > 0 && course.stops[0].value > course.from;
        const bool has_come = rises || stop_at(course, now.tick) > 0;
        if (const Trigger& cause = now.map[change->cause]; gives(cause) && has_come) return &cause;
        change = change->before == Change::kNone ? nullptr : &now.history->changes()[change->before];
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
    const Sector& sector = now.map[id];
    const ChangedSector* changed = now.history ? now.history->changed(sector.leader) : nullptr;
    if (!changed) return {sector.floor.z, sector.ceiling.z};
    return heights_of(now, id, changes_of(now, *changed));
}

Heights heights_of(const Instant& now, SectorId id, const ChangesNow& changes) {
    const Sector& sector = now.map[id];
    const double floor_z = value_of(now, changes.floor, sector.floor.z);
    // Both may be on their way towards each other: where they meet, the floor carries the ceiling.
    return {floor_z, std::max(floor_z, value_of(now, changes.ceiling, sector.ceiling.z))};
}

bool is_portal(const Instant& now, WallId id) {
    const WallKind kind = now.map[id].kind;
    if (kind != WallKind::way_back) return kind == WallKind::portal;
    return now.history && now.history->way_back(now.tick) == id;
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
    if (!now.history || thing.footing == Footing::fixed) return thing.z;
    const Heights here = heights_of(now, thing.sector);
    return thing.footing == Footing::floor ? here.floor_z : here.ceiling_z - thing.height;
}

int damage_of(const Instant& now, SectorId sector) {
    const Change* floor = change_of(now, sector, Channel::floor);
    return giver_of(now, floor, [](const Trigger& t) { return t.heals; }) ? 0 : now.map[sector].damage;
}

TextureId changed_floor_picture(const Instant& now, const Change* floor) {
    const Trigger* giver = giver_of(now, floor, [](const Trigger& t) { return bool(t.texture); });
    return giver ? giver->texture : TextureId();
}

}  // namespace enfilade
