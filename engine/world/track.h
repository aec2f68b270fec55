// Where a height or a light goes and when: a function of time, which nobody has to tick.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace enfilade {

/// A value to go to, and how.
struct Stop {
    double value = 0;
    double per_tick = 0;     ///< how fast one goes there, > 0; infinity: at once
    std::uint32_t wait = 0;  ///< how long one stays there before one goes on [ticks]

    bool operator==(const Stop&) const = default;
};

/// From a value to at most two stops, once or over and over. Before its start it is at `from`, after its end at its
/// last stop. Each way takes a whole number of ticks, rounded up, and stops are reached exactly.
struct Track {
    std::uint64_t start = 0;  ///< [ticks]
    double from = 0;
    std::array<Stop, 2> stops{};
    std::uint8_t count = 0;     ///< of stops; 0: it stays where it is
    bool loops = false;         ///< after the last stop to the first again; count > 0, and both stops' ways and waits
                                ///< together take at least one tick, else it ends
    double first_per_tick = 0;  ///< how fast one goes to the first stop the first time; 0: as the stop says

    bool operator==(const Track&) const = default;
};

/// The value at a moment, which may lie between two ticks. Computed from the track alone: nothing adds up, and any
/// moment costs the same.
double value_at(const Track& track, double tick);

/// The first tick at which it has come to rest for good, its last wait not counted; none where it never does.
std::optional<std::uint64_t> end_of(const Track& track);

/// A time in which a value moves.
struct Move {
    double begin = 0, end = 0;  ///< [ticks]
    bool is_down = false;
};

/// When the track moves, in order: those that end after `since` and begin by `until`. Cost: the laps between the
/// two, however late they are.
std::vector<Move> moves_of(const Track& track, double since, double until);

/// Whether it is on its first way and that has a speed of its own.
bool is_on_first_way(const Track& track, double tick);

/// Which stop it is on its way to, or waits at, 0 or 1; `count` once it has ended. Before its start: 0.
std::uint8_t stop_at(const Track& track, double tick);

}  // namespace enfilade
