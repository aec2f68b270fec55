// A random player in one map for a while, with all that a game does in between, watched after every tick.
#pragma once
#include <optional>
#include <string>

#include "wild/trial.h"

namespace enfilade::test {

struct SoakCounts {
    std::uint64_t rounds = 0, ticks = 0, pixels = 0, loads = 0, rewinds = 0, reloads = 0;
    SoakCounts& operator+=(const SoakCounts& other);
};

/// What came of a round. The same map and seed give the same.
struct SoakResult {
    SoakCounts counts;
    std::optional<Fault> fault;
    std::string sector;      ///< where the fault's pose is
    std::uint64_t hash = 0;  ///< of all states that were come through
};

/// Walks for some hundred ticks, in a folder of its own: saves, loads, goes back and loads the map again on the way,
/// and compares pictures of what moves. map_path : of a file that is not written to folder   : for saved games; is
/// there
SoakResult soak_round(const std::string& map_path, const std::string& folder, std::uint64_t seed);

}  // namespace enfilade::test
