#include "command/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <set>
#include <span>
#include <sstream>
#include <vector>

#include "base/files.h"
#include "base/text.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// The command that is being read, or the whole program.
const CLI::App& command_of(const CLI::App& program) {
    const auto chosen = program.get_subcommands();
    return chosen.empty() ? program : *chosen.front();
}

/// The names of all options of a command, as they are typed: "--size".
std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string unknown_option(const std::string& word, const CLI::App& command) {
    const std::vector<std::string> options = options_of(command);
    const std::vector<std::string_view> known(options.begin(), options.end());
    const std::string name = word.substr(0, word.find('='));
    return "there is no option " + in_quotes(name) + " here" + nearest_suggestion(name, known);
}

/// What is wrong, in words that help: CLI11 does not say which name was nearly right.
std::string fault_text(const CLI::App& program, const CLI::ParseError& error, const AboutCommand& about_command) {
    const bool lacks_command = about_command && program.get_subcommands().empty();
    for (const std::string& word : program.remaining(true)) {
        if (word.starts_with('-') && word != "--") return unknown_option(word, command_of(program));
        if (lacks_command) return about_command(word);
    }
    return lacks_command ? about_command("") : error.what();
}

/// Help in whole sentences, where CLI11 would put its own marks between an option and what it takes.
class SentenceFormatter : public CLI::Formatter {
public:
    SentenceFormatter() {
        label("Positionals", "Arguments");
        label("SUBCOMMAND", "COMMAND");
    }

private:
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
        std::string name = CLI::Formatter::make_option_name(option, is_positional);
        constexpr std::string_view kTurnedOff = "{false}";
        if (const auto at = name.find(kTurnedOff); at != name.npos) name.erase(at, kTurnedOff.size());
        return name;
    }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string what = option->get_positional() ? "" : option->get_type_name();
        if (!what.empty()) what.insert(0, " ");
        return what + (option->get_expected_max() > 1 ? " ..." : "");
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        std::vector<std::string> sentences;
        if (option->get_required() && !option->get_positional()) sentences.push_back("needed");
        if (!option->get_needs().empty()) sentences.push_back("only with " + names_of(option->get_needs()));
        if (!option->get_excludes().empty()) sentences.push_back("not with " + names_of(option->get_excludes()));
        std::string text = option->get_description();
        for (const std::string& sentence : sentences) text += "; " + sentence;
        return text;
    }

    /// "--record, --merge", in the order of the alphabet.
    static std::string names_of(const std::set<CLI::Option*>& options) {
        std::set<std::string> names;
        for (const CLI::Option* option : options) names.insert(option->get_name());
        std::string text;
        for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
        return text;
    }
};

void explain_in_sentences(CLI::App& program) {
    const auto formatter = std::make_shared<SentenceFormatter>();
    program.formatter(formatter);
    for (CLI::App* command : program.get_subcommands({})) command->formatter(formatter)->group("Commands");
}

/// As it is typed: "enfilade render".
std::string name_of(const CLI::App& command) {
    const CLI::App* const program = command.get_parent();
    return (program ? program->get_name() + " " : "") + command.get_name();
}

}  // namespace

std::string range_fault(std::string_view text, double low, double high) {
    const auto number = parse_number(text);
    if (number && *number >= low && *number <= high) return {};
    return fmt::format("expected a number from {} to {}; found {}", low, high, in_quotes(text));
}

int fail(const std::string& program, const Error& error) {
    print_to_stderr(program + ": " + error.text() + "\n");
    return kFailed;
}

Result<void> print_to_stdout(std::string_view text) {
    if (text.empty()) return {};
    Result<OutputFile> out = OutputFile::open(kStandardOutput);
    if (!out) return out.error();
    const std::string shown = printable(text);
    if (const Result<void> done = out.value().write(std::as_bytes(std::span(shown))); !done.ok()) return done.error();
    return out.value().commit(OutputFile::Flush::nothing);
}

std::optional<int> read_arguments(CLI::App& program, int argc, const char* const* argv,
                                  const AboutCommand& about_command) {
    explain_in_sentences(program);
    try {
        program.parse(argc, argv);
        return {};
    } catch (const CLI::Success& asked_for_text) {
        std::ostringstream text;
        program.exit(asked_for_text, text);
        const Result<void> done = print_to_stdout(text.str());
        return done.ok() ? kDone : fail(program.get_name(), done.error());
    } catch (const CLI::ParseError& error) {
        const std::string fault = fault_text(program, error, about_command);
        fail(program.get_name(), {"", fault + "; see `" + name_of(command_of(program)) + " --help`"});
        return kUsage;
    }
}

// How far a long job is.

namespace {

/// Between two drawings of the line [ns]: as often as an eye follows.
constexpr std::int64_t kPause = 100'000'000;

constexpr std::size_t kBarWidth = 30;  ///< [characters]

std::int64_t steady_ns() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::size_t total, std::string noun, Talk talk)
    : total_(total),
      noun_(std::move(noun)),
      started_ns_(steady_ns()),
      last_drawn_ns_(started_ns_ + kPause),
      on_terminal_(talk == Talk::usual && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (on_terminal_) redraw_line("");
}

void Progress::show(std::size_t done, std::size_t total, std::size_t worker) {
    if (!on_terminal_ || worker != 0 || steady_ns() - last_drawn_ns_ < kPause) return;
    last_drawn_ns_ = steady_ns();
    draw(done, total);
}

void Progress::draw(std::size_t done, std::size_t total) const {
    const std::size_t filled = kBarWidth * done / total;
    const double passed_s = double(steady_ns() - started_ns_) * 1e-9;
    redraw_line(fmt::format("[{:#<{}}{:.<{}}] {} of {} {}, {:.0f} s left", "", filled, "", kBarWidth - filled, done,
                            total, noun_, passed_s / double(done) * double(total - done)));
}

}  // namespace enfilade
