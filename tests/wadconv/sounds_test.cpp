// Doom's sounds, and what they are heard of.
#include "wadconv/convert.h"

#include <gmock/gmock.h>

#include "base/files.h"
#include "wadconv/converted.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string error_of_sound(const Bytes& bytes) {
    const Result<Bytes> wav = wav_of({"DSPISTOL", bytes});
    return wav ? "" : wav.error().text();
}

TEST(WadSounds, BecomeWavFilesOfOneChannelAndEightBits) {
    const Bytes lump = sound(22050, {128, 255, 0});
    const Bytes wav = wav_of({"DSPISTOL", lump}).value();
    ASSERT_EQ(wav.size(), 48u);
    ByteReader in(wav);
    in.take(16);
    EXPECT_EQ(in.u32(), 16u);
    EXPECT_EQ(in.u16(), 1u);
    EXPECT_EQ(in.u16(), 1u);
    EXPECT_EQ(in.u32(), 22050u);
    EXPECT_EQ(in.u32(), 22050u);
    EXPECT_EQ(in.u16(), 1u);
    EXPECT_EQ(in.u16(), 8u);
    in.take(4);
    EXPECT_EQ(in.u32(), 3u);
    EXPECT_THAT(in.take(3), ElementsAre(std::byte{128}, std::byte{255}, std::byte{0}));
}

TEST(WadSounds, TellTheirFilesHowLongTheyAre) {
    const Bytes lump = sound(22050, {128, 255, 0});
    const Bytes wav = wav_of({"DSPISTOL", lump}).value();
    ByteReader in(wav);
    in.take(4);
    EXPECT_EQ(in.u32(), wav.size() - 8);
}

TEST(WadSounds, AreRefusedWhenCutOff) {
    Bytes lump = sound(11025, {1, 2, 3});
    while (!lump.empty()) {
        lump.pop_back();
        EXPECT_THAT(error_of_sound(lump), HasSubstr("DSPISTOL: the sound is cut off"));
    }
}

TEST(WadSounds, AreRefusedWhenTheyAreOfAnotherKind) {
    Bytes lump = sound(11025, {1});
    lump[0] = std::byte{0};
    EXPECT_THAT(error_of_sound(lump), HasSubstr("found 0"));
}

TEST(WadSounds, AreRefusedWithoutSamplesOrRate) {
    EXPECT_THAT(error_of_sound(sound(11025, {})), HasSubstr("empty"));
    EXPECT_THAT(error_of_sound(sound(0, {1})), HasSubstr("empty"));
}

TEST(WadSounds, ThatAreBrokenAreToldAndLeftOut) {
    WadBuilder wad;
    wad.add("DSDOROPN");
    const Sounds sounds = Sounds::list(pile_of({wad.finish()}));
    EXPECT_FALSE(sounds.has("doropn"));
    ASSERT_EQ(sounds.problems().size(), 1u);
}

/// The doorway's line with a special and a tag, and the sector behind it with that tag.
Converted with_line(int special, const std::string& upper = "WALL") {
    Doorway doorway;
    doorway.line().special = static_cast<std::uint16_t>(special);
    doorway.line().tag = 7;
    doorway.level.map.sectors[1].tag = 7;
    doorway.right().upper = upper;
    return Converted(doorway.level);
}

const SectorRecord& behind(const Converted& c) { return c.file.sectors.at(1); }

TEST(ConvertSounds, OfDoorsDifferOnTheWayDown) {
    const Converted c = with_line(1);
    EXPECT_EQ(behind(c).move_sound, "doropn");
    EXPECT_EQ(behind(c).down_sound, "dorcls");
    EXPECT_EQ(behind(c).stop_sound, "");
}

TEST(ConvertSounds, OfADoorBehindOneLineAreThoseOfAllItsParts) {
    Doorway doorway;
    doorway.line().special = 1;
    doorway.level.box(256, 0, 320, 64, 1);
    const Converted c(doorway.level);
    EXPECT_EQ(c.file.sectors.at(2).name, "s1b");
    EXPECT_EQ(c.file.sectors.at(2).move_sound, "doropn");
}

TEST(ConvertSounds, OfFastDoorsAreTheirOwn) {
    const Converted c = with_line(117);
    EXPECT_EQ(behind(c).move_sound, "bdopn");
    EXPECT_EQ(behind(c).down_sound, "bdcls");
}

TEST(ConvertSounds, OfLiftsTellThatTheyArrive) {
    const Converted c = with_line(62);
    EXPECT_EQ(behind(c).move_sound, "pstart");
    EXPECT_EQ(behind(c).stop_sound, "pstop");
}

TEST(ConvertSounds, OfFloorsGoOnWhileTheyMove) {
    const Converted c = with_line(18);
    EXPECT_EQ(behind(c).move_sound, "stnmov");
    ASSERT_FALSE(c.file.sounds.empty());
    const auto stone = std::ranges::find(c.file.sounds, "stnmov", &SoundRecord::name);
    EXPECT_TRUE(stone->loops);
    EXPECT_EQ(stone->file, "sounds/stnmov.wav");
    EXPECT_EQ(stone->reach, 37.5);
}

TEST(ConvertSounds, OfSwitchesComeFromWallsThatShowOne) {
    EXPECT_EQ(with_line(62, "SW1WALL").wall("s0", 64, 64).triggers.at(0).sound, "swtchn");
    EXPECT_EQ(with_line(11, "SW1WALL").wall("s0", 64, 64).triggers.at(0).sound, "swtchx");
    EXPECT_EQ(with_line(62).wall("s0", 64, 64).triggers.at(0).sound, "");
}

TEST(ConvertSounds, OfTeleportsComeFromTheirLine) {
    Doorway doorway;
    doorway.line().special = 97;
    doorway.line().tag = 7;
    doorway.level.map.sectors[1].tag = 7;
    doorway.level.thing(96, 32, 14);
    EXPECT_EQ(Converted(doorway.level).wall("s0", 64, 64).triggers.at(0).sound, "telept");
}

TEST(ConvertSounds, OfPickUpsAreHeardWhenTheyAreTouched) {
    Level level;
    level.sector();
    level.box(0, 0, 64, 64, 0);
    level.thing(32, 32, 2012);
    const Converted c(level);
    ASSERT_EQ(c.file.things.at(0).triggers.size(), 1u);
    EXPECT_EQ(c.file.things[0].triggers[0].on, Activation::touch);
    EXPECT_EQ(c.file.things[0].triggers[0].sound, "itemup");
}

TEST(ConvertSounds, AreOnlyThoseThatAreCalledFor) {
    std::vector<std::string> names;
    for (const SoundRecord& sound : with_line(1).file.sounds) names.push_back(sound.name);
    EXPECT_THAT(names, ElementsAre("dorcls", "doropn"));
    EXPECT_THAT(with_line(0).file.sounds, IsEmpty());
}

}  // namespace
}  // namespace enfilade::wadconv
