#include "world/replay.h"

#include <algorithm>

#include "world/step.h"

namespace enfilade {

std::optional<Replay> play(const Map& map, std::span<const TickInput> inputs, const MotionDials& motion) {
    const std::optional<World> start = start_of(map, motion);
    if (!start) return {};
    Replay run{*start, {}};
    for (const TickInput& input : inputs) {
        step(map, run.end, input);
        run.hashes.push_back(hash(run.end));
    }
    return run;
}

Result<Replay> replay(const Map& map, const Tape& tape) {
    const auto motion = motion_of(tape);
    if (!motion) return Error{"tape", "expected 60, 35 or 140 ticks a second, found " + std::to_string(tape.rate)};
    std::optional<Replay> run = play(map, tape.ticks, *motion);
    if (!run) return Error{tape.map, "expected a map with a [player] to start from, found none"};
    if (tape.final_hash && hash(run->end) != *tape.final_hash)
        return Error{"tape", "expected the world to end as it was recorded, found that it ends differently after " +
                                 std::to_string(tape.ticks.size()) +
                                 " ticks; was it recorded with another map or version?"};
    return std::move(*run);
}

std::optional<std::size_t> first_difference(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
    const std::size_t shared = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < shared; ++i)
        if (a[i] != b[i]) return i;
    if (a.size() != b.size()) return shared;
    return {};
}

}  // namespace enfilade
