// A faulty world made smaller for as long as it stays faulty.
#pragma once
#include <functional>

#include "formats/map_file.h"

namespace enfilade::test {

/// Says whether a world still has the fault; false for one that is not legal.
using IsFaulty = std::function<bool(const MapFile&)>;

/// Takes out what can go, one by one and again and again: what stands around, rooms, corners, loops, what walls
/// and rooms are beyond being there. Asks at most `most_questions` times. The file is faulty, and so is what is
/// returned.
MapFile shrunk(MapFile file, const IsFaulty& is_faulty, int most_questions = 3000);

}  // namespace enfilade::test
