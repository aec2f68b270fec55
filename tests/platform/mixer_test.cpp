// What comes out of the mixer: measured, for known places, without a sound card.
#include "platform/audio.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/wav.h"
#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;

/// The level of a sine measured over whole periods is exact but for rounding to float.
constexpr double kFloats = 1e-5;

Samples tone_samples(double seconds = 2) {
    const std::vector<double> values = tone(static_cast<std::size_t>(seconds * kMixRate), 480);
    return {values.begin(), values.end()};
}

Voice voice_of(double level, double side, double since = 0, bool loops = true) {
    return {SoundId(0u), Maker::thing, 0, since, loops, level, side};
}

struct Levels {
    double left = 0, right = 0;
};

/// Root of the mean square of each side, of a tenth of a second: 48 periods of the tone.
Levels measured(Mixer& mixer) {
    std::vector<float> frames(2 * kMixRate / 10);
    mixer.render(frames);
    Levels levels;
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        levels.left += double(frames[i]) * frames[i];
        levels.right += double(frames[i + 1]) * frames[i + 1];
    }
    const double count = static_cast<double>(frames.size()) / 2;
    return {std::sqrt(levels.left / count), std::sqrt(levels.right / count)};
}

/// Of the tone itself.
const double kTone = 0.5 / std::sqrt(2.0);

TEST(Mixer, IsSilentUntilItHears) {
    Mixer mixer({tone_samples()});
    const Levels levels = measured(mixer);
    EXPECT_EQ(levels.left, 0);
    EXPECT_EQ(levels.right, 0);
}

TEST(Mixer, GivesEachSideHalfThePowerOfWhatIsAhead) {
    Mixer mixer({tone_samples()});
    mixer.hear(std::vector{voice_of(0.5, 0)}, 0, 1);
    const Levels levels = measured(mixer);
    EXPECT_NEAR(levels.left, 0.5 * kTone * std::sqrt(0.5), kFloats);
    EXPECT_NEAR(levels.right, 0.5 * kTone * std::sqrt(0.5), kFloats);
}

TEST(Mixer, PutsWhatIsOnTheRightOnTheRight) {
    Mixer mixer({tone_samples()});
    mixer.hear(std::vector{voice_of(1, 1)}, 0, 1);
    const Levels levels = measured(mixer);
    EXPECT_EQ(levels.left, 0);
    EXPECT_NEAR(levels.right, kTone, kFloats);
}

TEST(Mixer, KeepsThePowerOfWhatGoesRoundTheHead) {
    for (const double side : {-1.0, -0.6, -0.1, 0.3, 0.8}) {
        const Gains gains = gains_of(voice_of(1, side));
        EXPECT_NEAR(gains.left * gains.left + gains.right * gains.right, 1, kFloats);
    }
}

TEST(Mixer, ObeysTheVolume) {
    Mixer mixer({tone_samples()});
    mixer.hear(std::vector{voice_of(1, 1)}, 0, 0.25);
    EXPECT_NEAR(measured(mixer).right, 0.25 * kTone, kFloats);
}

TEST(Mixer, BeginsWhereTheSoundIs) {
    Samples ramp(kMixRate);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i) / kMixRate;
    Mixer mixer({ramp});
    mixer.hear(std::vector{voice_of(1, 1, 0, false)}, 30, 1);  // half a second later
    std::vector<float> frames(2 * 1000);
    mixer.render(frames);
    EXPECT_NEAR(frames.back(), 0.5 + 999.0 / kMixRate, kFloats);
}

TEST(Mixer, EndsWhatPlaysOnce) {
    Mixer mixer({tone_samples(0.05)});
    mixer.hear(std::vector{voice_of(1, 1, 0, false)}, 0, 1);
    measured(mixer);
    EXPECT_EQ(mixer.playing(), 0u);
}

TEST(Mixer, RepeatsWhatLoops) {
    Mixer mixer({tone_samples(0.05)});
    mixer.hear(std::vector{voice_of(1, 1)}, 0, 1);
    EXPECT_NEAR(measured(mixer).right, kTone, kFloats);
}

TEST(Mixer, GlidesToANewLevel) {
    Mixer mixer({Samples(kMixRate, 1.0f)});
    mixer.hear(std::vector{voice_of(0.2, 1)}, 0, 1);
    std::vector<float> frames(2 * 480);
    mixer.render(frames);
    mixer.hear(std::vector{voice_of(0.8, 1)}, 0.6, 1);
    mixer.render(frames);
    double steepest = 0;
    for (std::size_t i = 3; i < frames.size(); i += 2)
        steepest = std::max(steepest, double(std::abs(frames[i] - frames[i - 2])));
    EXPECT_NEAR(frames.back(), 0.8, kFloats);
    EXPECT_LE(steepest, 0.6 / Mixer::kGlide + kFloats);
}

TEST(Mixer, FadesOutWhatIsHeardNoMore) {
    Mixer mixer({Samples(kMixRate, 1.0f)});
    mixer.hear(std::vector{voice_of(1, 1)}, 0, 1);
    std::vector<float> frames(2 * 480);
    mixer.render(frames);
    mixer.hear({}, 0.6, 1);
    mixer.render(frames);
    EXPECT_GT(frames[1], 0.9);
    EXPECT_EQ(frames.back(), 0);
    EXPECT_EQ(mixer.playing(), 0u);
}

TEST(Mixer, JumpsAfterAWorldThatJumped) {
    Samples ramp(kMixRate);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i) / kMixRate;
    Mixer mixer({ramp});
    std::vector<float> frames(2 * 480);
    mixer.hear(std::vector{voice_of(1, 1, 0, false)}, 0, 1);
    mixer.render(frames);
    mixer.hear(std::vector{voice_of(1, 1, 0, false)}, 45, 1);
    mixer.render(frames);
    EXPECT_NEAR(frames.back(), 0.75 + 479.0 / kMixRate, kFloats);
}

TEST(Mixer, NeverLeavesTheRange) {
    Mixer mixer({Samples(kMixRate, 1.0f)});
    std::vector<Voice> many;
    for (std::uint32_t i = 0; i < 5; ++i) many.push_back({SoundId(0u), Maker::thing, i, 0, true, 1, 1});
    mixer.hear(many, 0, 1);
    std::vector<float> frames(2 * 480);
    mixer.render(frames);
    EXPECT_EQ(frames.back(), 1);
}

/// From a map to what comes out of the loudspeakers.
Levels heard_in(const MapFile& file, const Place& ear, double yaw_degrees, double tick = 0) {
    const Map map = built(file);
    const World world = *start_of(map);
    Hearing hearing(map);
    const std::vector<Samples> sounds{tone_samples()};
    const std::vector<double> lengths = lengths_of(sounds);
    Mixer mixer(sounds);
    mixer.hear(voices_at({map, world.history, tick}, hearing, {ear, Angle::from_degrees(yaw_degrees)}, lengths), tick,
               1);
    return measured(mixer);
}

void add_tone(MapFile& file, Vec2 position) {
    file.sounds = {{"tone", "tone.wav", 1, 10, false, {}}};
    ThingRecord thing;
    thing.position = position;
    thing.sound = "tone";
    file.things = {thing};
}

TEST(MixedWorld, IsAsLoudAsTheWayIsLong) {
    MapFile file = map_of({box_room("hall", 0, 0, 16, 16)});
    place_player(file, "hall", {4, 4});
    add_tone(file, {9, 4});
    const Levels levels = heard_in(file, {SectorId(0u), {4, 4}}, -90);  // looking up the drawing: x is to the right
    EXPECT_EQ(levels.left, 0);
    EXPECT_NEAR(levels.right, 0.25 * kTone, kFloats);
}

TEST(MixedWorld, ComesRoundACornerFromTheCorner) {
    MapFile file = map_of({room("bend", {{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}})});
    place_player(file, "bend", {1, 5});
    add_tone(file, {5, 1});
    const Levels levels = heard_in(file, {SectorId(0u), {1, 5}}, -90);
    const double way = 2 * std::sqrt(10.0), side = 1 / std::sqrt(10.0), level = (1 - way / 10) * (1 - way / 10) * kTone;
    EXPECT_NEAR(levels.left, level * std::sqrt((1 - side) / 2), kFloats);
    EXPECT_NEAR(levels.right, level * std::sqrt((1 + side) / 2), kFloats);
}

// hard case I10
TEST(MixedWorld, ComesThroughALink) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4), box_room("far", 100, 100, 104, 108)});
    link(file, "hall", {8, 0}, {8, 4}, "far", {100, 100}, {104, 100});
    place_player(file, "hall", {6, 2});
    add_tone(file, {102, 103});
    const Levels levels = heard_in(file, {SectorId(0u), {6, 2}}, 90);
    EXPECT_NEAR(levels.left, 0.25 * kTone, kFloats);
    EXPECT_EQ(levels.right, 0);
}

TEST(MixedWorld, IsSilentBehindAClosedDoor) {
    MapFile file = map_of(
        {box_room("hall", 0, 0, 4, 4, 0, 3), box_room("door", 4, 0, 5, 4, 0, 0), box_room("room", 5, 0, 9, 4, 0, 3)});
    join_all(file);
    place_player(file, "hall", {3, 2});
    add_tone(file, {6, 2});
    const Levels levels = heard_in(file, {SectorId(0u), {3, 2}}, 0);
    EXPECT_EQ(levels.left, 0);
    EXPECT_EQ(levels.right, 0);
}

}  // namespace
}  // namespace enfilade
