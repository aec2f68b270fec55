// A flythrough that is ready to be drawn: frame n is a pure function of the map, the script and n, so frames can be
// drawn in any order, on any number of threads or machines.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "base/files.h"
#include "base/finding.h"
#include "base/result.h"
#include "formats/script.h"
#include "formats/tape.h"
#include "map/map.h"
#include "render/choice/renderer.h"
#include "render/view.h"
#include "space/trace.h"
#include "world/snapshot.h"
#include "world/step.h"
#include "world/world.h"

namespace enfilade {

// Where the camera of a scripted flythrough is at any moment, as a function of time alone.

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
    double pitch_degrees = 0;  ///< up positive
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
    /// Plays the tape. Errors: the map has no start, no world has the tape's rate, it is longer than
    /// kMaxTapeSeconds, or it ends in another world than when it was recorded.
    static Result<TapePath> plan(const Map& map, Tape tape);

    /// Between two ticks as the player saw it; after the end the camera stays. Cost: at most kBetweenKept ticks.
    CameraPose pose_at(const Map& map, FrameTime time) const;

    std::int64_t length_us() const;

    /// All that happens in the whole of it; of any moment it says what had happened by then.
    const History& history() const { return timeline_.world().history; }

private:
    explicit TapePath(Timeline played) : timeline_(std::move(played)) {}
    std::int64_t rate() const { return ticks_per_second(history().rate()); }

    Timeline timeline_;
};

/// Longest tape that is flown [s]: a day.
inline constexpr std::size_t kMaxTapeSeconds = 86'400;

// Frames: what the camera sees, and the state of the map.

/// Everything that one picture shows, apart from the map.
struct FlightFrame {
    View view;
    Snapshot snapshot;
};

class Flight {
public:
    /// Lays a script's legs into its map and looks at every frame's eye. None where a finding is an error: what
    /// CameraPath refuses, or an eye below a floor or above a ceiling.
    static std::optional<Flight> plan(const ScriptFile& script, const Map& map, Findings& findings);

    /// The same for a script with a tape, which has been read; what TapePath refuses is a finding at the tape's name.
    static std::optional<Flight> plan(const ScriptFile& script, const Map& map, Tape tape, Findings& findings);

    /// Leaves something out of every frame.
    void leave_out(const LeftOut& what) { enfilade::leave_out(what, at_rest_); }

    /// From frame 0 at the start to the last at the very end, both included: >= 1.
    int frames() const { return frames_; }

    /// What frame n shows, 0 <= n < frames(). Cost: the walls on the way of one leg, and a copy of a
    /// snapshot.
    FlightFrame at(const Map& map, int frame) const;

private:
    using Path = std::variant<CameraPath, TapePath>;

    Flight(Path path, const ScriptFile& script, const Map& map);

    CameraPose pose_at(const Map& map, FrameTime time) const;
    Snapshot snapshot_at(const Map& map, FrameTime time) const;
    View view_of(const Map& map, const CameraPose& pose) const;
    /// What the legs of a script press, from its beginning to its end.
    void press(const CameraPath& path, const ScriptFile& script, const Map& map);
    /// The first frame whose eye is not between floor and ceiling, as a finding.
    std::optional<Finding> misplaced_eye(const CameraPath& path, const ScriptFile& script, const Map& map) const;

    Path path_;
    Snapshot at_rest_;
    History pressed_;  ///< what a script's legs set off; a tape has its own
    int rate_ = 30;    ///< [1/s]
    int frames_ = 1;
    double fov_degrees_ = 90;
};

// A flythrough from files.

/// A path as the script that lies at `script_path` gives it, seen from the script's folder; one that begins with '/'
/// leads where it says.
std::string beside_script(const std::string& script_path, const std::string& path);

/// Flight::plan() of a script that lies there, with the tape it names, if it names one. A tape that cannot be read, or
/// was recorded with another version of the map, is a finding.
std::optional<Flight> plan_flight(const std::string& script_path, const ScriptFile& script, const Map& map,
                                  const FileReader& read, Findings& findings);

// Drawing a flythrough: many frames on several threads.

/// A flythrough with all it shows. Only looks at what it is given, which outlives it.
struct FlightScene {
    const Flight& flight;
    const Map& map;
    const TextureSet& textures;
};

/// How and which frames are drawn.
struct DrawPlan {
    RendererKind renderer = RendererKind::column;
    Dials dials;
    int width = 640, height = 400;  ///< 1..kMaxPictureSide [px]
    int first = 0, last = 0;        ///< frames, both included
    std::size_t workers = 1;        ///< threads, >= 1
    GlContextOpener open_gl;        ///< for renderers that draw by OpenGL: each worker opens one
};

/// Takes a finished frame; an error ends the drawing. The frame is valid during the call.
using FrameTaker = std::function<Result<void>(int number, const Frame& frame, std::size_t worker)>;

/// Draws one frame. renderer: of the scene's map. frame: has the picture's size. An error is the renderer's.
Result<void> draw_frame(const FlightScene& scene, int number, Renderer& renderer, Frame& frame);

/// Draws each frame once and hands it to `take`, in any order, from several threads, but never two at a time with the
/// same worker. The first error in order of workers is returned.
Result<void> draw_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

/// The same, but hands the frames over in order and on the calling thread, for films. Keeps a few frames per worker.
Result<void> draw_frames_in_order(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

}  // namespace enfilade
