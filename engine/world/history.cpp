#include "world/history.h"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "base/hash.h"

namespace enfilade {
namespace {

template <class Sorted, class Value, class Less>
auto place_in(Sorted& sorted, const Value& value, Less less) {
    return std::lower_bound(sorted.begin(), sorted.end(), value, less);
}

bool is_before(const ChangedSector& changed, SectorId sector) { return changed.sector < sector; }

std::uint64_t mixed(std::uint64_t digest, std::initializer_list<std::uint64_t> words) {
    Hash hash;
    hash.add(digest);
    for (const std::uint64_t word : words) hash.add(word);
    return hash.value();
}

std::uint64_t mixed(std::uint64_t digest, const Change& change) {
    Hash hash;
    hash.add(digest);
    hash.add(change.sector.index);
    hash.add(static_cast<std::uint64_t>(change.channel));
    hash.add(change.track.start);
    hash.add(change.track.from);
    for (const Stop& stop : change.track.stops) {
        hash.add(stop.value);
        hash.add(stop.per_tick);
        hash.add(stop.wait);
    }
    hash.add(std::uint64_t{change.track.count});
    hash.add(change.track.loops);
    // Only where it says anything: other histories keep the digests that are recorded.
    if (change.track.first_per_tick > 0) hash.add(change.track.first_per_tick);
    if (change.lag > 0) hash.add(change.lag);
    hash.add(change.cause.index);
    return hash.value();
}

}  // namespace

const ChangedSector* History::changed(SectorId sector) const {
    const auto it = place_in(changed_sectors_, sector, is_before);
    return it == changed_sectors_.end() || it->sector != sector ? nullptr : &*it;
}

const Change* History::newest_of(SectorId sector, Channel channel) const {
    return change_of(sector, channel, std::numeric_limits<double>::infinity());
}

const Change* History::change_of(SectorId sector, Channel channel, double tick) const {
    const ChangedSector* found = changed(sector);
    return found ? change_of(*found, channel, tick) : nullptr;
}

const Change* History::change_of(const ChangedSector& sector, Channel channel, double tick) const {
    std::uint32_t index = sector.newest[static_cast<std::size_t>(channel)];
    while (index != Change::kNone && static_cast<double>(changes_[index].track.start) > tick)
        index = changes_[index].before;
    return index == Change::kNone ? nullptr : &changes_[index];
}

void History::add(const Map& map, Change change) {
    const Change* const ended = newest_of(change.sector, change.channel);
    change.before = change.before_with_picture = change.before_that_heals = Change::kNone;
    if (ended) {
        const auto index = static_cast<std::uint32_t>(ended - changes_.data());
        const bool has_cause = !ended->holds_up_bob();
        change.before = index;
        change.before_with_picture = has_cause && map[ended->cause].texture ? index : ended->before_with_picture;
        change.before_that_heals = has_cause && map[ended->cause].heals ? index : ended->before_that_heals;
    }
    append(change);
}

void History::append(const Change& change) {
    auto it = place_in(changed_sectors_, change.sector, is_before);
    if (it == changed_sectors_.end() || it->sector != change.sector)
        it = changed_sectors_.insert(it, {change.sector, {Change::kNone, Change::kNone, Change::kNone}});
    it->newest[static_cast<std::size_t>(change.channel)] = static_cast<std::uint32_t>(changes_.size());
    changes_digest_ = mixed(changes_digest_, change);
    changes_.push_back(change);
}

void History::add(const Firing& firing) {
    const auto index = static_cast<std::uint32_t>(firings_.size());
    firings_.push_back(firing);
    const auto it =
        place_in(by_trigger_, firing.trigger, [this](std::uint32_t i, TriggerId t) { return firings_[i].trigger < t; });
    if (it == by_trigger_.end() || firings_[*it].trigger != firing.trigger) by_trigger_.insert(it, index);
    if (firing.wall) {
        by_wall_.insert(end_of_presses(firing.wall), index);
    }
    firings_digest_ = mixed(firings_digest_, {firing.tick, firing.trigger.index, firing.wall.index});
}

void History::add(const Pickup& pickup) {
    const auto index = static_cast<std::uint32_t>(pickups_.size());
    pickups_.push_back(pickup);
    const auto it =
        place_in(by_thing_, pickup.thing, [this](std::uint32_t i, ThingId t) { return pickups_[i].thing < t; });
    by_thing_.insert(it, index);
    pickups_digest_ = mixed(pickups_digest_, {pickup.tick, pickup.thing.index});
}

void History::add(WayBack way_back) {
    if (!ways_back_.empty()) way_back.tick = std::max(way_back.tick, ways_back_.back().tick);
    ways_back_.push_back(way_back);
    ways_back_digest_ = mixed(ways_back_digest_, {way_back.tick, way_back.wall.index});
}

bool History::has_fired(TriggerId trigger) const {
    const auto it =
        place_in(by_trigger_, trigger, [this](std::uint32_t i, TriggerId t) { return firings_[i].trigger < t; });
    return it != by_trigger_.end() && firings_[*it].trigger == trigger;
}

std::vector<std::uint32_t>::const_iterator History::end_of_presses(WallId wall) const {
    return std::upper_bound(by_wall_.begin(), by_wall_.end(), wall,
                            [this](WallId w, std::uint32_t i) { return w < firings_[i].wall; });
}

const Firing* History::pressed(WallId wall, double tick) const {
    auto it = end_of_presses(wall);
    while (it != by_wall_.begin() && firings_[*--it].wall == wall)
        if (static_cast<double>(firings_[*it].tick) <= tick) return &firings_[*it];
    return nullptr;
}

bool History::is_taken(ThingId thing, double tick) const {
    const auto it = place_in(by_thing_, thing, [this](std::uint32_t i, ThingId id) { return pickups_[i].thing < id; });
    return it != by_thing_.end() && pickups_[*it].thing == thing && static_cast<double>(pickups_[*it].tick) <= tick;
}

WallId History::way_back(double tick) const {
    const auto later = std::upper_bound(ways_back_.begin(), ways_back_.end(), tick,
                                        [](double t, const WayBack& w) { return t < static_cast<double>(w.tick); });
    return later == ways_back_.begin() ? WallId() : std::prev(later)->wall;
}

std::uint64_t History::digest() const {
    const std::uint64_t others = mixed(0, {changes_digest_, firings_digest_, pickups_digest_});
    // Only where it says anything: other histories keep the digests that are recorded.
    return ways_back_.empty() ? others : mixed(others, {ways_back_digest_});
}

History History::beginning(const Length& length) const {
    History begun;
    for (std::size_t i = 0; i < length.changes; ++i) begun.append(changes_[i]);
    for (std::size_t i = 0; i < length.firings; ++i) begun.add(firings_[i]);
    for (std::size_t i = 0; i < length.pickups; ++i) begun.add(pickups_[i]);
    for (std::size_t i = 0; i < length.ways_back; ++i) begun.add(ways_back_[i]);
    return begun;
}

}  // namespace enfilade
