// The options of `enfilade accuracy`.
#pragma once
#include <memory>

#include "app/commands.h"

namespace CLI {
class App;
}

namespace enfilade {

/// Declares the command, and runs it.
class AccuracyCommand {
public:
    explicit AccuracyCommand(CLI::App& enfilade);

    bool is_asked_for() const;
    /// Its exit code. Once it is asked for.
    int run() const;

private:
    std::unique_ptr<AccuracyRequest> request_ = std::make_unique<AccuracyRequest>();  ///< stays where CLI11 knows it
    const CLI::App* declared_ = nullptr;
};

}  // namespace enfilade
