// Where the camera of a scripted flythrough is at any moment, as a function of time alone.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/finding.h"
#include "base/result.h"
#include "formats/script.h"
#include "formats/tape.h"
#include "map/map.h"
#include "render/view.h"
#include "space/trace.h"
#include "world/step.h"

namespace enfilade {

/// A moment of a flythrough, exactly: frame n of `rate` frames a second. Legs begin and end at whole microseconds, so
/// whether a frame is in a leg is decided in whole numbers.
struct FrameTime {
    std::int64_t frame = 0;  ///< >= 0
    int rate = 1;            ///< [1/s]
    double seconds() const { return static_cast<double>(frame) / rate; }
};

/// Where the camera is and how it looks, in the space of the sector it is in.
struct CameraPose {
    Place place;
    double eye_z = 0;  ///< [m]
    Angle yaw;
    double pitch_degrees = 0;
};

/// One leg, resolved: everything is given at its start, in the space where it starts.
struct CameraLeg {
    std::int64_t begin_us = 0, end_us = 0;  ///< since the start of the flight; equal for a cut
    CameraPose from;
    Vec2 to;                      ///< on the point grid
    double to_z = 0;              ///< [m]
    std::int64_t turn_steps = 0;  ///< yaw added over the leg, right positive [2^-32 turn]
    double to_pitch_degrees = 0;
    Ease ease = Ease::smooth;
};

/// The legs of a script laid into a map. Immutable; any moment is computed without those before it.
class CameraPath {
public:
    /// Resolves a script's start and legs. None where a finding is an error: a start outside the map, a leg that runs
    /// into a wall, a cut to nowhere, a look at one's own place. Stops at the first leg that fails.
    static std::optional<CameraPath> plan(const ScriptFile& script, const Map& map, Findings& findings);

    /// The moment a leg begins or the flight ends belongs to what comes after it; after the end the camera stays.
    CameraPose pose_at(const Map& map, FrameTime time) const;

    /// Number of the leg, from 0, that began last before or at a moment; none without legs.
    std::optional<std::size_t> leg_at(FrameTime time) const;

    /// When a leg begins, since the start of the flight. leg: less than the script's number of legs.
    std::int64_t leg_begin_us(std::size_t leg) const { return legs_[leg].begin_us; }

    std::int64_t length_us() const { return legs_.empty() ? 0 : legs_.back().end_us; }

private:
    std::vector<CameraLeg> legs_;
    CameraPose end_;  ///< without legs: the start
};

// Where the camera of a recorded walk is at any moment: the player's eye, played again.

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
