// What moves under, over and against the player in one tick.
#pragma once
#include "world/world.h"

namespace enfilade {

/// Lets floors and ceilings around the player go from this tick to the next: what would leave too little room turns
/// round, waits, or crushes, by its own rules; who stands on a floor goes with it. Afterwards the player has room at
/// tick + 1, and its feet and height are those of then.
/// Cost: the sectors that the body overlaps, however many move elsewhere; none in a map where nothing ever changed or
/// bobs.
void move_flats(const Map& map, World& world);

}  // namespace enfilade
