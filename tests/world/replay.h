// Playing a tape again.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "world/input.h"
#include "world/world.h"

namespace enfilade {

/// What a tape did, tick by tick.
struct Replay {
    World end;
    std::vector<std::uint64_t> hashes;  ///< of the world after each tick
};

/// Plays the inputs from the map's start; none where the map has no start.
std::optional<Replay> play(const Map& map, std::span<const TickInput> inputs, const MotionDials& motion = {});

/// Plays a tape and compares the world it ends in with the one recorded. Errors: the map has no start, the tape's rate
/// is none that worlds have, or the end differs. That the map is the one recorded with is for the caller to check.
Result<Replay> replay(const Map& map, const Tape& tape);

/// The first tick after which two runs differ, or none; a run that ends earlier differs there.
std::optional<std::size_t> first_difference(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b);

}  // namespace enfilade
