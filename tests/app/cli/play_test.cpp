// `enfilade play` from outside, on displays that nobody looks at.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "app/cli/program.h"
#include "formats/tape.h"
#include "support/wav.h"
#include "wadconv/wad_builder.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

void put_wad(const Program& program, const std::string& name) {
    wadconv::test::WadBuilder wad = wadconv::test::picture_wad();
    wad.add_map("MAP01", wadconv::test::small_level().map);
    const Bytes bytes = wad.finish("IWAD");
    ASSERT_TRUE(write_file(program.path(name), std::span<const std::byte>(bytes)).ok());
}

/// Plays for about half a second; the signal is what closing the window is.
Ended play_for_a_moment(const Program& program, const std::string& driver, const std::string& renderer = "column",
                        const std::string& more = "") {
    return program.run(
        {"play", "map.toml", "--size", "64x40", "--record", "walk.tape", "--renderer", renderer},
        "LIBGL_ALWAYS_SOFTWARE=1 SDL_VIDEODRIVER=" + driver + " timeout --preserve-status -s INT 0.7 " + more);
}

TEST(Play, RunsWithoutADisplayWhereTheDriverIsNamed) {
    for (const char* driver : {"dummy", "offscreen"}) {
        const Program program;
        program.write("map.toml", test::kTwoRooms);
        const Ended ended = play_for_a_moment(program, driver);
        EXPECT_EQ(ended.exit_code, 0) << driver << ": " << ended.err;
    }
}

TEST(Play, RunsByOpenGlWhereTheDriverHasItAndWhereItHasNot) {
    for (const char* driver : {"offscreen", "dummy"}) {
        const Program program;
        program.write("map.toml", test::kTwoRooms);
        const Ended ended = play_for_a_moment(program, driver, "stencil");
        EXPECT_EQ(ended.exit_code, 0) << driver << ": " << ended.err;
    }
}

/// Whether the library that makes OpenGL contexts was loaded while somebody played, as the dynamic linker tells it.
bool loads_opengl(const std::string& renderer) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    play_for_a_moment(program, "offscreen", renderer, "env LD_DEBUG=files LD_DEBUG_OUTPUT=linker");
    std::string told;
    for (const auto& entry : std::filesystem::directory_iterator(program.path("")))
        if (entry.path().filename().string().starts_with("linker.")) told += program.text(entry.path().filename());
    EXPECT_THAT(told, HasSubstr("libc.so"));
    return told.find("file=libEGL.so") != std::string::npos;
}

TEST(Play, OpensNoOpenGlContextForTheColumnRenderer) {
    EXPECT_TRUE(loads_opengl("stencil")) << "it would not be seen";
    EXPECT_FALSE(loads_opengl("column"));
}

TEST(Play, RecordsWhatWasPlayed) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    play_for_a_moment(program, "dummy");
    const auto bytes = read_file(program.path("walk.tape"));
    ASSERT_TRUE(bytes.ok()) << bytes.error().text();
    const Tape tape = read_tape(bytes.value()).value();
    EXPECT_EQ(tape.map, "map.toml");
    EXPECT_GT(tape.ticks.size(), 0u);
    EXPECT_EQ(tape.ticks.front(), InputRecord{});
}

TEST(Play, OpensTheFirstLevelOfAWad) {
    const Program program;
    put_wad(program, "doomed.wad");
    EXPECT_EQ(program.run({"play", "doomed.wad", "--print-map"}).exit_code, 0) << "converts, which takes its time";
    const Ended ended = program.run({"play", "doomed.wad", "--size", "64x40", "--record", "walk.tape"},
                                    "SDL_VIDEODRIVER=dummy timeout --preserve-status -s INT 0.7");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto bytes = read_file(program.path("walk.tape"));
    ASSERT_TRUE(bytes.ok()) << bytes.error().text();
    EXPECT_THAT(read_tape(bytes.value()).value().map, HasSubstr("map01.toml"));
}

TEST(Play, PrintsWhichMapItWouldPlay) {
    const Program program;
    put_wad(program, "doomed.wad");
    const Ended named = program.run({"play", "doomed.wad", "MAP01", "--print-map"});
    EXPECT_EQ(named.exit_code, 0) << named.err;
    EXPECT_THAT(named.out, HasSubstr(program.home("cache/enfilade/converted/doomed-")));
    EXPECT_TRUE(named.out.ends_with("/map01.toml\n"));
    EXPECT_THAT(named.err, HasSubstr("converting doomed"));
    EXPECT_EQ(program.run({"play", "doomed.wad", "--print-map"}).out, named.out);
    EXPECT_EQ(program.run({"play", "a\nb.toml", "--print-map"}).out, "a\nb.toml\n");
    EXPECT_EQ(program.run({"play", "doomed", "map01", "--print-map"}, "DOOMWADDIR=.").out, named.out);
}

TEST(Play, RefusesWordsThatAreNeitherWadsNorLevels) {
    const Program program;
    put_wad(program, "doomed.wad");
    const Ended missing = program.run({"play", "doomed.wad", "E4M9", "--print-map"});
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_THAT(missing.err, HasSubstr("there is no level E4M9; there are map01 to map01"));
    for (const std::vector<std::string>& words : {std::vector<std::string>{"doomed.wad", "nonsense"},
                                                  {"doomed.wad", "MAP01", "doomed.wad"},
                                                  {"a.toml", "b.toml"}}) {
        std::vector<std::string> arguments{"play", "--print-map"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const Ended ended = program.run(arguments);
        EXPECT_EQ(ended.exit_code, 1);
        EXPECT_THAT(ended.err, HasSubstr("expected"));
    }
}

TEST(Play, LeavesThePlayersFolderAsItIsWhateverAWadIsCalled) {
    const Program program;
    const std::string saved = program.home("data/enfilade/mine.save");
    std::filesystem::create_directories(program.home("data/enfilade"));
    ASSERT_TRUE(write_file(saved, std::string_view("mine")).ok());
    for (const char* name : {"...wad", "..wad", ".wad"}) {
        put_wad(program, name);
        const Ended ended = program.run({"play", name, "--print-map"});
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_TRUE(std::filesystem::exists(ended.out.substr(0, ended.out.size() - 1))) << ended.out;
        EXPECT_EQ(test::content(saved), "mine") << name;
    }
}

TEST(Play, SaysWhatIsWrongWithAWad) {
    const Program program;
    program.write("broken.wad", "PWAD and so on");
    const Ended ended = program.run({"play", "broken.wad"}, "SDL_VIDEODRIVER=dummy");
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("broken.wad: it cannot be converted"));
}

/// The two rooms with a thing that hums ahead of the player on the left.
std::string humming_rooms() {
    return std::string(test::kTwoRooms) +
           "\n[[sounds]]\nname = \"hum\"\nfile = \"hum.wav\"\n\n[[things]]\nx = 6\ny = 1\nsound = \"hum\"\n";
}

/// Plays into a file for about half a second; that there is one says that a device was opened.
Ended play_into_a_file(const Program& program, std::vector<std::string> more = {}) {
    const Bytes hum = test::wav_of(test::tone(48000, 480));
    (void)write_file(program.path("hum.wav"), hum);
    std::vector<std::string> arguments{"play", "map.toml", "--size", "64x40"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return program.run(arguments,
                       "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=disk SDL_DISKAUDIOFILE=played.raw "
                       "timeout --preserve-status -s INT 0.7");
}

TEST(Play, OpensNoSoundDeviceForASilentMap) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    EXPECT_EQ(play_into_a_file(program).exit_code, 0);
    EXPECT_FALSE(program.exists("played.raw"));
}

TEST(Play, OpensNoSoundDeviceWhereItIsMuted) {
    const Program program;
    program.write("map.toml", humming_rooms());
    EXPECT_EQ(play_into_a_file(program, {"--mute"}).exit_code, 0);
    EXPECT_FALSE(program.exists("played.raw"));
}

TEST(Play, PlaysTheSoundsOfAMap) {
    const Program program;
    program.write("map.toml", humming_rooms());
    EXPECT_EQ(play_into_a_file(program).exit_code, 0);
    const auto played = read_file(program.path("played.raw"));
    ASSERT_TRUE(played.ok());
    const std::span<const std::byte> bytes = played.value();
    const std::size_t sounding =
        std::size_t(std::ranges::count_if(bytes, [](std::byte b) { return b != std::byte{}; }));
    EXPECT_GT(sounding, 10000u);
}

TEST(Play, GoesOnWithoutASoundDevice) {
    const Program program;
    program.write("map.toml", humming_rooms());
    const Ended ended = program.run({"play", "map.toml", "--size", "64x40"},
                                    "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=none_such "
                                    "timeout --preserve-status -s INT 0.7");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST(Play, SaysThatThereIsNoDisplay) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    const Ended ended = program.run({"play", "map.toml"}, "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER");
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("display"));
}

TEST(Play, RefusesAMapWithErrorsBeforeAWindowOpens) {
    const Program program;
    program.write("map.toml", "format = 1\nnonsense = 1\n");
    const Ended ended = program.run({"play", "map.toml"}, "SDL_VIDEODRIVER=dummy");
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("map.toml:2:1: error"));
}

}  // namespace
}  // namespace enfilade
