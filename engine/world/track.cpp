#include "world/track.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

/// Ways take a day at most, whatever speeds a map asks for [ticks].
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

}  // namespace enfilade
