// How far one look goes through doorways. What it may cost depends only on the rooms on its way, so that all renderers
// end it at the same doorway, whatever the size of the picture and however its work is divided among threads.
#pragma once
#include <cstdint>

#include "map/map.h"

namespace enfilade {

/// What looking into a room costs beside its walls, each of which is looked at [walls].
inline constexpr std::uint32_t kRoomCost = 32;

/// A look that has cost this much goes through no further doorway; there the map's recursion colour is drawn [walls].
/// Enough for 1024 links, the most that max_depth allows, through rooms of 32 walls, and to look out of a room of
/// 65 000 walls. Each column of a picture costs at most this and one more room, about 2 ms: without it a room whose
/// 8000 walls all lead back into it took 10 s for 640 columns.
inline constexpr std::uint32_t kLookBudget = 1u << 16;

inline std::uint32_t cost_of_look_into(const Sector& sector) { return sector.wall_count + kRoomCost; }

}  // namespace enfilade
