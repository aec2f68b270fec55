#include "flight/tape_path.h"

#include <algorithm>
#include <string>

#include "world/camera.h"
#include "world/input.h"
#include "world/step.h"

namespace enfilade {
namespace {

Status refuse(const Tape& tape) {
    if (tape.rate != kTickRate)
        return Error{"", "expected a tape of " + std::to_string(kTickRate) + " ticks a second; found " +
                             std::to_string(tape.rate)};
    if (tape.ticks.size() > kMaxTapeSeconds * kTickRate) return Error{"", "the tape is longer than a day"};
    return {};
}

}  // namespace

Result<TapePath> TapePath::plan(const Map& map, Tape tape) {
    if (Status refused = refuse(tape)) return *refused;
    auto world = start_of(map);
    if (!world) return Error{"", "the map has no player to walk"};
    TapePath path(std::move(tape));
    for (std::size_t tick = 0; tick < path.tape_.ticks.size(); ++tick) {
        if (tick % kBetweenKept == 0) path.kept_.push_back(*world);
        step(map, *world, path.tape_.ticks[tick]);
    }
    if (path.tape_.ticks.size() % kBetweenKept == 0) path.kept_.push_back(*world);
    path.history_ = world->history;
    if (hash(*world) == path.tape_.final_hash) return path;
    return Error{"", "the walk ends elsewhere than when it was recorded; the map, or how things move, has changed"};
}

World TapePath::after(const Map& map, std::size_t ticks) const {
    World world = kept_[ticks / kBetweenKept];
    for (std::size_t tick = ticks - ticks % kBetweenKept; tick < ticks; ++tick) step(map, world, tape_.ticks[tick]);
    return world;
}

CameraPose TapePath::pose_at(const Map& map, FrameTime time) const {
    const std::int64_t scaled = time.frame * kTickRate;
    const auto before = static_cast<std::size_t>(scaled / time.rate);
    const double part = static_cast<double>(scaled % time.rate) / time.rate;
    const World world = after(map, std::min(before + 1, tape_.ticks.size()));
    const Eye eye = eye_between_ticks(map, world, before < tape_.ticks.size() ? part : 1);
    return {eye.place, eye.z, eye.yaw, eye.pitch_steps * (360 / 4294967296.0)};
}

std::int64_t TapePath::length_us() const {
    return static_cast<std::int64_t>(tape_.ticks.size()) * 1'000'000 / kTickRate;
}

}  // namespace enfilade
