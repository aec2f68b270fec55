// The options of `enfilade play` that change what a player meets, from outside.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "app/cli/program.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;

class PlayOptions : public ::testing::Test {
protected:
    PlayOptions() { program_.write("map.toml", test::kTwoRooms); }

    /// Plays for about half a second; the signal is what closing the window is.
    Ended play(std::vector<std::string> more) const {
        more.insert(more.begin(), {"play", "map.toml", "--size", "64x40"});
        return program_.run(more,
                            "LIBGL_ALWAYS_SOFTWARE=1 SDL_VIDEODRIVER=offscreen timeout --preserve-status -s INT 0.7");
    }

    std::size_t ticks_in(const std::string& tape) const {
        const auto bytes = read_file(program_.path(tape));
        const auto read = bytes.ok() ? read_tape(bytes.value()) : Result<Tape>(bytes.error());
        return read.ok() ? read.value().ticks.size() : 0;
    }

    Program program_;
};

TEST_F(PlayOptions, FillsTheScreen) {
    const Ended ended = play({"--fullscreen"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST_F(PlayOptions, TurnsThePictureByOpenGlOnly) {
    const Ended ended = play({"--true-pitch", "--renderer", "stencil"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST_F(PlayOptions, GoesOnWithASavedGame) {
    play({"--record", "first.tape"});
    const std::size_t before = ticks_in("first.tape");
    EXPECT_GT(before, 0u);
    const Ended ended = play({"--load", "first.tape", "--save", "mine.save", "--record", "second.tape"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_GT(ticks_in("second.tape"), before) << "a tape begins where the map does, or nobody could play it again";
    EXPECT_EQ(play({"--load", "gone.tape"}).exit_code, 1);
}

TEST_F(PlayOptions, RefusesASkillThatThereIsNot) {
    EXPECT_EQ(play({"--skill", "1"}).exit_code, 0);
    const Ended ended = play({"--skill", "6"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("from 1 to 5"));
}

TEST(PlayedFile, ThatIsAPipeIsRefusedWithoutWaitingForIt) {
    const Program program;
    ASSERT_EQ(::mkfifo(program.path("pipe").c_str(), 0600), 0);
    const Ended ended = program.run({"play", "pipe"}, "timeout 60");
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, HasSubstr("pipe: expected a file, found a device or a pipe"));
}

}  // namespace
}  // namespace enfilade
