// Says on stderr that pictures do not show all there is to see.
#pragma once
#include <atomic>
#include <string>

#include "render/frame.h"

namespace enfilade {

/// What is said of a picture that is_cut_short (render/frame.h).
inline constexpr const char* kCutShort =
    "looks through doorways went too far and end in the recursion color; link fewer walls of large rooms, or give the "
    "map a smaller max_depth";

/// Counts the pictures that are cut short, and says in its last moment how many they were, if any.
class CutShortNote {
public:
    /// out: where the pictures go.
    explicit CutShortNote(std::string out) : out_(std::move(out)) {}
    ~CutShortNote();
    CutShortNote(const CutShortNote&) = delete;
    CutShortNote& operator=(const CutShortNote&) = delete;

    /// A picture is drawn. May be called from any thread.
    void look_at(const Frame& frame) { count_ += frame.is_cut_short; }

private:
    std::string out_;
    std::atomic<std::size_t> count_{0};
};

}  // namespace enfilade
