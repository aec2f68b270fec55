// Time as it passes outside: for frame pacing and read-outs, never for the world's state.
#pragma once
#include <cstdint>

namespace enfilade {

inline constexpr std::int64_t kSecond = 1'000'000'000;  ///< [ns]

/// Since some fixed moment; never goes back [ns].
std::int64_t now_ns();

/// Processor time that this thread has used: what measuring work needs where other programs run beside it [ns].
std::int64_t thread_time_ns();

/// Returns when now_ns() has reached the moment, at once where it lies in the past.
void sleep_until_ns(std::int64_t moment);

}  // namespace enfilade
