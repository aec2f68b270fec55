// The options of the tools: `accuracy` for who tunes renderers; new, expand, fmt and draw for authors of maps.
#pragma once
#include "app/commands.h"

namespace CLI {
class App;
}

namespace enfilade {

/// Declares `accuracy`, and runs it. Stays where it is: CLI11 writes into it.
class AccuracyCommand {
public:
    explicit AccuracyCommand(CLI::App& enfilade);

    bool is_asked_for() const;
    /// Its exit code. Once it is asked for.
    int run() const;

private:
    AccuracyRequest request_;
    const CLI::App* declared_ = nullptr;
};

/// Declares the commands for authors, and runs the one that was read. Stays where it is, too.
class AuthorCommands {
public:
    explicit AuthorCommands(CLI::App& enfilade);

    /// One of them was asked for. Returns its exit code.
    int run() const;

private:
    NewRequest new_;
    ExpandRequest expand_;
    FmtRequest fmt_;
    DrawRequest draw_;
    const CLI::App *declared_new_, *declared_expand_, *declared_fmt_;
};

}  // namespace enfilade
