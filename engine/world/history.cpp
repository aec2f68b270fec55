#include "world/history.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/hash.h"

namespace enfilade {
namespace {

/// Ways take a day at most, at the usual rate of ticks, whatever speeds a map asks for [ticks].
constexpr double kLongestWay = 60 * 86400.0;

std::uint64_t ticks_between(double from, const Stop& to) {
    const double distance = std::fabs(to.value - from);
    if (distance == 0) return 0;
    return static_cast<std::uint64_t>(std::min(std::ceil(distance / to.per_tick), kLongestWay));
}

/// From `from` on the way to the value, `ticks` after setting off.
double on_the_way(double from, double to, double per_tick, double ticks) {
    if (ticks <= 0) return from;  // whatever the speed
    const double way = per_tick * ticks;
    return from < to ? std::min(from + way, to) : std::max(from - way, to);
}

/// Where in a track one is.
struct Position {
    double from;  ///< where the present way began
    std::uint8_t stop;
    double ticks;     ///< since it began
    double per_tick;  ///< on the present way
};

/// The track's stop, as one goes there in every lap but the first.
Stop again(const Track& track, std::uint8_t i) { return track.stops[i]; }

/// The track's stop, as one goes there the first time.
Stop first_time(const Track& track, std::uint8_t i) {
    Stop stop = track.stops[i];
    if (i == 0 && track.first_per_tick > 0) stop.per_tick = track.first_per_tick;
    return stop;
}

double lap_of(const Track& track) {
    if (!track.loops) return 0;
    double lap = 0;
    for (std::uint8_t i = 0; i < track.count; ++i) {
        const double from = track.stops[i == 0 ? track.count - 1 : i - 1].value;
        lap += static_cast<double>(ticks_between(from, track.stops[i]) + track.stops[i].wait);
    }
    return lap;
}

/// Goes from stop to stop until the time is used up. stop_of: first_time or again.
template <class StopOf>
Position walk_through(const Track& track, double from, double ticks, StopOf stop_of) {
    for (std::uint8_t i = 0; i < track.count; ++i) {
        const Stop stop = stop_of(track, i);
        const auto way = static_cast<double>(ticks_between(from, stop));
        const bool stays = i + 1 == track.count && !track.loops;
        if (ticks < way || (!stays && ticks < way + stop.wait)) return {from, i, ticks, stop.per_tick};
        ticks -= way + stop.wait;
        from = stop.value;
    }
    return {from, track.count, ticks, 0};
}

Position position_at(const Track& track, double tick) {
    const double ticks = tick - static_cast<double>(track.start);
    if (ticks < 0) return {track.from, 0, 0, 0};
    const Position first = walk_through(track, track.from, ticks, first_time);
    const double lap = lap_of(track);
    if (first.stop < track.count || lap == 0) return first;
    const double in_lap = first.ticks - std::floor(first.ticks / lap) * lap;
    return walk_through(track, track.stops[track.count - 1].value, in_lap, again);
}

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

double value_at(const Track& track, double tick) {
    const Position at = position_at(track, tick);
    if (at.stop >= track.count) return at.from;
    return on_the_way(at.from, track.stops[at.stop].value, at.per_tick, at.ticks);
}

std::optional<std::uint64_t> end_of(const Track& track) {
    if (lap_of(track) > 0) return {};
    std::uint64_t end = track.start;
    double from = track.from;
    for (std::uint8_t i = 0; i < track.count; ++i) {
        end += ticks_between(from, first_time(track, i));
        if (i + 1 < track.count) end += track.stops[i].wait;
        from = track.stops[i].value;
    }
    return end;
}

std::vector<Move> moves_of(const Track& track, double since, double until) {
    std::vector<Move> moves;
    double from = track.from, begin = static_cast<double>(track.start);
    const auto walk = [&](auto stop_of) {
        for (std::uint8_t i = 0; i < track.count; ++i) {
            const double end = begin + static_cast<double>(ticks_between(from, stop_of(track, i)));
            if (end > begin && end > since && begin <= until)
                moves.push_back({begin, end, track.stops[i].value < from});
            begin = end + track.stops[i].wait;
            from = track.stops[i].value;
        }
    };
    walk(first_time);
    const double lap = lap_of(track);
    if (lap == 0) return moves;
    begin += std::max(0.0, std::floor((since - begin) / lap)) * lap;
    while (begin <= until) walk(again);
    return moves;
}

bool is_on_first_way(const Track& track, double tick) {
    if (track.count == 0 || track.first_per_tick == 0) return false;
    const double ticks = tick - static_cast<double>(track.start);
    return ticks < static_cast<double>(ticks_between(track.from, first_time(track, 0)));
}

std::uint8_t stop_at(const Track& track, double tick) { return position_at(track, tick).stop; }

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
    std::uint64_t all = mixed(0, {changes_digest_, firings_digest_, pickups_digest_});
    // Only what says anything: other histories keep the digests that are recorded.
    if (!ways_back_.empty()) all = mixed(all, {ways_back_digest_});
    if (rate() != TickRate::hz60) all = mixed(all, {ticks_per_second(rate())});
    if (motion_.crossing != CrossingMethod::exact) all = mixed(all, {static_cast<std::uint64_t>(motion_.crossing)});
    return all;
}

History History::beginning(const Length& length) const {
    History begun(motion_);
    for (std::size_t i = 0; i < length.changes; ++i) begun.append(changes_[i]);
    for (std::size_t i = 0; i < length.firings; ++i) begun.add(firings_[i]);
    for (std::size_t i = 0; i < length.pickups; ++i) begun.add(pickups_[i]);
    for (std::size_t i = 0; i < length.ways_back; ++i) begun.add(ways_back_[i]);
    return begun;
}

}  // namespace enfilade
