// Time as it passes outside: for frame pacing and read-outs, never for the world's state.
#pragma once
#include <time.h>

#include <chrono>
#include <cstdint>
#include <thread>

namespace enfilade {

inline constexpr std::int64_t kSecond = 1'000'000'000;  ///< [ns]

/// Since some fixed moment; never goes back [ns].
inline std::int64_t now_ns() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

/// Processor time that this thread has used: what measuring work needs where other programs run beside it [ns].
inline std::int64_t thread_time_ns() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return kSecond * time.tv_sec + time.tv_nsec;
}

/// Returns when now_ns() has reached the moment [ns], at once where it lies in the past.
inline void sleep_until_ns(std::int64_t moment) {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(moment)));
}

}  // namespace enfilade
