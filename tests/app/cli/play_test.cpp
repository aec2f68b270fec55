// `enfilade play` from outside, on displays that nobody looks at.
#include <gmock/gmock.h>

#include "app/cli/program.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

/// Plays for about half a second; the signal is what closing the window is.
Ended play_for_a_moment(const Program& program, const std::string& driver, const std::string& renderer = "column") {
    return program.run({"play", "map.toml", "--size", "64x40", "--record", "walk.tape", "--renderer", renderer},
                       "LIBGL_ALWAYS_SOFTWARE=1 SDL_VIDEODRIVER=" + driver + " timeout --preserve-status -s INT 0.7");
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
