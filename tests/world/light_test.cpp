// Lights as functions of time.
#include <gtest/gtest.h>

#include <set>

#include "world/input.h"
#include "world/snapshot.h"

namespace enfilade {
namespace {

constexpr double kTick = kTickSeconds;

LightEffectRecord effect(LightKind kind) { return {kind, 0.25, 0.5, 0.125, false, false, {}, 60, {}}; }

std::set<double> levels(const LightEffectRecord& effect, std::uint64_t seed = 5) {
    std::set<double> seen;
    for (int tick = 0; tick < 6000; ++tick) seen.insert(level_of(effect, 0.75, seed, (tick + 0.5) * kTick));
    return seen;
}

TEST(Light, FlickersBetweenItsTwoLevels) { EXPECT_EQ(levels(effect(LightKind::flicker)), (std::set{0.25, 0.75})); }

TEST(Light, FlickersMostlyBright) {
    int dark = 0;
    for (int tick = 0; tick < 6000; ++tick)
        dark += level_of(effect(LightKind::flicker), 0.75, 5, (tick + 0.5) * kTick) < 0.5;
    EXPECT_GT(dark, 600);
    EXPECT_LT(dark, 2400);
}

TEST(Light, FlashesOnceInEveryPeriod) {
    int bright = 0, period = 30 + 8;  // 0.5 s and 0.125 s
    for (int tick = 0; tick < 100 * period; ++tick)
        bright += level_of(effect(LightKind::strobe), 0.75, 5, (tick + 0.5) * kTick) > 0.5;
    EXPECT_EQ(bright, 100 * 8);
}

TEST(Light, FlashesTogetherWithAllThatAreInStep) {
    LightEffectRecord strobe = effect(LightKind::strobe);
    strobe.in_step = true;
    for (int tick = 0; tick < 200; ++tick)
        EXPECT_EQ(level_of(strobe, 1, 1, (tick + 0.5) * kTick), level_of(strobe, 1, 2, (tick + 0.5) * kTick));
}

TEST(Light, FlashesEachInItsOwnTimeOtherwise) {
    int same = 0;
    for (int tick = 0; tick < 380; ++tick)
        same += level_of(effect(LightKind::strobe), 1, 1, (tick + 0.5) * kTick) ==
                level_of(effect(LightKind::strobe), 1, 3, (tick + 0.5) * kTick);
    EXPECT_LT(same, 380);
}

TEST(Light, GlowsEvenly) {
    for (double time = 0; time < 20; time += 0.01) {
        const double now = level_of(effect(LightKind::glow), 0.75, 5, time);
        const double soon = level_of(effect(LightKind::glow), 0.75, 5, time + 0.01);
        EXPECT_GE(now, 0.25);
        EXPECT_LE(now, 0.75);
        EXPECT_LE(std::abs(soon - now), 0.01 + 1e-9);  // half a unit in half a second
    }
}

TEST(Light, OfAFireIsNeverQuiteDark) {
    const std::set<double> seen = levels(effect(LightKind::fire));
    EXPECT_GT(*seen.begin(), 0.25);
    EXPECT_EQ(*seen.rbegin(), 0.75);
    EXPECT_EQ(seen.size(), 4u);
}

TEST(Light, OfAFireWithAStepGoesDownByThatAndNoDeeperThanItsDark) {
    LightEffectRecord fire = effect(LightKind::fire);
    fire.step = 0.0625;
    EXPECT_EQ(levels(fire), (std::set{0.75 - 3 * 0.0625, 0.75 - 2 * 0.0625, 0.75 - 0.0625, 0.75}));
    fire.dark = 0.65;
    EXPECT_EQ(levels(fire), (std::set{0.65, 0.75 - 0.0625, 0.75}));
}

/// How a light goes in an hour: what part of it is bright, and how often it changes in a second.
struct Restlessness {
    double bright = 0, changes_per_s = 0;
};

Restlessness restlessness(const LightEffectRecord& effect) {
    constexpr int kSeconds = 3600, kLooks = 1000;  // a second
    Restlessness found;
    bool was_bright = false;
    for (int look = 0; look < kSeconds * kLooks; ++look) {
        const bool is_bright = level_of(effect, 0.75, 5, (look + 0.5) / kLooks) == 0.75;
        found.bright += is_bright;
        found.changes_per_s += look > 0 && is_bright != was_bright;
        was_bright = is_bright;
    }
    return {found.bright / (kSeconds * kLooks), found.changes_per_s / kSeconds};
}

/// 15 tics dark and 5 bright: a quarter, 3.5 changes a second. At 60 ticks a second 26 and 9 ticks would be neither.
TEST(Light, KeepsTheTimesOfItsOwnClock) {
    LightEffectRecord strobe = effect(LightKind::strobe);
    strobe.dark_s = 15 / 35.;
    strobe.bright_s = 5 / 35.;
    strobe.clock_hz = 35;
    EXPECT_NEAR(restlessness(strobe).bright, 0.25, 0.0005);
    EXPECT_NEAR(restlessness(strobe).changes_per_s, 3.5, 0.001);
}

/// Doom's: dark for 1 to 8 tics, bright for 1 or 65, all as likely: 12 % dark, 2 * 35 / 37.5 changes a second.
TEST(Light, FlickersAsRestlesslyAsItsTimesSay) {
    LightEffectRecord flicker = effect(LightKind::flicker);
    flicker.dark_s = 33 / 35.;
    flicker.bright_s = 4.5 / 35;
    flicker.clock_hz = 70;
    EXPECT_NEAR(restlessness(flicker).bright, 0.88, 0.0005);
    EXPECT_NEAR(restlessness(flicker).changes_per_s, 2 * 35 / 37.5, 0.05);
}

TEST(Light, IsNeverDarkerThanItWouldBeWithoutItsEffect) {
    EXPECT_EQ(level_of(effect(LightKind::strobe), 0.125, 5, 1), 0.125);
}

}  // namespace
}  // namespace enfilade
