// What both programs share: arguments, standard output, how they end, and a line that says how far a long job is.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
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

/// The only way by which words reach standard output: writes printable(text) at once. An error where not all of it
/// could be written, as into a full disk; the command is then to end with it.
Result<void> print_to_stdout(std::string_view text);

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

// A line on the terminal that says how far a long job is.

/// How much a command says beside what it was asked for: usually also warnings, notes and how far it is.
enum class Talk { usual, errors_only };

/// Shows nothing where stderr is not a terminal, and nothing for jobs that are done in an instant.
class Progress {
public:
    /// total: how many steps, of which step() tells; noun: what is counted, e.g. "pictures".
    Progress(std::size_t total, std::string noun, Talk talk = Talk::usual);
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One step is done. May be called from any thread; only worker 0 draws.
    void step(std::size_t worker) { show(done_.fetch_add(1) + 1, total_, worker); }

    /// The same for a job that counts its own steps.
    void show(std::size_t done, std::size_t total, std::size_t worker);

private:
    void draw(std::size_t done, std::size_t total) const;

    std::atomic<std::size_t> done_{0};
    std::size_t total_;
    std::string noun_;
    std::int64_t started_ns_, last_drawn_ns_;
    bool on_terminal_;
};

}  // namespace enfilade
