// What both programs do with their arguments: read them, and say what is wrong with them.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace CLI {
class App;
}

namespace enfilade {

// How every command ends: the exit status, and the one sentence on stderr that explains it.

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;  ///< a map with errors, a file that cannot be read or written, frames that differ
inline constexpr int kUsage = 2;   ///< the command line itself makes no sense

/// Prints "PROGRAM: error" and gives kFailed.
int fail(const std::string& program, const Error& error);

/// What is wrong with a text that is to be a finite number from low to high; empty: nothing.
std::string range_fault(std::string_view text, double low, double high);

/// What is said of a first word that is none of the program's commands; of an empty one, where there is no command.
using AboutCommand = std::function<std::string(const std::string& word)>;

/// Reads the arguments into what the program declares. A status where that is the end: help or the version were asked
/// for and printed (kDone), or the arguments make no sense, and a sentence on stderr says why and whose help to read
/// (kUsage); an option that nobody knows is answered by the nearest there is.
/// about_command : for a program of several commands
std::optional<int> read_arguments(CLI::App& program, int argc, const char* const* argv,
                                  const AboutCommand& about_command = {});

}  // namespace enfilade
