// Legal worlds, as wild as the rules of maps allow: what no author draws and every renderer gets wrong.
//
// Islands of triangles whose corners are whole steps of the grid, merged into sectors of any shape: pinches, holes that
// touch outlines and each other, scattered parts, needles, fans, slits. Islands lie on each other, are 1 cm to 30 km
// wide, and at the edge of the world. Walls are linked by any turn, raised, one way, to themselves, or are mirrors.
#pragma once
#include "formats/map_file.h"
#include "wild/choices.h"

namespace enfilade::test {

/// The same bytes make the same world; it is sound for build_map(), and somebody can stand in it.
MapFile wild_world(Choices& choices);

/// The same of random bytes.
MapFile wild_world(std::uint64_t seed);

}  // namespace enfilade::test
