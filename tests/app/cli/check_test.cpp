// `enfilade check` and the command line itself, from outside.
#include <gmock/gmock.h>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(CommandLine, ExplainsItself) {
    const Ended ended = Program().run({"--help"});
    EXPECT_EQ(ended.exit_code, 0);
    for (const char* command : {"play", "render", "fly", "check", "bench", "accuracy", "new", "expand", "fmt", "draw"})
        EXPECT_THAT(ended.out, HasSubstr(command));
}

TEST(CommandLine, ExplainsEveryCommand) {
    for (const char* command : {"play", "render", "fly", "check", "bench", "accuracy"}) {
        const Ended ended = Program().run({command, "--help"});
        EXPECT_EQ(ended.exit_code, 0) << command;
        EXPECT_THAT(ended.out, HasSubstr("--textures")) << command;
    }
}

/// With so much memory for all addresses; the exit status.
int draw_within(const Program& program, int limit_kib) {
    const Ended ended =
        program.run({"render", "map.toml", "--out", "x.png"}, "ulimit -v " + std::to_string(limit_kib) + ";");
    if (ended.exit_code == 127) return ended.exit_code;  // not even the libraries can be loaded
    SCOPED_TRACE(std::to_string(limit_kib) + " KiB: " + ended.err);
    EXPECT_THAT(ended.exit_code, ::testing::AnyOf(0, 1));
    EXPECT_EQ(program.hidden_files(), 0u);
    if (ended.exit_code == 0) return 0;
    EXPECT_THAT(ended.err, HasSubstr("enfilade: there is not enough memory for this\n"));
    return ended.exit_code;
}

TEST(CommandLine, EndsWithASentenceWhereMemoryIsShort) {
    constexpr int kStepKib = 2'000, kFineStepKib = 20;
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    int short_of_it = 0, first_kib = 0;
    for (int limit_kib = 30'000; limit_kib <= 250'000; limit_kib += kStepKib) {
        const int exit_code = draw_within(program, limit_kib);
        if (exit_code != 127 && first_kib == 0) first_kib = limit_kib;
        short_of_it += exit_code == 1;
    }
    EXPECT_GT(short_of_it, 0);
    // Where the libraries only just get their memory, before main() there may be none for their constants.
    for (int limit_kib = first_kib - kStepKib; limit_kib < first_kib; limit_kib += kFineStepKib)
        draw_within(program, limit_kib);
}

TEST(CommandLine, TellsItsVersion) {
    const Ended ended = Program().run({"--version"});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_THAT(ended.out, ::testing::MatchesRegex("enfilade [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, RefusesWrongUsageInOneSentence) {
    const std::vector<std::vector<std::string>> wrong{
        {}, {"paint"}, {"check"}, {"render", "map.toml"}, {"check", "--loud", "m"}};
    for (const auto& arguments : wrong) {
        const Ended ended = Program().run(arguments);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_THAT(ended.err, HasSubstr("--help"));
        EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
        EXPECT_EQ(ended.out, "");
    }
}

TEST(CommandLine, SuggestsWhatIsCalledNearlySo) {
    EXPECT_THAT(Program().run({"chekc", "map.toml"}).err, HasSubstr("found 'chekc'; did you mean 'check'?"));
    EXPECT_THAT(Program().run({"render", "map.toml", "--ouy", "a.png"}).err,
                HasSubstr("no option '--ouy' here; did you mean '--out'?"));
}

TEST(CommandLine, NamesTheCommandForAFile) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("walk.toml", "map = \"map.toml\"\n[[legs]]\nwait = 1\n");
    EXPECT_THAT(program.run({"map.toml"}).err, HasSubstr("`enfilade play map.toml`"));
    EXPECT_THAT(program.run({"walk.toml"}).err, HasSubstr("`enfilade fly walk.toml"));
}

TEST(CommandLine, SaysWhatAFileIsThatIsNoMap) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("walk.toml", "map = \"map.toml\"\n[[legs]]\nwait = 1\n");
    program.write("doom.wad", "IWAD and so on");
    program.write("folder/map.toml", test::kTwoRooms);
    const std::vector<std::pair<std::string, std::string>> expected{
        {"walk.toml", "expected a map (.toml), found a flythrough script; `enfilade fly walk.toml"},
        {"doom.wad", "expected a map (.toml), found a WAD of Doom; `wadconv doom.wad"},
        {"folder", "expected a map (.toml), found a folder; name a file in it, such as folder/map.toml"},
        {"mapp.toml", "no such file; did you mean map.toml?"},
        {"map", "no such file; did you mean map.toml?"}};
    for (const auto& [file, sentence] : expected) {
        EXPECT_THAT(program.run({"render", file, "--out", "a.png"}).err, HasSubstr(file + ": " + sentence));
        if (file != "doom.wad") {  // which play opens
            EXPECT_THAT(program.run({"play", file}, "SDL_VIDEODRIVER=dummy").err, HasSubstr(file + ": " + sentence));
        }
        if (file == "folder") continue;  // all maps in it are checked
        EXPECT_THAT(program.run({"check", file}).out, HasSubstr("error: " + sentence));
    }
}

TEST(Check, PassesASoundMapWithWarnings) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    const Ended ended = program.run({"check", "map.toml"});
    EXPECT_EQ(ended.exit_code, 0) << ended.out << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("map.toml:"));
    EXPECT_THAT(ended.out, HasSubstr(": warning: "));
    EXPECT_THAT(ended.out, HasSubstr("1 map checked, 0 refused: 0 errors, 2 warnings"));
}

TEST(Check, PointsAtErrors) {
    const Program program;
    program.write("map.toml", "format = 1\nnonsense = 3\n" + std::string(test::kTwoRooms).substr(11));
    const Ended ended = program.run({"check", "map.toml"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.out, HasSubstr("map.toml:2:1: error: "));
    EXPECT_THAT(ended.out, HasSubstr("1 refused: 1 error"));
}

TEST(Check, LooksAtEveryMapThatIsNamed) {
    const Program program;
    program.write("good.toml", test::kTwoRooms);
    const Ended ended = program.run({"check", "gone.toml", "good.toml"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.out, HasSubstr("gone.toml: error: "));
    EXPECT_THAT(ended.out, HasSubstr("2 maps checked, 1 refused"));
}

TEST(Check, LooksAtEveryMapOfAFolderAndAtNoScript) {
    const Program program;
    program.write("maps/a.toml", test::kTwoRooms);
    program.write("maps/b.toml", test::kTwoRooms);
    program.write("maps/walk.toml", "map = \"a.toml\"\n[[legs]]\nwait = 1\n");
    program.write("maps/notes.txt", "nothing");
    const Ended ended = program.run({"check", "maps"});
    EXPECT_EQ(ended.exit_code, 0) << ended.out;
    EXPECT_THAT(ended.out, HasSubstr("2 maps checked, 0 refused"));
}

TEST(Check, RefusesAFolderWithoutMaps) {
    const Program program;
    program.write("empty/notes.txt", "nothing");
    const Ended ended = program.run({"check", "empty"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.out, HasSubstr("empty: error: expected a map (.toml), found a folder"));
}

TEST(Check, PointsAtFilesThatAreMissingBesideTheMap) {
    const Program program;
    program.write("map.toml",
                  std::string(test::kTwoRooms) +
                      "[[sounds]]\nname = \"hum\"\nfile = \"hum.wav\"\n[[things]]\nx = 4\ny = 3\n"
                      "triggers = [{ on = \"touch\", do = \"exit\", target = \"map\" }]\n[[things]]\nx = 5\n"
                      "y = 3\ntriggers = [{ on = \"touch\", do = \"exit\", target = \"cellar\" }]\n");
    const Ended ended = program.run({"check", "map.toml"});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_THAT(ended.out, HasSubstr("map.toml:30:8: warning: sound 'hum' is silent"));
    EXPECT_THAT(ended.out, HasSubstr("map.toml:38:51: warning: expected a map in cellar.toml"));
    EXPECT_THAT(ended.out, HasSubstr("4 warnings"));
}

TEST(Check, SuggestsAPicture) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("textures/wal.png", "");
    EXPECT_THAT(program.run({"check", "map.toml"}).out, HasSubstr("a placeholder is drawn; did you mean 'wal'?"));
}

TEST(Check, TellsWhatAMapCallsFor) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    EXPECT_THAT(program.run({"check", "map.toml", "--effects"}).out, HasSubstr("nothing beyond plain rooms"));
    EXPECT_THAT(program.run({"check", "map.toml"}).out, Not(HasSubstr("plain rooms")));
}

TEST(Check, LooksForPicturesWhereItIsTold) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("pictures/wall.png", "not a picture");
    const Ended ended = program.run({"check", "--textures", "pictures", "map.toml"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.out, HasSubstr("1 error, 1 warning"));
}

// Each of these lamps reaches every wall.
TEST(Check, TellsOfLightsThatAreLeftOut) {
    std::string corners, walls, lights;
    const auto corner = [](double along, double across) {
        return std::to_string(along) + ", " + std::to_string(across) + ", ";
    };
    for (int i = 0; i < 500; ++i) corners += corner(i / 16.0, i % 2 / 16.0);
    for (int i = 500; i > 0; --i) corners += corner(i / 16.0, 16 + i % 2 / 16.0);
    for (int i = 0; i < 1000; ++i) walls += "{ texture = \"-\" }, ";
    for (int i = 0; i < 100; ++i) lights += "[[lights]]\nx = 16\ny = 8\nz = 1\nreach = 50\n";
    const Program program;
    program.write("map.toml",
                  "format = 1\nname = \"hall\"\n[player]\nsector = \"hall\"\nx = 16\ny = 8\n"
                  "[[sectors]]\nname = \"hall\"\nfloor = { z = 0 }\nceiling = { z = 4 }\n"
                  "[[sectors.loops]]\nv = [" +
                      corners + "]\nwalls = [" + walls + "]\n" + lights);
    const Ended ended = program.run({"check", "map.toml"});
    EXPECT_THAT(ended.out, HasSubstr("[lights-left-out]"));
    EXPECT_THAT(ended.out, HasSubstr("the light at (16, 8) and all after it light nothing more"));
}

}  // namespace
}  // namespace enfilade
