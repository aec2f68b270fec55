// Lights as functions of time.
#include <gtest/gtest.h>

#include <set>

#include "world/input.h"
#include "world/light.h"

namespace enfilade {
namespace {

constexpr double kTick = kTickSeconds;

LightEffectRecord effect(LightKind kind) { return {kind, 0.25, 0.5, 0.125, false, false, {}}; }

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

TEST(Light, IsNeverDarkerThanItWouldBeWithoutItsEffect) {
    EXPECT_EQ(level_of(effect(LightKind::strobe), 0.125, 5, 1), 0.125);
}

}  // namespace
}  // namespace enfilade
