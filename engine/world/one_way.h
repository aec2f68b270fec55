// Coming out of a one-way portal. The wall one comes out of leads nowhere, or elsewhere, and half of the body is still
// in it when the middle has passed: it must not hold who comes out, and must hold everybody else.
//
// The rule, decided exactly and by places alone, so that nothing has to be remembered from tick to tick: a wall that is
// an exit (Wall::one_way_exit) does not touch a body whose middle is behind the wall's line, whatever of the disc is
// on this side. A body in front of it that is nearer than its radius may go along it and away from it, but not nearer.
// So one can stand in an exit, leave it at any angle, and back off as far as one has come, but its middle never gets
// behind the line again. The corners beside the exit hold the body as those of any doorway do. Where the exit is itself
// a portal that the body can pass, half of the disc comes out of that, and has to fit there.
#pragma once
#include <optional>

#include "space/reach.h"

namespace enfilade {

/// Whether the wall is the exit of a one-way portal; panels are none.
inline bool is_one_way_exit(const Map& map, const ReachedWall& wall) {
    return wall.wall && map[wall.wall].one_way_exit;
}

/// How near to a wall the middle of a body that goes from `from` may come [m], on the point grid: its radius, or for
/// the exit of a one-way portal the distance it already has, if that is less. None where the wall does not hold it at
/// all: it is such an exit, and `from` is behind it.
///
/// from   : where the middle was, on the point grid, in the space of the wall
/// radius : of the body [m], on the point grid
std::optional<double> distance_kept(const Map& map, const ReachedWall& wall, Vec2 from, double radius);

/// Takes out the walls that do not hold a body that came straight from `from` to the place of `around`.
///
/// way : from the space of `from` into that of the place
void drop_exits_left(const Map& map, Vec2 from, const Rigid& way, double radius, Reach& around);

}  // namespace enfilade
