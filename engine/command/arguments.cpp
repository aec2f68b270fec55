#include "command/arguments.h"

#include <CLI/CLI.hpp>
#include <sstream>
#include <vector>

#include "base/terminal.h"
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

/// As it is typed: "enfilade render".
std::string name_of(const CLI::App& command) {
    const CLI::App* const program = command.get_parent();
    return (program ? program->get_name() + " " : "") + command.get_name();
}

}  // namespace

int fail(const std::string& program, const Error& error) {
    print_text(stderr, program + ": " + error.text() + "\n");
    return kFailed;
}

std::optional<int> read_arguments(CLI::App& program, int argc, const char* const* argv,
                                  const AboutCommand& about_command) {
    try {
        program.parse(argc, argv);
        return {};
    } catch (const CLI::Success& asked_for_text) {
        std::ostringstream text;
        program.exit(asked_for_text, text);
        print_text(stdout, text.str());
        return kDone;
    } catch (const CLI::ParseError& error) {
        const std::string fault = fault_text(program, error, about_command);
        fail(program.get_name(), {"", fault + "; see `" + name_of(command_of(program)) + " --help`"});
        return kUsage;
    }
}

}  // namespace enfilade
