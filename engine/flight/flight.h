// A flythrough that is ready to be drawn: frame n is a pure function of the map, the script and n, so frames can be
// drawn in any order, on any number of threads or machines.
#pragma once
#include <functional>
#include <optional>
#include <variant>

#include "base/files.h"
#include "base/finding.h"
#include "base/result.h"
#include "flight/camera_path.h"
#include "formats/script.h"
#include "map/map.h"
#include "render/choice/renderer.h"
#include "render/view.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

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

/// A path as the script that lies at `script_path` gives it, seen from the script's folder.
std::string beside_script(const std::string& script_path, const std::string& path);

/// Flight::plan() of a script that lies there, with the tape it names, if it names one. A tape that cannot be read, or
/// was recorded with another version of the map, is a finding.
std::optional<Flight> plan_flight(const std::string& script_path, const ScriptFile& script, const Map& map,
                                  const FileReader& read, Findings& findings);

// Drawing a flythrough: many frames on several threads.

/// A flythrough with all it shows. Only looks at what it is given.
struct FlightScene {
    const Flight& flight;
    const Map& map;
    const TextureSet& textures;
};

/// How and which frames are drawn.
struct DrawPlan {
    RendererKind renderer = RendererKind::column;
    Dials dials;
    int width = 640, height = 400;  ///< [px]
    int first = 0, last = 0;        ///< frames, both included
    std::size_t workers = 1;        ///< threads, >= 1
    GlContextOpener open_gl;        ///< for renderers that draw by OpenGL: each worker opens one
};

/// Takes a finished frame; an error ends the drawing. The frame is valid during the call.
using FrameTaker = std::function<Result<void>(int number, const Frame& frame, std::size_t worker)>;

/// Draws one frame. renderer: of the scene's map.
Result<void> draw_frame(const FlightScene& scene, int number, Renderer& renderer, Frame& frame);

/// Draws each frame once and hands it to `take`, in any order, from several threads, but never two at a time with the
/// same worker. The first error in order of workers is returned.
Result<void> draw_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

/// The same, but hands the frames over in order and on the calling thread, for films. Keeps a few frames per worker.
Result<void> draw_frames_in_order(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

}  // namespace enfilade
