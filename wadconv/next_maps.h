// Which level comes after which.
#pragma once
#include <string>
#include <string_view>

namespace enfilade::wadconv {

/// The level that a level's exit leads to, in Doom's order; empty behind the last of an episode or of the game.
/// `map`: "E1M1" or "MAP01" (is_map_name in wadconv/map_lumps.h).
std::string next_map(std::string_view map, bool by_secret_exit);

}  // namespace enfilade::wadconv
