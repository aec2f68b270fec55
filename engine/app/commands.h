// The subcommands of `enfilade`, one source file each.
#pragma once
#include <CLI/App.hpp>
#include <memory>

namespace enfilade {

/// A subcommand: what it may be given, and what it does with it.
class Command {
public:
    virtual ~Command() = default;

    /// Adds itself to the command line; the arguments are parsed into this object.
    virtual CLI::App* declare(CLI::App& enfilade) = 0;

    /// Does its work; the exit code (app/exit_codes.h).
    virtual int run() = 0;
};

std::unique_ptr<Command> make_play_command();
std::unique_ptr<Command> make_render_command();
std::unique_ptr<Command> make_fly_command();
std::unique_ptr<Command> make_check_command();

}  // namespace enfilade
