#include "flight/tape_path.h"

#include <algorithm>
#include <string>

#include "world/camera.h"
#include "world/input.h"

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
    Timeline timeline(std::move(*world));
    for (const TickInput& input : tape.ticks) timeline.play(map, input);
    if (!tape.final_hash || hash(timeline.world()) == *tape.final_hash) return TapePath(std::move(timeline));
    return Error{"", "the walk ends elsewhere than when it was recorded; the map, or how things move, has changed"};
}

CameraPose TapePath::pose_at(const Map& map, FrameTime time) const {
    const std::int64_t scaled = time.frame * kTickRate;
    const auto before = static_cast<std::size_t>(scaled / time.rate);
    const double part = static_cast<double>(scaled % time.rate) / time.rate;
    const std::size_t ticks = timeline_.inputs().size();
    const World world = timeline_.after(map, std::min(before + 1, ticks));
    const Eye eye = eye_between_ticks(map, world, before < ticks ? part : 1);
    return {eye.place, eye.z, eye.yaw, eye.pitch_steps * (360 / 4294967296.0)};
}

std::int64_t TapePath::length_us() const {
    return static_cast<std::int64_t>(timeline_.inputs().size()) * 1'000'000 / kTickRate;
}

}  // namespace enfilade
