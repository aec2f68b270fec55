// A body: an upright cylinder that stands, walks and falls in the rooms its disc overlaps.
#pragma once
#include <span>

#include "map/map.h"
#include "math/vec.h"
#include "space/reach.h"
#include "world/instant.h"

namespace enfilade {

/// Measures of a person [m]. A bit slimmer than Doom's marine (0.5), so that doors of 1 m can be walked through at an
/// angle; as tall as 56 of Doom's units, and it climbs what those climb (24 units).
inline constexpr double kBodyRadius = snap_to_point_grid(0.35);
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
/// its feet is a floor, too, and one above its head a ceiling.
struct Clearance {
    double floor_z;
    double ceiling_z;
};
/// sectors: those that the body's disc overlaps.
Clearance clearance(const Instant& now, const Body& body, std::span<const ReachedSector> sectors);

/// Heights are compared to the millimetre of the vertex grid, so that a step that was written as 0.75 may be climbed
/// whatever binary fractions its two floors became. True where `height` is not more than `limit` [m].
constexpr bool is_at_most(double height, double limit) { return snap_to_vertex_grid(height - limit) <= 0; }

/// Whether the body can get through a portal: over the step behind it and under what is left of the opening, which
/// its own ceiling bounds as well, because on a step it stands under both. `passage` as in MayPass.
bool can_pass(const Instant& now, const Body& body, WallId portal, const Rigid& passage);

/// Bodies cross panels, whatever their heights, but for those that block. The map must outlive it.
MayCross bodies_may_cross(const Map& map);

/// Whether the body, where it is, touches no wall or panel and has headroom on the highest floor it stands on. Things
/// beside it are for the walk to see to (world/contact.h).
bool fits(const Instant& now, const Body& body, const Reach& around);

/// The body where it is, made as wide, and at most as high, as there is room: a body that was put closer to a wall
/// than its radius can still walk, and gets its width back as it leaves. In the exit of a one-way portal it keeps its
/// width (world/one_way.h). Sets its ceiling.
Body squeezed(const Instant& now, Body body);

/// reach() of the body's disc through the portals it can pass.
Reach around(const Instant& now, const Body& body);

}  // namespace enfilade
