// A straight path through the sectors: which portals it crosses, in exact order, and what stops it. Every movement,
// look and sound goes through here; nothing else in the engine knows how to cross a portal.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "base/containers.h"
#include "map/map.h"
#include "math/predicates.h"

namespace enfilade {

// One segment of a path: the stretch of it that runs through one sector, and how it leaves that sector
// (path_segment.cpp).
//
// Why the first wall left through, beyond the one entered by, is the right one. The tie rule moves the whole path by
// (e, e^2): moved like that it passes no vertex, runs along no wall and starts and ends on none. What is left is
// a segment in general position and a region, the sector, whose border it crosses one wall at a time, by turns out of
// the region and into it. Starting inside, or having just come in, the next border crossing is one out of it: of the
// walls crossed outward, the one with the smallest fraction beyond the entrance. That holds for sectors that are not
// convex, for holes, for several outlines and where two loops touch in a vertex: the moved path never sees the vertex.

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

// Where is this point? Exact: under the tie rule (math/predicates.h) the answer is one sector or none.

/// True where the sector's outline, holes taken out, contains the moving point p. Exact. Cost: its walls.
bool contains(const Map& map, SectorId sector, Vec2 p);

/// The sector with the lowest number that contains p, or none. Where sectors overlap there may be others.
/// Cost: all bounding boxes; for places on a path use trace, which knows the way.
SectorId locate(const Map& map, Vec2 p);

/// A sector that contains p, by the place alone: `near` itself, else the first of the rooms behind its portals, links
/// left out, else that of locate(), or none. Where sectors overlap it may be another than a way leads to, so this is
/// only for comparison (Ken Silverman, Build's updatesector(), 1996).
/// near: a sector of the map. Cost: its walls, and those of its neighbours; else that of locate().
SectorId locate_near(const Map& map, SectorId near, Vec2 p);

// Panels on a path: which of them a segment of it goes through, in exact order. Only those that block or have triggers
// (Panel::is_active); to whoever moves, the others are air.

/// A panel that a path goes through.
struct MetPanel {
    PanelId panel;
    bool from_behind = false;  ///< from its left to its right, as side_of_line() has it

    bool operator==(const MetPanel&) const = default;
};

/// Says whether a path may go through a panel.
using MayCross = std::function<bool(const MetPanel&)>;

/// As many as one stands between; more are as good, but take memory.
using MetPanels = ShortList<MetPanel, 8>;

/// Adds the active panels of the segment's sector that it goes through before it leaves by `exit` (none: to its end),
/// in order along it. A panel on the very line of a wall lies inside the sector: it is met after the segment came in
/// through that wall, and before it leaves by it. Of panels on one line the one listed first comes first.
/// Exact, by the tie rule. Cost: one comparison where the sector has no active panels, else its panels.
void add_panels_met(const Map& map, const PathSegment& segment, WallId exit, MetPanels& met);

/// The first of these that may not be crossed, or none. `may_cross` empty: all may be.
MetPanel first_barrier(const Map& map, const PathSegment& segment, WallId exit, const MayCross& may_cross);

/// A place in the map: a point is only a place together with the sector it is in, because sectors may overlap.
struct Place {
    SectorId sector;
    Vec2 point;  ///< on the point grid, inside the sector

    bool operator==(const Place&) const = default;
};

/// Says whether a path may pass from a sector through one of its portals: heights, blocking, anything. `passage` leads
/// from the space where the question started into that of the portal, so that a height there can be compared.
using MayPass = std::function<bool(WallId portal, const Rigid& passage)>;

/// Whether a path may go on through the wall. A way back is shut where nobody is asked.
inline bool is_passable(const Map& map, WallId wall, const Rigid& passage, const MayPass& may_pass) {
    const WallKind kind = map[wall].kind;
    if (kind == WallKind::portal) return !may_pass || may_pass(wall, passage);
    return kind == WallKind::way_back && may_pass && may_pass(wall, passage);
}

/// One portal passed by a path, or one panel.
struct Crossing {
    WallId portal;     ///< none: a panel
    MetPanel through;  ///< where it is no portal
    bool operator==(const Crossing&) const = default;
};

/// As many as a path of a tick or a look at what is ahead has in honest maps; more are as good, but take memory.
using Crossings = ShortList<Crossing, 16>;

/// What a straight path did.
struct Trace {
    Crossings crossings;  ///< in order along the path
    Place end;            ///< the path's end; where it was stopped: the last place before the wall
    WallId stopped;       ///< the wall that ended it (solid, or not to be passed), or none
    MetPanel barrier;     ///< the panel that ended it, or none
    Rigid passage;        ///< from the space of the start into the space of the end

    bool is_stopped() const { return stopped || barrier.panel; }
};

/// Follows the path from `from` along `to - from.point` through every portal it crosses, however many, linked or not.
/// The end is inside its sector, exactly, whatever happened on the way.
///
/// Exact: the tie rule makes the order of crossings total, so a path through a vertex, along a wall or of no length
/// has one answer; where portals lead both ways, the reverse path crosses the same portals backward, and a path split
/// at one of its grid points crosses the same portals as the whole.
/// Through a link the rest of the path is carried over and put onto the point grid, so across
/// links those two hold for points that are more than a few grid steps away from the portals.
/// Mirrors are solid.
///
/// from     : inside its sector
/// to       : on the point grid, in the space of `from`, |coordinates| <= 2 * kWorldLimit
/// may_pass : asked once for each portal or way back met, in order; empty: every portal may be passed, no way back
/// may_cross: asked for each panel met that blocks or has triggers; empty: panels are nothing to the path, and are not
///            among its crossings
/// Where the path is stopped, end is the last grid point found on the way that is inside, and stopped is the wall, or
/// barrier the panel: between the start and the end there is none that may not be crossed.
/// Crossings made on the way stay made, but for those behind which there is no grid point inside.
/// A path that passes kMaxLinksOnPath links is stopped by the next.
/// Cost: the walls of the sectors passed. Takes no memory where the path is short.
Trace trace(const Map& map, const Place& from, Vec2 to, const MayPass& may_pass = {}, const MayCross& may_cross = {});

/// A straight path winds around a point where links meet as often as the angle around it fits into half a turn.
/// This is far beyond any honest map; without it a path that is aimed into such a point might never come out.
inline constexpr int kMaxLinksOnPath = 1024;

// A straight look through the sectors: which portals it passes, how far along each is, and what it meets. Where a
// moving body would stop, and how near to a wall it comes, is asked of trace().

/// A portal on the way of a look.
struct PassedPortal {
    WallId portal;
    Vec2 from;        ///< where the look came from, in the space of the portal's sector
    double at = 0;    ///< how much of the way from its beginning to its end lies before the portal, 0..1
    double rise = 0;  ///< from a height in the space where the look began to one in that of the portal's sector [m]
};

/// What became of a look.
struct SightLine {
    std::vector<PassedPortal> passed;  ///< in order
    SectorId sector;                   ///< where it ended
    WallId met;                        ///< the wall of that sector that ended it (solid or a mirror), or none
    Vec2 from;                         ///< where it came from, in the space of that sector
    double rise = 0;                   ///< from heights where it began to those of that sector [m]
};

/// Looks from a place to a point in its space, through every portal whatever the heights there. Exact as trace() is.
/// to: on the point grid, |coordinates| <= 2 * kWorldLimit. line: its memory is used again.
/// A look that passes kMaxLinksOnPath links is ended by the next. Cost: the walls of the sectors passed.
void look_along(const Map& map, const Place& from, Vec2 to, SightLine& line);

}  // namespace enfilade
