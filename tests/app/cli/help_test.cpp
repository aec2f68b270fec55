// What --help lists is tested, has a manual page, and can be completed.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>

#include "app/cli/program.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kTop = ENFILADE_SOURCE_DIR "/";

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path.string());
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

/// All that matches the pattern's first group.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

std::vector<std::string> commands() {
    const std::string help = Program().run({"--help"}).out;
    return matches(help.substr(help.find("Commands:")), "\n  ([a-z]+) ");
}

std::vector<std::string> options_in(const std::string& help) { return matches(help, "\n  (?:-h,)?(--[a-z-]+)"); }

/// The texts of all tests, but for this one.
std::vector<std::string> tests() {
    std::vector<std::string> texts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kTop + "tests")) {
        const std::string ending = entry.path().extension().string();
        const bool is_test = ending == ".cpp" || ending == ".h" || ending == ".sh" || ending == ".txt";
        if (is_test && entry.path().filename() != "help_test.cpp") texts.push_back(text_of(entry.path()));
    }
    return texts;
}

/// The options that no test which mentions the command mentions.
std::vector<std::string> untested(const std::vector<std::string>& options, const std::string& command) {
    static const std::vector<std::string> all = tests();
    std::vector<std::string> without;
    for (const std::string& option : options) {
        const std::regex used("[\" ]" + option + "[\"= ]");
        if (std::ranges::none_of(all, [&](const std::string& text) {
                return text.find(command) != std::string::npos && std::regex_search(text, used);
            }))
            without.push_back(option);
    }
    return without;
}

TEST(Help, ListsNoOptionWithoutATest) {
    EXPECT_THAT(commands(), ::testing::SizeIs(::testing::Ge(5u)));
    for (const std::string& command : commands()) {
        const std::vector<std::string> options = options_in(Program().run({command, "--help"}).out);
        EXPECT_FALSE(options.empty()) << command;
        EXPECT_THAT(untested(options, "\"" + command + "\""), IsEmpty()) << command;
    }
    EXPECT_THAT(untested(options_in(Program().run_other(WADCONV_PROGRAM, {"--help"}).out), "wadconv/"), IsEmpty());
}

TEST(Help, SeesAnOptionWithoutATest) {
    EXPECT_THAT(untested({"--size", "--no-such-option"}, "\"render\""), ::testing::ElementsAre("--no-such-option"));
}

TEST(Help, SpeaksInWordsNotInThoseOfTheLibraryThatReadsOptions) {
    const testing::Matcher<std::string> kIsPlain = Not(testing::ContainsRegex(
        "REQUIRED|TEXT|INT|UINT|FLOAT|Excludes:|Needs:|SUBCOMMAND|Positionals|\\{false\\}| in \\["));
    for (const std::string& command : commands()) EXPECT_THAT(Program().run({command, "--help"}).out, kIsPlain);
    EXPECT_THAT(Program().run_other(WADCONV_PROGRAM, {"--help"}).out, kIsPlain);
    const std::string fly = Program().run({"fly", "--help"}).out;
    EXPECT_THAT(fly, testing::ContainsRegex("\n  --record  .*; not with --check, --merge\n"));
    EXPECT_THAT(Program().run({"render", "--help"}).out, testing::ContainsRegex("\n  --sector .*; only with --view\n"));
    EXPECT_THAT(Program().run({"draw", "--help"}).out, testing::ContainsRegex("\n  --out .*; needed\n"));
}

TEST(Help, HasAManualPageForEveryCommand) {
    const std::string pages = text_of(kTop + "engine/install/CMakeLists.txt");
    for (const std::string& command : commands()) EXPECT_THAT(pages, HasSubstr(" enfilade-" + command)) << command;
}

/// What bash offers for these words, the last of which is being typed.
std::string completions(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += "\"" + word + "\" ";
    const std::string script = "source " + kTop + "engine/install/enfilade.bash; COMP_WORDS=(" + line +
                               "); COMP_CWORD=" + std::to_string(words.size() - 1) + "; _enfilade \"" + words.front() +
                               "\" \"" + words.back() + "\"; echo \"${COMPREPLY[@]}\"";
    return Program().run_other("/bin/bash", {"-c", script}).out;
}

TEST(Completion, OffersCommandsAndOptions) {
    EXPECT_EQ(completions({ENFILADE_PROGRAM, "c"}), "check\n");
    EXPECT_EQ(completions({ENFILADE_PROGRAM, "fly", "--rec"}), "--record\n");
    EXPECT_EQ(completions({ENFILADE_PROGRAM, "--v"}), "--version\n");
    EXPECT_EQ(completions({WADCONV_PROGRAM, "--op"}), "--open-doors\n");
    EXPECT_EQ(completions({ENFILADE_PROGRAM, "fly", "wa"}), "\n");
}

TEST(Version, IsThatOfTheProject) {
    const std::string version = matches(text_of(kTop + "CMakeLists.txt"), "VERSION ([0-9.]+) LANGUAGES").at(0);
    EXPECT_EQ(Program().run({"--version"}).out, "enfilade " + version + "\n");
    EXPECT_EQ(Program().run_other(WADCONV_PROGRAM, {"--version"}).out, "wadconv " + version + "\n");
    EXPECT_THAT(text_of(kTop + "CHANGELOG.md"), HasSubstr("## " + version));
}

}  // namespace
}  // namespace enfilade
