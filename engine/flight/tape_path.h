// Where the camera of a recorded walk is at any moment: the player's eye, played again.
#pragma once
#include "base/result.h"
#include "flight/camera_path.h"
#include "formats/tape.h"
#include "world/timeline.h"

namespace enfilade {

/// A tape that was played through once, so that any moment is found by playing only a few ticks again. Immutable.
class TapePath {
public:
    /// Plays the tape. Errors: the map has no start, the tape's rate is not kTickRate, it is longer than
    /// kMaxTapeSeconds, or it ends in another world than when it was recorded.
    static Result<TapePath> plan(const Map& map, Tape tape);

    /// Between two ticks as the player saw it; after the end the camera stays. Cost: at most kBetweenKept ticks.
    CameraPose pose_at(const Map& map, FrameTime time) const;

    std::int64_t length_us() const;

    /// All that happens in the whole of it; of any moment it says what had happened by then.
    const History& history() const { return timeline_.world().history; }

private:
    explicit TapePath(Timeline played) : timeline_(std::move(played)) {}

    Timeline timeline_;
};

/// Longest tape that is flown [s]: a day.
inline constexpr std::size_t kMaxTapeSeconds = 86'400;

}  // namespace enfilade
