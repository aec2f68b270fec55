// What can be seen of a wall from a point, through the portal one looks through: cones of sight, decided exactly.
#pragma once
#include <optional>

#include "base/short_list.h"
#include "map/map.h"

namespace enfilade {

/// The directions from a point between two points, left and right as seen from it: less than half a turn apart, left
/// included, right not. Under the tie rule the point never lies in line with the two.
struct Cone {
    Vec2 left, right;
};

/// A wall, or one side of a panel: an edge a -> b that is seen from its right.
struct Face {
    Vec2 a, b;  ///< on the vertex grid

    Face(Vec2 start, Vec2 end) : a(start), b(end) {}
    Face(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// The part of the cone in which the wall is seen from its own side, or none. `window` none: all directions.
/// p: where the eye is, on the point grid.
std::optional<Cone> cone_of(const Face& wall, Vec2 p, const std::optional<Cone>& window);

/// True where every direction of the cone is in `wide`, too. Both are parts of what is seen of one wall from p.
bool is_within(const Cone& cone, const Cone& wide, Vec2 p);

/// What is left of a cone without another one, from left to right. Exact, as the cones are.
ShortList<Cone, 2> without(const Cone& cone, const Cone& other, Vec2 p);

/// A stretch of a wall; neither end needs to be on a grid, unless it is an end of the wall.
struct Stretch {
    Vec2 a, b;
};

/// The stretch of the wall inside a cone that cone_of() gave for it. Ends that the cone does not cut are exact.
Stretch stretch_in(const Face& wall, Vec2 p, const Cone& cone);

/// True where the wall, inside a cone that lies within `window_wall`, is farther from p than that one: seen through
/// it, not before it; also where both lie on one line. The two do not cross.
bool is_beyond(const Face& wall, const Face& window_wall, Vec2 p, const Cone& cone);

}  // namespace enfilade
