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
    for (const char* command : {"play", "render", "fly", "check", "bench"}) EXPECT_THAT(ended.out, HasSubstr(command));
}

TEST(CommandLine, ExplainsEveryCommand) {
    for (const char* command : {"play", "render", "fly", "check", "bench"}) {
        const Ended ended = Program().run({command, "--help"});
        EXPECT_EQ(ended.exit_code, 0) << command;
        EXPECT_THAT(ended.out, HasSubstr("--textures")) << command;
    }
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

}  // namespace
}  // namespace enfilade
