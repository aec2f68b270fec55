#include "world/history.h"

#include <algorithm>
#include <bit>

#include "base/hash.h"

namespace enfilade {
namespace {

template <class Sorted, class Value, class Less>
auto place_in(Sorted& sorted, const Value& value, Less less) {
    return std::lower_bound(sorted.begin(), sorted.end(), value, less);
}

}  // namespace

const Change* History::newest_of(SectorId sector, Channel channel) const {
    const std::uint64_t key = key_of(sector, channel);
    const auto it = place_in(newest_, key, [](const Newest& n, std::uint64_t k) { return n.key < k; });
    return it == newest_.end() || it->key != key ? nullptr : &changes_[it->index];
}

const Change* History::change_of(SectorId sector, Channel channel, double tick) const {
    const Change* change = newest_of(sector, channel);
    while (change && static_cast<double>(change->course.start) > tick)
        change = change->before == Change::kNone ? nullptr : &changes_[change->before];
    return change;
}

void History::add(Change change) {
    const std::uint64_t key = key_of(change.sector, change.channel);
    const auto index = static_cast<std::uint32_t>(changes_.size());
    const auto it = place_in(newest_, key, [](const Newest& n, std::uint64_t k) { return n.key < k; });
    if (it != newest_.end() && it->key == key) {
        change.before = it->index;
        it->index = index;
    } else {
        newest_.insert(it, {key, index});
        const auto sector = place_in(changed_sectors_, change.sector, std::less<>());
        if (sector == changed_sectors_.end() || *sector != change.sector)
            changed_sectors_.insert(sector, change.sector);
    }
    mix(key);
    mix(change.course.start);
    mix(std::bit_cast<std::uint64_t>(change.course.from + 0.0));
    for (const Stop& stop : change.course.stops) {
        mix(std::bit_cast<std::uint64_t>(stop.value + 0.0));
        mix(std::bit_cast<std::uint64_t>(stop.per_tick + 0.0));
        mix(stop.wait);
    }
    mix(std::uint64_t{change.course.count} << 1 | std::uint64_t{change.course.loops});
    mix(change.cause.index);
    changes_.push_back(change);
}

void History::add(const Firing& firing) {
    const auto index = static_cast<std::uint32_t>(firings_.size());
    firings_.push_back(firing);
    const auto it =
        place_in(by_trigger_, firing.trigger, [this](std::uint32_t i, TriggerId t) { return firings_[i].trigger < t; });
    if (it == by_trigger_.end() || firings_[*it].trigger != firing.trigger) by_trigger_.insert(it, index);
    if (firing.wall) {
        const auto after = std::upper_bound(by_wall_.begin(), by_wall_.end(), firing.wall,
                                            [this](WallId w, std::uint32_t i) { return w < firings_[i].wall; });
        by_wall_.insert(after, index);
    }
    mix(firing.tick);
    mix(std::uint64_t{firing.trigger.index} << 32 | firing.wall.index);
}

void History::add(const Taking& taking) {
    takings_.insert(place_in(takings_, taking, [](const Taking& a, const Taking& b) { return a.thing < b.thing; }),
                    taking);
    mix(taking.tick);
    mix(taking.thing.index);
}

bool History::has_fired(TriggerId trigger) const {
    const auto it =
        place_in(by_trigger_, trigger, [this](std::uint32_t i, TriggerId t) { return firings_[i].trigger < t; });
    return it != by_trigger_.end() && firings_[*it].trigger == trigger;
}

const Firing* History::pressed(WallId wall, double tick) const {
    auto it = std::upper_bound(by_wall_.begin(), by_wall_.end(), wall,
                               [this](WallId w, std::uint32_t i) { return w < firings_[i].wall; });
    while (it != by_wall_.begin() && firings_[*--it].wall == wall)
        if (static_cast<double>(firings_[*it].tick) <= tick) return &firings_[*it];
    return nullptr;
}

bool History::is_taken(ThingId thing, double tick) const {
    const auto it = place_in(takings_, thing, [](const Taking& t, ThingId id) { return t.thing < id; });
    return it != takings_.end() && it->thing == thing && static_cast<double>(it->tick) <= tick;
}

void History::mix(std::uint64_t word) {
    Hash hash;
    hash.add(digest_);
    hash.add(word);
    digest_ = hash.value();
}

}  // namespace enfilade
