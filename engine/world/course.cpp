#include "world/course.h"

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

/// From `from` on the way to the stop, `ticks` after setting off.
double on_the_way(double from, const Stop& to, double ticks) {
    if (ticks <= 0) return from;  // whatever the speed
    const double way = to.per_tick * ticks;
    return from < to.value ? std::min(from + way, to.value) : std::max(from - way, to.value);
}

/// Where in a course one is.
struct Position {
    double from;  ///< where the present way began
    std::uint8_t stop;
    double ticks;  ///< since it began
};

double lap_of(const Course& course) {
    if (!course.loops) return 0;
    double lap = 0;
    for (std::uint8_t i = 0; i < course.count; ++i) {
        const double from = course.stops[i == 0 ? course.count - 1 : i - 1].value;
        lap += static_cast<double>(ticks_between(from, course.stops[i]) + course.stops[i].wait);
    }
    return lap;
}

/// Goes from stop to stop until the time is used up.
Position walk_through(const Course& course, double from, double ticks) {
    for (std::uint8_t i = 0; i < course.count; ++i) {
        const auto way = static_cast<double>(ticks_between(from, course.stops[i]));
        const bool stays = i + 1 == course.count && !course.loops;
        if (ticks < way || (!stays && ticks < way + course.stops[i].wait)) return {from, i, ticks};
        ticks -= way + course.stops[i].wait;
        from = course.stops[i].value;
    }
    return {from, course.count, ticks};
}

Position position_at(const Course& course, double tick) {
    const double ticks = tick - static_cast<double>(course.start);
    if (ticks < 0) return {course.from, 0, 0};
    const Position first = walk_through(course, course.from, ticks);
    const double lap = lap_of(course);
    if (first.stop < course.count || lap == 0) return first;
    const double in_lap = first.ticks - std::floor(first.ticks / lap) * lap;
    return walk_through(course, course.stops[course.count - 1].value, in_lap);
}

}  // namespace

double value_at(const Course& course, double tick) {
    const Position at = position_at(course, tick);
    return at.stop < course.count ? on_the_way(at.from, course.stops[at.stop], at.ticks) : at.from;
}

std::optional<std::uint64_t> end_of(const Course& course) {
    if (lap_of(course) > 0) return {};
    std::uint64_t end = course.start;
    double from = course.from;
    for (std::uint8_t i = 0; i < course.count; ++i) {
        end += ticks_between(from, course.stops[i]);
        if (i + 1 < course.count) end += course.stops[i].wait;
        from = course.stops[i].value;
    }
    return end;
}

std::vector<Move> moves_of(const Course& course, double since, double until) {
    std::vector<Move> moves;
    double from = course.from, begin = static_cast<double>(course.start);
    const auto walk = [&] {
        for (std::uint8_t i = 0; i < course.count; ++i) {
            const double end = begin + static_cast<double>(ticks_between(from, course.stops[i]));
            if (end > begin && end > since && begin <= until)
                moves.push_back({begin, end, course.stops[i].value < from});
            begin = end + course.stops[i].wait;
            from = course.stops[i].value;
        }
    };
    walk();
    const double lap = lap_of(course);
    if (lap == 0) return moves;
    begin += std::max(0.0, std::floor((since - begin) / lap)) * lap;
    while (begin <= until) walk();
    return moves;
}

std::uint8_t stop_at(const Course& course, double tick) { return position_at(course, tick).stop; }

}  // namespace enfilade
