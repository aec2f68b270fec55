#include "world/instant.h"

#include <algorithm>

#include "world/bob.h"
#include "world/input.h"

namespace enfilade {
namespace {

/// What a bob calls now: it stands still while it is held up, and is late from then on.
double bob_time_s(const Change* held_up, double tick) {
    if (!held_up) return tick * kTickSeconds;
    const double goes_on = static_cast<double>(held_up->course.start + kPatience);
    return (std::max(tick, goes_on) - static_cast<double>(held_up->lag)) * kTickSeconds;
}

double value_of(const Instant& now, const Change* change, const Flat& flat, const Boxed<BobRecord>& bob) {
    if (change && !change->holds_up_bob()) return value_at(change->course, now.tick);
    return bob ? flat.z + offset_at(*bob, bob_time_s(change, now.tick)) : flat.z;
}

/// What gave a floor what `gives` looks for, the change it follows or one before: a rising floor has it at once,
/// another on arrival. before: the newest change before one that gives it.
template <class Gives>
const Trigger* giver_of(const Instant& now, const Change* change, std::uint32_t Change::* before, Gives gives) {
    while (change) {
        const Course& course = change->course;
        const bool rises = course.count > 0 && course.stops[0].value > course.from;
        const bool has_come = rises || stop_at(course, now.tick) > 0;
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

}  // namespace enfilade
