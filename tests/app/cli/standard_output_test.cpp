// Every command into a standard output that takes nothing, or only a part of it: exit status 1, and one sentence.
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

#include "app/cli/program.h"
#include "wadconv/wad_builder.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::EndsWith;
using ::testing::HasSubstr;

using Words = std::vector<std::string>;

constexpr const char* kStand = "map = \"map.toml\"\nsize = [32, 20]\nrate = 4\n[[legs]]\nwait = 1\n";

/// Both programs with all that they write to standard output.
const std::vector<Words> kInvocations{
    {ENFILADE_PROGRAM, "--help"},
    {ENFILADE_PROGRAM, "--version"},
    {ENFILADE_PROGRAM, "render", "map.toml", "--size", "32x20", "--out", "x.png", "--at", "1,1"},
    {ENFILADE_PROGRAM, "render", "map.toml", "--size", "32x20", "--out", "-"},
    {ENFILADE_PROGRAM, "render", "map.toml", "--size", "32x20", "--out", "x.png", "--timing", "-"},
    {ENFILADE_PROGRAM, "render", "map.toml", "--size", "32x20", "--out", "x.png", "--id-list", "-"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--record"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--check"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--check", "--against", "reference", "--tolerance", "100"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--check", "--format", "json"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--check", "--format", "junit"},
    {ENFILADE_PROGRAM, "fly", "stand.toml", "--out", "-"},
    {ENFILADE_PROGRAM, "check", "map.toml"},
    {ENFILADE_PROGRAM, "check", "map.toml", "--effects"},
    {ENFILADE_PROGRAM, "check", "map.toml", "--format", "json"},
    {ENFILADE_PROGRAM, "check", "map.toml", "--format", "sarif"},
    {ENFILADE_PROGRAM, "bench", "map.toml", "--size", "8x8", "--rounds", "1"},
    {ENFILADE_PROGRAM, "bench", "map.toml", "--size", "8x8", "--rounds", "1", "--csv", "-"},
    {ENFILADE_PROGRAM, "bench", "map.toml", "--size", "8x8", "--rounds", "1", "--format", "json"},
    {ENFILADE_PROGRAM, "bench", "map.toml", "--size", "8x8", "--rounds", "1", "--against", ENFILADE_PROGRAM},
    {ENFILADE_PROGRAM, "bench", "map.toml", "--size", "8x8", "--rounds", "2", "--effects"},
    {ENFILADE_PROGRAM, "accuracy", "--quick", "map.toml"},
    {ENFILADE_PROGRAM, "accuracy", "--quick", "map.toml", "--score", "pictures"},
    {ENFILADE_PROGRAM, "new", "another"},
    {ENFILADE_PROGRAM, "expand", "map.toml"},
    {ENFILADE_PROGRAM, "fmt", "map.toml"},
    {ENFILADE_PROGRAM, "draw", "map.toml", "--out", "-"},
    {WADCONV_PROGRAM, "--help"},
    {WADCONV_PROGRAM, "--version"},
    {WADCONV_PROGRAM, "doom.wad", "--out", "levels"},
    {WADCONV_PROGRAM, "doom.wad", "--out", "levels", "--verbose"}};

/// The commands of enfilade as its help lists them.
Words commands() {
    const std::string help = Program().run({"--help"}).out;
    const std::string list = help.substr(help.find("Commands:"));
    static const std::regex kLine("\n  ([a-z]+) ");
    Words names;
    for (std::sregex_iterator it(list.begin(), list.end(), kLine), end; it != end; ++it) names.push_back((*it)[1]);
    return names;
}

/// A folder with something for every command, in which programs are run by a shell.
class Workplace {
public:
    Workplace() {
        program_.write("map.toml", test::kTwoRooms);
        program_.write("stand.toml", kStand);
        program_.run({"fly", "stand.toml", "--record"});
        wadconv::test::WadBuilder wad = wadconv::test::picture_wad();
        wad.add_map("MAP01", wadconv::test::small_level().map);
        program_.write("doom.wad", std::string(as_text(wad.finish("IWAD"))));
    }

    /// redirection: of the program's standard output, "> file"; limits: what the shell does before, "ulimit …;".
    Ended run(const Words& words, const std::string& redirection, const std::string& limits = "") const {
        std::string line = limits;
        for (const std::string& word : words) line += " \"" + word + "\"";
        return program_.run_other("/bin/sh", {"-c", line + " " + redirection});
    }

    const Program& program() const { return program_; }

private:
    Program program_;
};

void expect_one_sentence(const Ended& ended, const std::string& reason) {
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, EndsWith(": cannot write to standard output: " + reason + "\n"));
}

class StandardOutput : public ::testing::TestWithParam<Words> {};

TEST_P(StandardOutput, ThatIsFullIsAnError) {
    expect_one_sentence(Workplace().run(GetParam(), ">/dev/full"), "No space left on device");
}

INSTANTIATE_TEST_SUITE_P(Everywhere, StandardOutput, ::testing::ValuesIn(kInvocations));

TEST(StandardOutputs, OfAllCommandsAreTriedHere) {
    EXPECT_THAT(commands(), ::testing::SizeIs(::testing::Ge(10u)));
    for (const std::string& command : commands()) {
        if (command == "play") continue;  // it says what it has to say in its window
        const auto is_of_command = [&](const Words& words) { return words[1] == command; };
        EXPECT_TRUE(std::ranges::any_of(kInvocations, is_of_command)) << command << " is not in kInvocations";
    }
}

TEST(StandardOutputs, HelpOfAllCommandsTellsThatItIsFull) {
    const Workplace here;
    for (const std::string& command : commands())
        expect_one_sentence(here.run({ENFILADE_PROGRAM, command, "--help"}, ">/dev/full"), "No space left on device");
}

TEST(StandardOutputs, ThatTakeAPartAreAnError) {
    const Workplace here;
    for (const Words& words : {Words{ENFILADE_PROGRAM, "expand", "map.toml"}, Words{ENFILADE_PROGRAM, "--help"},
                               Words{ENFILADE_PROGRAM, "fly", "stand.toml", "--out", "-"}}) {
        expect_one_sentence(here.run(words, ">half", "ulimit -f 1;"), "File too large");
        EXPECT_THAT(here.program().text("half"), ::testing::SizeIs(::testing::AnyOf(512u, 1024u)));  // a shell's block
    }
}

TEST(StandardOutputs, ThatAreClosedAreAnErrorWhereSomethingIsSaid) {
    const Workplace here;
    expect_one_sentence(here.run({ENFILADE_PROGRAM, "check", "map.toml"}, ">&-"), "Bad file descriptor");
    EXPECT_EQ(here.run({ENFILADE_PROGRAM, "check", "map.toml", "--quiet"}, ">&-").exit_code, 0);
    EXPECT_EQ(here.run({ENFILADE_PROGRAM, "render", "map.toml", "--out", "x.png"}, ">&-").exit_code, 0);
}

TEST(StandardOutputs, ThatNobodyReadsAnyMoreEndTheProgramQuietly) {
    const Workplace here;
    const Ended ended = here.run({ENFILADE_PROGRAM, "check", "map.toml"}, "| true");
    EXPECT_EQ(ended.exit_code, 0);  // of `true`
    EXPECT_EQ(ended.err, "");
    const Ended piped = here.run({ENFILADE_PROGRAM, "expand", "map.toml"}, "| head -n 1");
    EXPECT_EQ(piped.out, "format = 1\n");
    EXPECT_EQ(piped.err, here.run({ENFILADE_PROGRAM, "expand", "map.toml"}, "").err);
}

}  // namespace
}  // namespace enfilade
