// The options of the commands for authors of maps: new, expand, fmt and draw.
#pragma once
#include "app/commands.h"

namespace CLI {
class App;
}

namespace enfilade {

/// Declares the commands, and runs the one that was read.
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
