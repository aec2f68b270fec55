// `enfilade bench` from outside.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

class Bench : public ::testing::Test {
protected:
    Bench() {
        program_.write("map.toml", test::kTwoRooms);
        program_.write("turn.toml", "map = \"map.toml\"\nrate = 2\n[[legs]]\nseconds = 1\nturn = 90\n");
    }

    /// Runs `bench --size 64x40 --rounds 2` with more arguments.
    Ended bench(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"bench", "--size", "64x40", "--rounds", "2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return program_.run(arguments);
    }

    Program program_;
};

TEST_F(Bench, TimesTheViewOfAMapAndEveryFrameOfAScript) {
    const Ended ended = bench({"map.toml", "turn.toml", "--csv", "times.csv"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("map.toml        1"));
    EXPECT_THAT(ended.out, HasSubstr("turn.toml       3"));
    const std::string csv = program_.text("times.csv");
    EXPECT_THAT(csv, HasSubstr("subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash\nmap.toml,0,"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
}

TEST_F(Bench, TimesEveryViewOfAWalk) {
    program_.write("walk.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n3,3,1.5,90,-10\n");
    const Ended ended = bench({"map.toml", "map.toml:walk.csv", "--csv", "-"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("map.toml:walk.csv       2"));
    EXPECT_THAT(ended.out, HasSubstr("map.toml:walk.csv,1,"));
    // The first view of the walk is that of the player: the same picture.
    const auto hash_of_frame = [&](const std::string& subject) {
        const std::size_t row = ended.out.find("\n" + subject + ",0,");
        return ended.out.substr(ended.out.find('\n', row + 1) - 16, 16);
    };
    EXPECT_EQ(hash_of_frame("map.toml"), hash_of_frame("map.toml:walk.csv"));
}

TEST_F(Bench, CountsTheSameWithAnyNumberOfThreads) {
    const std::string map = ENFILADE_SOURCE_DIR "/maps/enfilade.toml";
    const auto counts_with = [&](const char* threads) {
        const Ended ended =
            program_.run({"bench", map, "--size", "640x400", "--rounds", "1", "--threads", threads, "--csv", "-"});
        std::size_t counts = ended.out.size();
        for (int comma = 0; comma < 5; ++comma) counts = ended.out.rfind(',', counts - 1);  // walls and what follows
        return ended.out.substr(counts);
    };
    const std::string one = counts_with("1");
    EXPECT_THAT(one, HasSubstr(",256000,"));
    EXPECT_EQ(counts_with("3"), one);
    EXPECT_EQ(counts_with("8"), one);
}

TEST_F(Bench, RefusesWalksThatCannotBeWalked) {
    program_.write("out.csv", "x,y,z,yaw,pitch\n2,3,1.5,0,0\n300,3,1.5,90,-10\n");
    program_.write("empty.csv", "x,y,z,yaw,pitch\n");
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"map.toml:out.csv", "out.csv:3: expected a view inside the map"},
        {"map.toml:empty.csv", "empty.csv: expected at least one view"},
        {"map.toml:gone.csv", "gone.csv"},
        {"gone.toml:out.csv", "gone.toml"},
        {"out.csv", "expected MAP:WALK.csv"}};
    for (const auto& [subject, message] : wrong) {
        const Ended ended = bench({subject});
        EXPECT_EQ(ended.exit_code, 1) << subject;
        EXPECT_THAT(ended.err, HasSubstr(message));
    }
}

TEST_F(Bench, TakesTurnsWithAnotherProgram) {
    const Ended ended = bench({"map.toml", "turn.toml", "--against", ENFILADE_PROGRAM});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, ::testing::ContainsRegex("turn.toml .* the same\nmean "));
}

TEST_F(Bench, SaysWhatIsWrongWithTheOtherProgram) {
    program_.write("older.sh", "#!/bin/sh\necho \"enfilade: --csv: no such option\" >&2\nexit 2\n");
    std::filesystem::permissions(program_.path("older.sh"), std::filesystem::perms::owner_all);
    const std::vector<std::pair<std::string, std::string>> wrong{
        {program_.path("older.sh"), "it ended with 2 and said: enfilade: --csv: no such option"},
        {"/bin/true", "expected rows of `subject,frame"},
        {"./it is $(not) here", "it ended with 127"}};
    for (const auto& [other, message] : wrong) {
        const Ended ended = bench({"map.toml", "--against", other});
        EXPECT_EQ(ended.exit_code, 1) << other;
        EXPECT_THAT(ended.err, HasSubstr(message));
    }
}

TEST_F(Bench, CountsInstructionsOrSaysWhatItNeeds) {
    const bool is_there = std::system("valgrind --version >/dev/null 2>&1") == 0;
    const Ended ended = bench({"map.toml", "--instructions"});
    EXPECT_EQ(ended.exit_code, is_there ? 0 : 1) << ended.err;
    const std::string told = is_there ? "instructions/pixel\nmap.toml +[1-9][0-9]*[.][0-9]+\n" : "";
    EXPECT_THAT(ended.out, ::testing::ContainsRegex(told));
    const Ended without = program_.run({"bench", "map.toml", "--instructions"}, "PATH=");
    EXPECT_EQ(without.exit_code, 1);
    EXPECT_THAT(without.err, HasSubstr("expected valgrind to be installed"));
}

TEST_F(Bench, CountsTheSameInstructionsAgainAndInAnotherFolder) {
    if (std::system("valgrind --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "valgrind is not installed";
    const std::string maps = ENFILADE_SOURCE_DIR "/maps",
                      elsewhere = program_.path("maps in a folder with a longer name");
    std::filesystem::create_directory_symlink(maps, elsewhere);
    std::vector<double> counts;
    for (const std::string& folder : {maps, maps, elsewhere}) {
        const std::string map = folder + "/rooms.toml";
        const Ended ended = program_.run({"bench", map, "--instructions", "--size", "640x400"});
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
        counts.push_back(std::strtod(ended.out.c_str() + ended.out.rfind(' '), nullptr));
    }
    ASSERT_GT(counts[0], 1);
    for (const double count : counts) EXPECT_NEAR(count / counts[0], 1, 0.001);
}

TEST_F(Bench, RefusesWhatOtherProcessesDoNotTell) {
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{"--against", "/bin/true", "--csv", "times.csv"},
                                               {"--against", "/bin/true", "--instructions"},
                                               {"--instructions", "--threads", "2"},
                                               {"--instructions", "--renderer", "stencil"},
                                               {"--effects", "--against", "/bin/true"}}) {
        std::vector<std::string> all{"map.toml"};
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(bench(all).exit_code, 2) << more[0];
    }
}

TEST_F(Bench, TimesEveryRenderer) {
    for (const char* renderer : {"column", "stencil", "reference"})
        EXPECT_EQ(bench({"map.toml", "--renderer", renderer}).exit_code, 0) << renderer;
}

TEST_F(Bench, SaysWithWhichInnerLoops) {
    ASSERT_EQ(setenv("ENFILADE_KERNELS", "scalar", 1), 0);
    EXPECT_THAT(bench({"map.toml"}).out, HasSubstr("inner loops: scalar\n"));
    EXPECT_EQ(bench({"map.toml", "--renderer", "reference"}).out.find("inner loops"), std::string::npos);
    ASSERT_EQ(setenv("ENFILADE_KERNELS", "mmx", 1), 0);
    const Ended refused = bench({"map.toml"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("ENFILADE_KERNELS: expected kernels that this processor can run"));
    ASSERT_EQ(unsetenv("ENFILADE_KERNELS"), 0);
}

TEST_F(Bench, WritesTheTableOfEffectPrices) {
    program_.write("map.toml", test::kTwoRooms + std::string("\n[render]\nfog_reach = 4\n"));
    const Ended ended = bench({"--effects", "map.toml"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("\n|---|"));
    EXPECT_THAT(ended.out, ::testing::ContainsRegex("[|] fog [|] 1 map [|] [+-]0"));
    EXPECT_THAT(ended.out, HasSubstr("(column, 64x40, one thread"));
}

TEST_F(Bench, RefusesWhatPricesHaveNoChoiceOf) {
    const std::vector<std::vector<std::string>> wrong{{"--renderer", "reference"}, {"--threads", "2"},
                                                      {"--samples", "2"},          {"--accuracy", "fast"},
                                                      {"--dial", "span=2"},        {"--csv", "times.csv"}};
    for (const auto& arguments : wrong) {
        std::vector<std::string> all{"--effects", "map.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ended ended = bench(all);
        EXPECT_EQ(ended.exit_code, 2) << arguments[0];
        EXPECT_THAT(ended.err, HasSubstr("enfilade: " + arguments[0]));
    }
}

TEST_F(Bench, RefusesNothingToMeasure) {
    const Ended ended = bench({});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("expected maps, walks or scripts"));
}

TEST_F(Bench, RefusesWhatHasErrorsAndWritesNothing) {
    program_.write("bad.toml", "format = 1\nnonsense = 3\n");
    program_.write("worse.toml", "map = \"none.toml\"\n");
    for (const char* file : {"bad.toml", "worse.toml", "gone.toml"}) {
        const Ended ended = bench({file, "--csv", "times.csv"});
        EXPECT_EQ(ended.exit_code, 1) << file;
        EXPECT_THAT(ended.err, HasSubstr(file));
        EXPECT_EQ(ended.out, "");
    }
    EXPECT_FALSE(program_.exists("times.csv"));
}

}  // namespace
}  // namespace enfilade
