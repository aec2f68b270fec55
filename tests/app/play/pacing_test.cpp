// When pictures are begun and shown.
#include "app/play/pacing.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Pacing, ShowsPicturesEvenlyHoweverLongTheyTake) {
    Pacing pacing;
    pacing.set_period(10 * kMs);
    pacing.go_on(100 * kMs);
    const std::int64_t first = pacing.due();
    for (int i = 1; i < 20; ++i) {
        pacing.drew((i % 5) * kMs);
        pacing.go_on(pacing.due() + kMs / 2);
        EXPECT_EQ(pacing.due(), first + i * 10 * kMs);
    }
}

TEST(Pacing, BeginsAsMuchEarlierAsTheSlowestTook) {
    Pacing pacing;
    pacing.set_period(16 * kMs);
    pacing.go_on(kMs);
    pacing.drew(2 * kMs), pacing.drew(5 * kMs), pacing.drew(3 * kMs);
    EXPECT_LT(pacing.begin(), pacing.due() - 5 * kMs);
    EXPECT_GT(pacing.begin(), pacing.due() - 6 * kMs);
}

TEST(Pacing, NeverBeginsMoreThanAPeriodEarlier) {
    Pacing pacing;
    pacing.set_period(16 * kMs);
    pacing.go_on(kMs);
    pacing.drew(200 * kMs);
    EXPECT_EQ(pacing.begin(), pacing.due() - 16 * kMs);
}

TEST(Pacing, DoesNotHurryAfterAPictureThatWasLate) {
    Pacing pacing;
    pacing.set_period(10 * kMs);
    pacing.go_on(100 * kMs);
    pacing.go_on(500 * kMs);
    EXPECT_EQ(pacing.due(), 510 * kMs);
}

TEST(Pacing, FollowsAShorterPeriodAtOnce) {
    Pacing pacing;
    pacing.set_period(1000 * kMs);
    pacing.go_on(100 * kMs);
    pacing.set_period(10 * kMs);
    pacing.go_on(101 * kMs);
    EXPECT_EQ(pacing.due(), 111 * kMs);
}

}  // namespace
}  // namespace enfilade
