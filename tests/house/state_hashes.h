// Hashes of long runs of the engine's arithmetic: what has to be equal for every compiler, flag and machine.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace enfilade::house {

struct NamedHash {
    std::string name;
    std::uint64_t value;
    bool operator==(const NamedHash&) const = default;
};

/// One hash each for angles, exact decisions, grids and rigid maps, over fixed sequences of random input.
std::vector<NamedHash> state_hashes();

/// "name 0123456789ABCDEF".
std::string to_text(const NamedHash& hash);

}  // namespace enfilade::house
