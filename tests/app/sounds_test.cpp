// The sounds of a map, from their files.
#include "app/sounds.h"

#include <gmock/gmock.h>

#include "platform/audio.h"
#include "support/map_builder.h"
#include "support/wav.h"

namespace enfilade {
namespace {

using namespace test;

/// Of these files, only maps/good.wav is a sound.
Result<Bytes> read_sound(const std::string& path) {
    if (path == "maps/good.wav") return wav_of(tone(4800, 440));
    if (path == "maps/bad.wav") return Bytes(100, std::byte{'?'});
    return Error{path, "no such file"};
}

Map map_with(const std::string& file_name) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    file.sounds = {{"hum", file_name, 1, 10, false, {}}};
    return built(file);
}

/// One fault, of the only sound, that names the file.
auto faults_say(const std::string& path) {
    return testing::ElementsAre(testing::AllOf(testing::Field(&SoundFault::sound, SoundId(0u)),
                                               testing::Field(&SoundFault::sentence, testing::HasSubstr(path))));
}

TEST(LoadedSounds, AreReadFromTheFolderOfTheMap) {
    const LoadedSounds loaded = load_sounds(map_with("good.wav"), "maps/hall.toml", read_sound);
    ASSERT_EQ(loaded.samples.size(), 1u);
    EXPECT_EQ(loaded.samples[0].size(), 4800u);
    EXPECT_THAT(loaded.faults, testing::IsEmpty());
}

TEST(LoadedSounds, AreSilentWhereTheFileIsMissing) {
    const LoadedSounds loaded = load_sounds(map_with("missing.wav"), "maps/hall.toml", read_sound);
    EXPECT_THAT(loaded.samples[0], testing::IsEmpty());
    EXPECT_THAT(loaded.faults, faults_say("maps/missing.wav"));
}

TEST(LoadedSounds, AreSilentWhereTheFileIsNoSound) {
    const LoadedSounds loaded = load_sounds(map_with("bad.wav"), "maps/hall.toml", read_sound);
    EXPECT_THAT(loaded.samples[0], testing::IsEmpty());
    EXPECT_THAT(loaded.faults, faults_say("maps/bad.wav"));
}

TEST(LoadedSounds, TogetherPlayNoLongerThanTheirBudget) {
    const Bytes longest = wav_of(std::vector<double>(static_cast<std::size_t>(kLongestSound) * kMixRate));
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    for (int i = 0; i < 17; ++i) file.sounds.push_back({"hum" + std::to_string(i), "hum.wav", 1, 10, false, {}});
    const LoadedSounds loaded = load_sounds(built(file), "hall.toml", [&](const std::string&) { return longest; });
    std::vector<std::size_t> silent;
    for (const SoundFault& fault : loaded.faults) silent.push_back(fault.sound.index);
    ASSERT_THAT(silent, testing::ElementsAre(15u, 16u));
    EXPECT_TRUE(loaded.samples[15].empty() && !loaded.samples[14].empty());
    EXPECT_THAT(loaded.faults[0].sentence,
                testing::HasSubstr("at most 1800 s together, found no room for this one of 120 s"));
}

TEST(HeardMoment, IsAsManySecondsOldAtAnyRate) {
    for (const TickRate rate : {TickRate::hz60, TickRate::hz35, TickRate::hz140}) {
        const double second = ticks_per_second(rate);
        Voice voice{};
        voice.since = 3 * second;
        const HeardMoment heard = at_usual_rate({voice, voice}, 5 * ticks_per_second(rate), rate);
        EXPECT_DOUBLE_EQ(heard.tick, 5 * kTickRate);
        ASSERT_EQ(heard.voices.size(), 2u);
        for (const Voice& each : heard.voices) EXPECT_DOUBLE_EQ(each.since, 3 * kTickRate);
    }
}

}  // namespace
}  // namespace enfilade
