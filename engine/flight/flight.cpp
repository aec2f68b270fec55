#include "flight/flight.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "base/parallel.h"
#include "formats/tape.h"
#include "formats/text_parts.h"
#include "world/input.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

/// As many moments as a plan looks at [1]: all frames of half an hour. Of longer flights it looks at every k-th.
constexpr int kMostLooks = 54'000;

/// Frames from 0 to the last that is not after the end.
int frames_in(std::int64_t length_us, int rate) { return static_cast<int>(length_us * rate / 1'000'000) + 1; }

/// Frames that wait to be handed over, per worker: enough that nobody idles while they are.
constexpr std::size_t kWaitingPerWorker = 4;

}  // namespace

Flight::Flight(Path path, const ScriptFile& script, const Map& map)
    : path_(std::move(path)),
      at_rest_(at_rest(map)),
      rate_(script.rate),
      frames_(frames_in(std::visit([](const auto& kind) { return kind.length_us(); }, path_), script.rate)),
      fov_degrees_(script.fov_degrees) {}

std::optional<Flight> Flight::plan(const ScriptFile& script, const Map& map, Findings& findings) {
    auto path = CameraPath::plan(script, map, findings);
    if (!path) return {};
    Flight flight(*path, script, map);
    flight.press(*path, script, map);
    if (auto misplaced = flight.misplaced_eye(*path, script, map)) {
        findings.push_back(std::move(*misplaced));
        return {};
    }
    return flight;
}

std::optional<Flight> Flight::plan(const ScriptFile& script, const Map& map, Tape tape, Findings& findings) {
    auto path = TapePath::plan(map, std::move(tape));
    if (path.ok()) return Flight(std::move(path).value(), script, map);
    findings.push_back({script.tape_place, Severity::error, "tape-refused", path.error().text()});
    return {};
}

CameraPose Flight::pose_at(const Map& map, FrameTime time) const {
    return std::visit([&](const auto& path) { return path.pose_at(map, time); }, path_);
}

FlightFrame Flight::at(const Map& map, int frame) const {
    const FrameTime time{frame, rate_};
    return {view_of(map, pose_at(map, time)), snapshot_at(map, time)};
}

Snapshot Flight::snapshot_at(const Map& map, FrameTime time) const {
    Snapshot snapshot = at_rest_;
    const auto* tape = std::get_if<TapePath>(&path_);
    const History& history = tape ? tape->history() : pressed_;
    show({map, history, time.seconds() * ticks_per_second(history.rate())}, snapshot);
    snapshot.time_s = time.seconds();
    return snapshot;
}

void Flight::press(const CameraPath& path, const ScriptFile& script, const Map& map) {
    World world;
    world.history = begun(map);
    for (std::size_t i = 0; i < script.legs.size(); ++i) {
        if (script.legs[i].press != Press::use) continue;
        const std::int64_t begin_us = path.leg_begin_us(i);
        const CameraPose pose = path.pose_at(map, {begin_us, 1'000'000});
        world.tick = static_cast<std::uint64_t>(begin_us * kTickRate / 1'000'000);
        world.player.place = pose.place;
        world.player.yaw = pose.yaw;
        use_what_is_ahead(map, world);
    }
    pressed_ = std::move(world.history);
}

View Flight::view_of(const Map& map, const CameraPose& pose) const {
    View view;
    view.sector = pose.place.sector;
    view.eye = pose.place.point;
    view.eye_z = pose.eye_z;
    view.forward = direction(pose.yaw);
    view.pitch_tangent = tangent(Angle::from_degrees(pose.pitch_degrees));
    view.fov_degrees = fov_degrees_;
    view.stretch = map.render.stretch;
    view.ray_offset = ray_offset(map.render.rays);
    return view;
}

std::optional<Finding> Flight::misplaced_eye(const CameraPath& path, const ScriptFile& script, const Map& map) const {
    for (int frame = 0; frame < frames_; frame += 1 + frames_ / kMostLooks) {
        const FrameTime time{frame, rate_};
        const CameraPose pose = path.pose_at(map, time);
        const Heights here = heights_of({map, pressed_, time.seconds() * kTickRate}, pose.place.sector);
        if (pose.eye_z > here.floor_z && pose.eye_z < here.ceiling_z) continue;
        const auto leg = path.leg_at(time);
        const std::string where = leg ? "leg " + std::to_string(*leg + 1) : "the start";
        return Finding{leg ? script.legs[*leg].place : script.start.place, Severity::error, "eye-in-wall",
                       where + " takes the eye to height " + std::to_string(pose.eye_z) + " in " +
                           in_quotes(map[pose.place.sector].name) + ", which reaches from " +
                           std::to_string(here.floor_z) + " to " + std::to_string(here.ceiling_z) + " (frame " +
                           std::to_string(frame) + ")"};
    }
    return {};
}

Result<void> draw_frame(const FlightScene& scene, int number, Renderer& renderer, Frame& frame) {
    const FlightFrame shown = scene.flight.at(scene.map, number);
    return renderer.render(frame, nullptr, shown.snapshot, shown.view);
}

Result<void> draw_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take) {
    struct DrawTools {
        std::unique_ptr<Renderer> renderer;
        Frame frame;
        Result<void> done;
    };
    std::vector<DrawTools> tools(plan.workers);
    for (DrawTools& own : tools) {
        auto renderer = make_renderer({plan.renderer, plan.dials, 1, plan.open_gl}, scene.map, scene.textures);
        if (!renderer.ok()) return renderer.error();
        own.renderer = std::move(renderer).value();
        own.frame.resize(plan.width, plan.height);
    }
    std::atomic<bool> stop = false;
    const auto count = static_cast<std::size_t>(plan.last - plan.first + 1);
    parallel_for(count, plan.workers, [&](std::size_t i, std::size_t worker) {
        if (stop) return;
        DrawTools& own = tools[worker];
        const int number = plan.first + static_cast<int>(i);
        own.done = draw_frame(scene, number, *own.renderer, own.frame);
        if (own.done.ok()) own.done = take(number, own.frame, worker);
        if (!own.done.ok()) stop = true;
    });
    for (DrawTools& own : tools)
        if (!own.done.ok()) return own.done;
    return {};
}

Result<void> draw_frames_in_order(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take) {
    const int batch = static_cast<int>(plan.workers * kWaitingPerWorker);
    std::vector<Frame> waiting(static_cast<std::size_t>(batch));
    for (int first = plan.first; first <= plan.last; first += batch) {
        DrawPlan part = plan;
        part.first = first;
        part.last = std::min(plan.last, first + batch - 1);
        const auto keep = [&](int number, const Frame& frame, std::size_t) -> Result<void> {
            waiting[static_cast<std::size_t>(number - first)] = frame;
            return {};
        };
        if (const Result<void> done = draw_frames(scene, part, keep); !done.ok()) return done.error();
        for (int number = part.first; number <= part.last; ++number)
            if (const Result<void> done = take(number, waiting[static_cast<std::size_t>(number - first)], 0);
                !done.ok())
                return done.error();
    }
    return {};
}

namespace {

/// The tape that a script names, if it was recorded with the map as it is now.
Result<Tape> open_tape(const std::string& path, const std::string& map_path, const FileReader& read) {
    const auto bytes = read(path), map = read(map_path);
    if (!bytes.ok()) return bytes.error();
    auto tape = read_tape(bytes.value());
    if (!tape.ok()) return Error{path + ": " + tape.error().where, tape.error().what};
    if (map.ok() && hash_of_text(as_text(map.value())) != tape.value().map_hash)
        return Error{path, "the tape was recorded with another version of " + map_path + "; record it again"};
    return tape;
}

}  // namespace

std::string beside_script(const std::string& script_path, const std::string& path) {
    return (std::filesystem::path(script_path).parent_path() / path).lexically_normal().string();
}

std::optional<Flight> plan_flight(const std::string& script_path, const ScriptFile& script, const Map& map,
                                  const FileReader& read, Findings& findings) {
    if (script.tape.empty()) return Flight::plan(script, map, findings);
    auto tape = open_tape(beside_script(script_path, script.tape), beside_script(script_path, script.map), read);
    if (tape.ok()) return Flight::plan(script, map, std::move(tape).value(), findings);
    findings.push_back({script.tape_place, Severity::error, "tape-unreadable", tape.error().text()});
    return {};
}

}  // namespace enfilade
