// `enfilade bench` from outside.
#include <gmock/gmock.h>

#include <algorithm>

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
    EXPECT_THAT(ended.out, HasSubstr("map.toml         1"));
    EXPECT_THAT(ended.out, HasSubstr("turn.toml        3"));
    const std::string csv = program_.text("times.csv");
    EXPECT_THAT(csv, HasSubstr("subject,frame,minimum_ns,median_ns\nmap.toml,0,"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
}

TEST_F(Bench, TimesEveryRenderer) {
    for (const char* renderer : {"column", "stencil", "reference"})
        EXPECT_EQ(bench({"map.toml", "--renderer", renderer}).exit_code, 0) << renderer;
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
    const std::vector<std::vector<std::string>> wrong{
        {"--renderer", "reference"}, {"--threads", "2"}, {"--csv", "times.csv"}};
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
    EXPECT_THAT(ended.err, HasSubstr("expected maps or scripts"));
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
