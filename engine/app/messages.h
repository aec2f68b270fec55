// What every command says on the terminal: how it ends, how far it is, and what a picture does not show.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/result.h"
#include "render/frame.h"

namespace enfilade {

// How every command ends: the exit status, and the one sentence on stderr that explains it.

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;  ///< a map with errors, a file that cannot be read or written, frames that differ
inline constexpr int kUsage = 2;   ///< the command line itself makes no sense

/// Prints "enfilade: error" and gives kFailed.
int fail(const Error& error);

/// Prints "enfilade: error" and gives kUsage.
int refuse_usage(const Error& error);

/// How much a command says beside what it was asked for: usually also warnings, notes and how far it is.
enum class Talk { usual, errors_only };

// A line on the terminal that says how far a long job is.

/// Shows nothing where stderr is not a terminal, and nothing for jobs that are done in an instant.
class Progress {
public:
    /// total: how many steps; noun: what is counted, e.g. "pictures".
    Progress(std::size_t total, std::string noun, Talk talk = Talk::usual);
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One step is done. May be called from any thread; only worker 0 draws.
    void step(std::size_t worker);

private:
    void draw(std::size_t done);

    std::atomic<std::size_t> done_{0};
    std::size_t total_;
    std::string noun_;
    std::int64_t started_ns_, last_drawn_ns_;
    bool on_terminal_;
};

// Says on stderr that pictures do not show all there is to see.

/// What is said of a picture that is_cut_short (render/frame.h).
inline constexpr const char* kCutShort =
    "looks through doorways went too far and end in the recursion color; link fewer walls of large rooms, or give the "
    "map a smaller max_depth";

/// Counts the pictures that are cut short, and says in its last moment how many they were, if any.
class CutShortNote {
public:
    /// out: where the pictures go.
    explicit CutShortNote(std::string out, Talk talk = Talk::usual) : out_(std::move(out)), talk_(talk) {}
    ~CutShortNote();
    CutShortNote(const CutShortNote&) = delete;
    CutShortNote& operator=(const CutShortNote&) = delete;

    /// A picture is drawn. May be called from any thread.
    void look_at(const Frame& frame) { count_ += frame.is_cut_short; }

private:
    std::string out_;
    Talk talk_;
    std::atomic<std::size_t> count_{0};
};

}  // namespace enfilade
