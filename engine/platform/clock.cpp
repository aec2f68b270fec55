#include "platform/clock.h"

#include <time.h>

#include <chrono>
#include <thread>

namespace enfilade {

using Steady = std::chrono::steady_clock;

std::int64_t now_ns() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Steady::now().time_since_epoch()).count();
}

std::int64_t thread_time_ns() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

void sleep_until_ns(std::int64_t moment) {
    std::this_thread::sleep_until(Steady::time_point(std::chrono::nanoseconds(moment)));
}

}  // namespace enfilade
