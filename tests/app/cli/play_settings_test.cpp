// The settings of `enfilade play` as options and in the user's file, from outside.
#include <gmock/gmock.h>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class PlaySettings : public ::testing::Test {
protected:
    PlaySettings() { program_.write("map.toml", test::kTwoRooms); }

    /// Plays for about half a second; the signal is what closing the window is.
    Ended play(std::vector<std::string> more) const {
        more.insert(more.begin(), {"play", "map.toml"});
        return program_.run(more, "SDL_VIDEODRIVER=dummy timeout --preserve-status -s INT 0.6");
    }
    void write_settings(const std::string& text) const {
        std::filesystem::create_directories(program_.home("config/enfilade"));
        (void)write_file(program_.home("config/enfilade/settings.toml"), std::string_view(text));
    }

    Program program_;
};

TEST_F(PlaySettings, AreOptionsAllAtOnce) {
    const Ended ended = play({"--dial",
                              "light=bands",
                              "--samples",
                              "2",
                              "--accuracy",
                              "fast",
                              "--sampling",
                              "trilinear",
                              "--size",
                              "64x40",
                              "--scale",
                              "2",
                              "--no-fullscreen",
                              "--no-vsync",
                              "--frame-limit",
                              "30",
                              "--fov",
                              "100",
                              "--brightness",
                              "1.5",
                              "--view-bob",
                              "0",
                              "--mouse-speed",
                              "1.4",
                              "--invert-mouse",
                              "--volume",
                              "0.5",
                              "--automap-colors",
                              "safe",
                              "--no-pause-when-away",
                              "--pause-when-away",
                              "--renderer",
                              "column",
                              "--no-true-pitch",
                              "--vsync"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.err, IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(program_.home("config/enfilade/settings.toml"))) << "for this time only";
}

TEST_F(PlaySettings, AreRefusedWithTheNameOfTheOption) {
    const std::pair<const char*, const char*> wrong[] = {
        {"--samples", "9"},      {"--scale", "0"},       {"--frame-limit", "many"},   {"--fov", "nan"},
        {"--volume", "2"},       {"--brightness", "0"},  {"--view-bob", "2"},         {"--mouse-speed", "0"},
        {"--size", "large"},     {"--renderer", "none"}, {"--automap-colors", "red"}, {"--accuracy", "1"},
        {"--sampling", "cubic"}, {"--dial", "spam=2"}};
    for (const auto& [option, value] : wrong) {
        const Ended ended = play({option, value});
        EXPECT_EQ(ended.exit_code, 2) << option;
        EXPECT_THAT(ended.err, HasSubstr(option));
        EXPECT_THAT(ended.err, HasSubstr("expected"));
    }
}

TEST_F(PlaySettings, ChooseTheRendererThatTruePitchNeeds) {
    EXPECT_EQ(play({"--true-pitch"}).exit_code, 0);
    const Ended refused = play({"--true-pitch", "--renderer", "column"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("--renderer stencil"));
}

TEST_F(PlaySettings, AreReadFromTheFileWhichSaysWhatIsWrongWithIt) {
    write_settings("fov = 1000\nfow = 3\n");
    const Ended ended = play({});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_THAT(ended.err, HasSubstr("settings.toml:1:7: error: 'fov': expected a whole number from 10 to 160"));
    EXPECT_THAT(ended.err, HasSubstr("settings.toml:2:1: warning: there is no setting 'fow'; did you mean 'fov'?"));
}

TEST_F(PlaySettings, LetOneStartWhateverTheFileIs) {
    for (const char* damaged : {"", "\xFF\xFE", "[[[", "fov = ", "keys = 3\nsize = [1, 2]\nvsync = \"maybe\"\n",
                                "zz = nan\nfov = inf\nsize = [nan]\n[keys]\nuse = [nan]\nhop = { a = -inf }\n"}) {
        write_settings(damaged);
        EXPECT_EQ(play({}).exit_code, 0) << damaged;
    }
}

TEST_F(PlaySettings, KeepTheMapThatWasPlayedLast) {
    play({});
    EXPECT_TRUE(std::filesystem::exists(program_.home("data/enfilade/last_game.save")));
    const auto bytes = read_file(program_.home("data/enfilade/last_map"));
    ASSERT_TRUE(bytes.ok());
    EXPECT_EQ(as_text(bytes.value()), program_.path("map.toml"));
}

TEST_F(PlaySettings, KeepTheGameBeforeWhereThisOneCannotBeSaved) {
    play({});
    const std::string last = program_.home("data/enfilade/last_game.save");
    const std::string before = test::content(last), map = test::content(program_.home("data/enfilade/last_map"));
    program_.write("other.toml", test::kTwoRooms);
    const Ended ended = program_.run({"play", "other.toml"},
                                     "SDL_VIDEODRIVER=dummy sh -c 'trap \"\" XFSZ; ulimit -f 0; exec timeout "
                                     "--preserve-status -s INT 0.6 \"$@\"' sh");
    EXPECT_EQ(test::content(last), before) << ended.err;
    EXPECT_EQ(test::content(program_.home("data/enfilade/last_map")), map);
}

TEST(Title, OpensWhereNoCommandIsNamedAndThereIsADisplay) {
    const Program program;
    const Ended ended = program.run({}, "SDL_VIDEODRIVER=dummy timeout --preserve-status -s INT 1.5");
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST(Title, SaysWhichCommandsThereAreWhereThereIsNoDisplay) {
    const Program program;
    const Ended ended = program.run({}, "env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER");
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("expected a command: play, render"));
    EXPECT_THAT(ended.err, Not(HasSubstr("did you mean")));
}

}  // namespace
}  // namespace enfilade
