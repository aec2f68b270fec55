#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "app/commands.h"
#include "app/exit_codes.h"

namespace enfilade {
namespace {

struct Declared {
    std::unique_ptr<Command> command;
    CLI::App* declaration = nullptr;
};

std::vector<Declared> declare_commands(CLI::App& enfilade) {
    std::vector<Declared> commands;
    for (const auto make : {make_play_command, make_render_command, make_fly_command, make_check_command}) {
        auto command = make();
        CLI::App* declaration = command->declare(enfilade);
        commands.push_back({std::move(command), declaration});
    }
    return commands;
}

/// The subcommand that was being read, or the whole program: whose help to point to.
std::string command_at_fault(const CLI::App& enfilade) {
    const auto chosen = enfilade.get_subcommands();
    return chosen.empty() ? "enfilade" : "enfilade " + chosen.front()->get_name();
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    CLI::App app("Rooms, portals and doorways that lead where they should not: a Doom-style engine.", "enfilade");
    app.set_version_flag("--version", "enfilade " ENFILADE_VERSION);
    app.require_subcommand(1);
    app.footer("`enfilade COMMAND --help` tells more about each. Exit status: 0 done, 1 failed, 2 wrong usage.");
    const auto commands = declare_commands(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked_for_text) {
        return app.exit(asked_for_text);
    } catch (const CLI::ParseError& error) {
        return refuse_usage({"", fmt::format("{}; see `{} --help`", error.what(), command_at_fault(app))});
    }
    for (const Declared& declared : commands)
        if (declared.declaration->parsed()) return declared.command->run();
    return kUsage;  // not reached: a subcommand is required
}

}  // namespace enfilade
