// Time outside.
#include "platform/clock.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Clock, SleepsAtLeastUntilTheMoment) {
    const std::int64_t moment = now_ns() + 3'000'000;
    sleep_until_ns(moment);
    EXPECT_GE(now_ns(), moment);
}

TEST(Clock, ReturnsAtOnceForThePast) {
    const std::int64_t before = now_ns();
    sleep_until_ns(before - 3'600'000'000'000);
    EXPECT_LT(now_ns() - before, 1'000'000'000);  // a second: far more than no sleep, far less than the hour
}

}  // namespace
}  // namespace enfilade
