// A body: an upright cylinder that stands, walks and falls in the rooms its disc overlaps.
#pragma once
#include <optional>
#include <span>

#include "base/containers.h"
#include "map/map.h"
#include "math/vec.h"
#include "space/reach.h"
#include "world/instant.h"

namespace enfilade {

/// Measures of a person [m]. A bit slimmer than Doom's marine (0.5), so that doors of 1 m can be walked through at an
/// angle; as tall as 56 of Doom's units, and it climbs what those climb (24 units).
inline constexpr double kBodyRadius = snap_to_point_grid(0.35);
static_assert(kBodyRadius <= kWidestBody);
inline constexpr double kStandingHeight = 1.75;
inline constexpr double kCrouchedHeight = 1.0;
inline constexpr double kMaxStep = 0.75;  ///< highest step that is climbed, and deepest that is walked down

struct Body {
    Place place;
    double feet_z = 0;                ///< [m]
    double height = kStandingHeight;  ///< of the moment [m]
    double radius = kBodyRadius;      ///< on the point grid [m]
    double ceiling_z = kWorldLimit;   ///< lowest ceiling over the disc [m]
};

/// The highest floor under a body and the lowest ceiling over it, in the space of its place [m]. A solid thing below
/// its feet is a floor, too, and one above its head a ceiling, unless that is beyond the rooms' own ceiling or floor:
/// a thing that reaches in through a portal leaves room for nobody there.
struct Clearance {
    double floor_z;
    double ceiling_z;
};
/// sectors: those that the body's disc overlaps.
Clearance clearance(const Instant& now, const Body& body, std::span<const ReachedSector> sectors);

/// Heights are compared to the millimetre of the vertex grid, so that a step that was written as 0.75 may be climbed
/// whatever binary fractions its two floors became. True where `height` is not more than `limit` [m].
constexpr bool is_at_most(double height, double limit) { return snap_to_vertex_grid(height - limit) <= 0; }

/// How high whoever stands where the body does may be to get through a portal: over the step behind it and under what
/// is left of the opening, which its own ceiling bounds as well, because on a step it stands under both [m]. Less than
/// nothing where nobody gets through. `passage` as in MayPass.
double height_through(const Instant& now, const Body& body, WallId portal, const Rigid& passage);

/// Whether the body can get through a portal.
bool can_pass(const Instant& now, const Body& body, WallId portal, const Rigid& passage);

/// Bodies cross panels, whatever their heights, but for those that block. The map must outlive it.
MayCross bodies_may_cross(const Map& map);

/// A portal that a body can pass and its disc touches. Of one that is touched at a corner alone nothing may be seen
/// behind it, but it must not close on the body all the same.
struct EnteredPortal {
    WallId portal;
    Rigid passage;  ///< as in MayPass
};
/// As many as meet around the corners of honest maps; more are as good, but take memory.
using EnteredPortals = ShortList<EnteredPortal, 64>;

/// reach() of the body's disc through the portals it can pass. entered : gets these portals; null: nobody asks
Reach around(const Instant& now, const Body& body, EnteredPortals* entered = nullptr);

/// How high whoever stands where the body does may be to stay in all of them [m]. Less than nothing where one is closed
/// for everybody.
double height_in(const Instant& now, const Body& body, const EnteredPortals& entered);

/// How low the feet may be for all of them to be climbed into [m].
double lowest_feet_in(const Instant& now, const EnteredPortals& entered);

/// Whether the body, where it is, touches no wall or panel and has headroom on the highest floor it stands on, also
/// once it has stepped up there, under the ceiling that it has there. Things beside it are for the walk to see to.
bool fits(const Instant& now, const Body& body, const Reach& around, const EnteredPortals& entered);

/// A body, and what was found around it.
struct PlacedBody {
    Body body;
    Reach around;
    EnteredPortals entered;
    Clearance free;
};

/// The body where it is, made as wide, and at most as high, as there is room: a body that was put closer to a wall
/// than its radius can still walk, and gets its width back as it leaves. In the exit of a one-way portal it keeps its
/// width. Sets its ceiling. Cost: reach(), once more for each ceiling that is lower than the one before, at most 17
/// times.
PlacedBody placed(const Instant& now, Body body);

/// The same without what is around it.
inline Body squeezed(const Instant& now, const Body& body) { return placed(now, body).body; }

// When a moving disc first touches a wall or a solid thing.

// Coming out of a one-way portal. The wall one comes out of leads nowhere, or elsewhere, and half of the body is still
// in it when the middle has passed: it must not hold who comes out, and must hold everybody else.
//
// The rule, decided exactly and by places alone, so that nothing has to be remembered from tick to tick: a wall that is
// an exit (Wall::one_way_exit) does not touch a body whose middle is behind the wall's line, whatever of the disc is
// on this side. A body in front of it that is nearer than its radius may go along it and away from it, but not nearer.
// So one can stand in an exit, leave it at any angle, and back off as far as one has come, but its middle never gets
// behind the line again. The corners beside the exit hold the body as those of any doorway do. Where the exit is itself
// a portal that the body can pass, half of the disc comes out of that, and has to fit there.

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

// Solid things near a body: upright cylinders that it may not get into.

/// A solid thing that a body might touch.
struct Obstacle {
    ThingId thing;
    Rigid passage;  ///< from the space of the body's place into that of the thing
    Vec2 centre;    ///< the middle of the body in the space of the thing, on the point grid
    double limit;   ///< how near to the thing the middle may come: both radii [m], on the point grid
    double bottom;  ///< [m], in the space of the body's place
    double top;     ///< [m], likewise
};

/// As many as anybody stands between; more are as good, but take memory.
using Obstacles = ShortList<Obstacle, 8>;

/// The solid things whose discs overlap the body's. At whatever height they are, and also behind portals that the body
/// cannot pass. Exact.
/// Cost: the solid things near the sector (Map::near).
Obstacles obstacles_overlapped(const Instant& now, const Body& body);

/// The same for all that the body's disc may come to overlap on its straight way, and some that are as near to where it
/// begins as the way is long. target: on the point grid, in the space of the place.
/// Cost: the solid things near the sectors that the middle passes, and a trace of its way; none in a map without solid
/// things.
Obstacles obstacles_on_way(const Instant& now, const Body& body, Vec2 target);

/// Whether the obstacle is neither below the body's feet nor above its head.
bool is_beside(const Obstacle& obstacle, const Body& body);

/// Whether the body's disc is nearer to the thing than the limit. Exact.
bool overlaps(const Map& map, const Obstacle& obstacle);

/// A touch on the way.
struct Contact {
    double fraction;  ///< of the way, 0..1; 0: touching already, and moving into the wall
    Vec2 normal;      ///< unit vector from the wall to the disc, in the space of the place
};

/// Where a disc that moves straight from the place of `around` to `target` first touches one of its walls, face or end;
/// of equals the first. None where it gets there free. A touch that would go less than a grid step deep is none: who
/// places the disc there sees to the last step (world/walk.cpp).
///
/// An exit of a one-way portal that holds the disc less or not at all is met accordingly.
///
/// around : reach() of the place with at least the radius plus the length of the way
/// target : on the point grid, in the space of the place
/// radius : of the disc [m]
std::optional<Contact> first_contact(const Map& map, const Reach& around, Vec2 target, double radius);

/// The same for solid things; each may be approached up to its limit, and one that is nearer already may not be
/// approached at all.
std::optional<Contact> first_contact(const Map& map, const Obstacles& obstacles, Vec2 target);

// One tick of walking: a body moves, slides along what it touches, and never gets into a wall.
//
// Sweep, then certify: where the body touches is found in double; where it is put is tested exactly. A place is taken
// only if the middle of the body gets there on a straight way (space/trace.h) and the disc touches nothing
// there (space/reach.h). If it does not fit, it is moved off by a few grid steps, and failing that it goes only part of
// the way. So a body that fits goes on fitting, for ever, and no tolerance decides anything.

/// Where a walk led.
struct Walk {
    Place end;
    Rigid passage;        ///< from the space of the start into that of the end
    Vec2 velocity;        ///< what the walls left of it, in the space of the end [m/s]
    Crossings crossings;  ///< the portals, and the panels with triggers, that its middle passed, in order

    // What it cost.
    int queries = 0;                  ///< of what the body touches, at most kMostQueries
    std::size_t walls_looked_at = 0;  ///< by them
};

/// A body touches at most five walls on one walk; on the way to each, the whole way and six parts of it are tried, each
/// with up to four steps off what is in the way.
inline constexpr int kMostQueries = 5 * (1 + (1 + 6) * 4);

/// Moves a body that fits for some time. Its feet stay at their height: steps are taken afterwards.
/// Pushing straight at a wall moves it by nothing, however often it is repeated.
///
/// body     : fits (squeezed), but for the exits of one-way portals that it is still in
/// velocity : [m/s]; |velocity| * seconds may be longer than the body is wide
/// Cost: Walk::queries of what the body touches (space/reach.h), where nothing is in the way two; some of them of all
/// it might touch on its whole way. As many traces (space/trace.h) of that way: they look at the walls of each sector
/// passed.
Walk walk(const Instant& now, const Body& body, Vec2 velocity, double seconds);

}  // namespace enfilade
