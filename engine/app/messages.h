// What every command of enfilade says on the terminal: why it ends, and what a picture does not show.
#pragma once
#include <atomic>
#include <cstddef>
#include <string>

#include "base/result.h"
#include "command/command.h"
#include "render/frame.h"

namespace enfilade {

/// Prints "enfilade: error" and gives kFailed.
int fail(const Error& error);

/// Prints "enfilade: error" and gives kUsage.
int refuse_usage(const Error& error);

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
