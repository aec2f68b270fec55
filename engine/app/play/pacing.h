// When pictures are begun and shown: evenly, and as late as can be, so that they show what was pressed last.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace enfilade {

/// So long after the last event a page on which nothing moves counts as idle [ns].
inline constexpr std::int64_t kUntilIdle = 500'000'000;

/// Where nothing moves, events are looked for this often; where nobody sees the window, that often [1/s].
inline constexpr double kIdleHz = 30, kHiddenHz = 10;

/// Moments are those of now_ns() (platform/clock.h) [ns].
class Pacing {
public:
    /// period > 0: from one picture to the next [ns].
    void set_period(std::int64_t period) { period_ = period; }

    /// When the next picture is due; it is begun so much before as the slowest of the last ones took.
    std::int64_t due() const { return due_; }
    std::int64_t begin() const;

    /// A picture took so long to draw [ns].
    void drew(std::int64_t took);

    /// The moment that was due has passed, with a picture or without one. Who is late by more than a period begins
    /// anew.
    void go_on(std::int64_t now);

private:
    static constexpr std::size_t kKept = 30;         ///< pictures: half a second
    static constexpr std::int64_t kSpare = 500'000;  ///< for what drawing is not [ns]

    std::array<std::int64_t, kKept> took_{};
    std::size_t count_ = 0;
    std::int64_t period_ = 16'666'667, due_ = 0;
};

}  // namespace enfilade
