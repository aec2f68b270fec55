// One segment of a path: the stretch of it that runs through one sector, and how it leaves that sector.
//
// Why the first wall left through, beyond the one entered by, is the right one. The tie rule moves the whole path by
// (e, e^2): moved like that it passes no vertex, runs along no wall and starts and ends on none. What is left is
// a segment in general position and a region, the sector, whose border it crosses one wall at a time, by turns out of
// the region and into it. Starting inside, or having just come in, the next border crossing is one out of it: of the
// walls crossed outward, the one with the smallest fraction beyond the entrance. That holds for sectors that are not
// convex, for holes, for several outlines and where two loops touch in a vertex: the moved path never sees the vertex.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "map/map.h"
#include "math/predicates.h"

namespace enfilade {

// Points next to a wall: which grid points lie just on one side of it.

/// Steps tried when a point has to get to one side of a wall it lies on, up to rounding [grid steps]: a point that was
/// rounded once or twice is less than two steps off, and a step along an axis is at worst 45 degrees off the
/// shortest way.
inline constexpr std::array<double, 4> kStepsBeside{1, 2, 3, 4};

/// One grid step along the axis that leads most directly from the wall into its sector.
Vec2 step_inward(const Wall& wall);

/// p, or where p is not there the first grid point straight beside it, on the side of the wall's line where its sector
/// is (side = 1) or on the other (side = -1). None where p is more than a few grid steps off.
std::optional<Vec2> put_on_side(const Wall& wall, Vec2 p, int side);

/// A few grid steps straight through a wall, into its sector.
struct Hop {
    WallId through;
    Vec2 from;  ///< before the wall
};

/// The path from -> to, of which the part in `sector` is meant. `from` and `to` are on the point grid and in the
/// space of the sector; `from` may lie outside it (then the path comes in through `entry`), and so may `to`.
struct PathSegment {
    SectorId sector;
    Vec2 from, to;
    WallId entry;              ///< wall of `sector` through which the path comes in; none: `from` is inside
    std::optional<Hop> hop{};  ///< by which the path got to `from`, where it did not come in straight
};

/// Where the segment's line meets that of a - b, exactly.
inline PathFraction fraction_at(const PathSegment& segment, Vec2 a, Vec2 b) {
    return fraction_along_path(segment.from, segment.to, a, b);
}

/// Quick and exact: a path that the tie rule moves by (e, e^2) crosses no edge a - b whose box its own does not touch.
inline bool boxes_touch(const PathSegment& segment, Vec2 a, Vec2 b) {
    const Vec2 p = segment.from, q = segment.to;
    return std::max(a.x, b.x) >= std::min(p.x, q.x) && std::min(a.x, b.x) <= std::max(p.x, q.x) &&
           std::max(a.y, b.y) >= std::min(p.y, q.y) && std::min(a.y, b.y) <= std::max(p.y, q.y);
}

/// The wall through which the segment leaves its sector, or none: `to` is inside, exactly.
/// Cost: the sector's walls.
WallId way_out(const Map& map, const PathSegment& segment);

/// True where the path from -> to comes into the sector of `wall` through it.
bool comes_in_through(const Wall& wall, Vec2 from, Vec2 to);

/// The segment in the room behind `portal`, through which `segment` leaves; none where there is no grid point to stand
/// on
/// just behind the portal (a sector that is thinner than the grid), so that the portal is as good as solid.
///
/// Through a plain portal the path stays what it is. Through a link it is carried over and put onto the point grid;
/// where rounding or the tie rule (which does not turn with the link) lets the carried path miss the wall it comes out
/// of, it starts anew just behind that wall (`hop`), and an end that would lie before the wall is moved behind it.
/// Neither moves a point by more than a few grid steps, but where the sector has no grid point that near.
std::optional<PathSegment> segment_behind(const Map& map, const PathSegment& segment, WallId portal);

/// Says whether a segment may end where it does, besides that the way there stays in its sector.
using MayEnd = std::function<bool(const PathSegment&)>;

/// The last grid point of the segment, before it meets the edge a - b, that is inside the sector together with the
/// whole way to it and where the segment `may_end`; none where the segment has no such point. Searched in growing
/// steps: at most twice as far from the edge as the very last one, and the very last one where the path meets the edge
/// squarely.
/// a, b: a wall or a panel that the segment crosses
std::optional<Vec2> last_point_before(const Map& map, const PathSegment& segment, Vec2 a, Vec2 b,
                                      const MayEnd& may_end);

}  // namespace enfilade
