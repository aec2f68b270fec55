// The sounds of a map, from their files.
#include "app/sounds.h"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace enfilade
