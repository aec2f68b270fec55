// A map cut along portals, its pieces moved away and joined again by links: nobody inside may notice.
#pragma once
#include <vector>

#include "base/hash.h"
#include "map/map.h"
#include "render/view.h"

namespace enfilade::test {

/// How the pieces are moved away from each other.
enum class Move { shift, quarter_turns, other_angles };

/// The map in pieces, and where each sector went.
struct CutMap {
    Map map;
    std::vector<Rigid> moves;  ///< by sector: from where it was to where it is
};

/// Gives each sector at random to one of a few pieces, moves each piece somewhere else and makes links of the portals
/// between them. Sectors, walls, panels and things keep their numbers, walls and panels their light; pictures on floors
/// and ceilings move along, but do not turn.
///
/// other_angles: a turn by the triangle 3, 4, 5; vertices are multiples of five grid steps (on_turnable_grid())
CutMap cut_apart(const Map& map, Move move, Random& random);

/// The map with all vertices rounded to multiples of five grid steps, which a turn by the triangle 3, 4, 5 carries onto
/// the grid; without things, whose places it would not carry.
Map on_turnable_grid(const Map& map);

/// The same look in the cut map.
View moved(const View& view, const CutMap& cut);

}  // namespace enfilade::test
