// Tracks: where a height is at any moment, without ticking.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/hash.h"
#include "world/history.h"

namespace enfilade {
namespace {

constexpr double kAtOnce = std::numeric_limits<double>::infinity();

/// Up from 0 to 4 in 16 ticks, waits for 10, down to 1 in 6.
constexpr Track kDoor{100, 0, {Stop{4, 0.25, 10}, Stop{1, 0.5, 0}}, 2, false};

TEST(Track, IsWhereItWasBeforeItStarts) { EXPECT_EQ(value_at(kDoor, 99.5), 0); }

TEST(Track, GoesEvenlyToItsFirstStop) {
    EXPECT_EQ(value_at(kDoor, 101), 0.25);
    EXPECT_EQ(value_at(kDoor, 110), 2.5);
}

TEST(Track, CanBeAskedBetweenTwoTicks) { EXPECT_EQ(value_at(kDoor, 101.5), 0.375); }

TEST(Track, WaitsAtItsStop) {
    EXPECT_EQ(value_at(kDoor, 116), 4);
    EXPECT_EQ(value_at(kDoor, 126), 4);
    EXPECT_EQ(stop_at(kDoor, 125), 0);
    EXPECT_EQ(stop_at(kDoor, 126), 1);
}

TEST(Track, GoesOnToItsLastStopAndStaysThere) {
    EXPECT_EQ(value_at(kDoor, 127), 3.5);
    EXPECT_EQ(value_at(kDoor, 132), 1);
    EXPECT_EQ(value_at(kDoor, 1e12), 1);
}

TEST(Track, EndsWhenItHasArrived) {
    EXPECT_EQ(end_of(kDoor), 132u);
    EXPECT_EQ(stop_at(kDoor, 131), 1);
    EXPECT_EQ(stop_at(kDoor, 132), 2);
}

TEST(Track, ReachesAStopExactlyThoughItsSpeedDoesNotDivideTheWay) {
    const Track third{0, 0, {Stop{1, 0.3, 0}, {}}, 1, false};
    EXPECT_EQ(value_at(third, 3), 0.3 * 3);
    EXPECT_EQ(value_at(third, 4), 1);
    EXPECT_EQ(end_of(third), 4u);
}

TEST(Track, JumpsWhereItsSpeedIsInfinite) {
    const Track jump{5, 0, {Stop{1, kAtOnce, 0}, {}}, 1, false};
    EXPECT_EQ(value_at(jump, 4), 0);
    EXPECT_EQ(value_at(jump, 5), 1);
}

TEST(Track, WithoutStopsStays) {
    const Track still{5, 2, {}, 0, false};
    EXPECT_EQ(value_at(still, 1000), 2);
    EXPECT_EQ(end_of(still), 5u);
}

TEST(Track, ThatLoopsGoesToAndFroForEver) {
    const Track shuttle{0, 1, {Stop{0, 0.5, 3}, Stop{2, 0.5, 5}}, 2, true};  // lap: 4 + 3 + 4 + 5
    EXPECT_EQ(value_at(shuttle, 2), 0);
    EXPECT_EQ(value_at(shuttle, 5 + 4), 2);
    EXPECT_EQ(value_at(shuttle, 2 + 3 + 4 + 5 + 4), 0);
    for (int lap = 0; lap < 1000; ++lap) EXPECT_EQ(value_at(shuttle, 14 + 16.0 * lap + 1.5), 1.25) << lap;
    EXPECT_EQ(end_of(shuttle), std::nullopt);
}

TEST(Track, ThatLoopsOverNoWayAtAllEnds) {
    const Track stuck{0, 1, {Stop{1, 0.5, 0}, Stop{1, 0.5, 0}}, 2, true};
    EXPECT_EQ(value_at(stuck, 1e9), 1);
    EXPECT_EQ(end_of(stuck), 0u);
}

/// The same track, walked tick by tick.
class Ticked {
public:
    explicit Ticked(const Track& track) : track_(track), value_(track.from) {}

    double next() {
        if (waits_ > 0) {
            --waits_;
            return value_;
        }
        if (stop_ >= track_.count) return value_;
        const Stop& stop = track_.stops[stop_];
        if (ticks_ == 0) from_ = value_;
        ++ticks_;
        const double way = stop.per_tick * ticks_;
        value_ = from_ < stop.value ? std::fmin(from_ + way, stop.value) : std::fmax(from_ - way, stop.value);
        if (value_ != stop.value) return value_;
        waits_ = stop.wait;
        ticks_ = 0;
        ++stop_;
        if (stop_ == track_.count && track_.loops) stop_ = 0;
        return value_;
    }

private:
    Track track_;
    double value_, from_ = 0;
    std::uint32_t waits_ = 0;
    int ticks_ = 0;
    std::uint8_t stop_ = 0;
};

// hard case C24
TEST(Track, IsAtAnyTickWhereTickingFromTheStartLeads) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        Track track{0, random.uniform(-4, 4), {}, 2, random.below(2) == 0};
        for (Stop& stop : track.stops)
            stop = {random.uniform(-4, 4), random.uniform(0.01, 0.5), static_cast<std::uint32_t>(random.below(20))};
        Ticked ticked(track);
        for (int tick = 1; tick < 3000; ++tick) ASSERT_EQ(value_at(track, tick), ticked.next()) << i << " " << tick;
    }
}

}  // namespace
}  // namespace enfilade
