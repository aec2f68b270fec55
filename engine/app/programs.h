// Other programs that a command calls for help, this one, and what lies beside it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// How another program ended.
struct ChildEnd {
    int exit_code = 0;  ///< 128 + signal where it was killed; 127 where it is not there
    std::string said;   ///< to stdout and stderr, in the order of writing
};

/// Runs a program and waits for it. words : the program, by path or by a name that PATH leads to, and its arguments;
/// a shell reads none of them. An error where no process can be had, or where it says more than kMostSaid bytes.
Result<ChildEnd> run_child(const std::vector<std::string>& words);

/// The word as a shell takes it for one, whatever is in it.
std::string shell_word(const std::string& word);

/// More than the rows of the longest list of views.
inline constexpr std::size_t kMostSaid = std::size_t{256} << 20;

/// The program of that name that PATH leads to.
std::optional<std::string> find_program(std::string_view name);

/// The path of the running program.
std::string this_program();

// The maps that come with Enfilade.

/// The path of one of them, e.g. "effects.toml": in maps/ of the folder that the environment variable ENFILADE_SHARE
/// names, else of ../share/enfilade as seen from the program.
std::string shipped_map(const std::string& name);

}  // namespace enfilade
