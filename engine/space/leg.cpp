#include "space/leg.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "space/beside.h"

namespace enfilade {
namespace {

/// Quick and exact: a path that the tie rule moves by (e, e^2) crosses no wall whose box its own does not touch.
bool boxes_touch(const Wall& wall, Vec2 p, Vec2 q) {
    return std::max(wall.a.x, wall.b.x) >= std::min(p.x, q.x) && std::min(wall.a.x, wall.b.x) <= std::max(p.x, q.x) &&
           std::max(wall.a.y, wall.b.y) >= std::min(p.y, q.y) && std::min(wall.a.y, wall.b.y) <= std::max(p.y, q.y);
}

double fraction_at(const Leg& leg, const Wall& wall) {
    return fraction_along_path(leg.from, leg.to, wall.a, wall.b).value();
}

/// The whole way from the leg's beginning to p, on a straight line, stays in the sector (once it has come in).
bool reaches(const Map& map, const Leg& leg, Vec2 p) {
    if (leg.entry && !comes_in_through(map[leg.entry], leg.from, p)) return false;
    return !way_out(map, {leg.sector, leg.from, p, leg.entry});
}

/// The point of the wall that is nearest to p, rounded.
Vec2 nearest_on(const Wall& wall, Vec2 p) {
    const Vec2 along = wall.b - wall.a;
    const double t = dot(p - wall.a, along) / dot(along, along);
    return wall.a + along * std::clamp(t, 0.0, 1.0);
}

/// How far the place of entry is drawn to the middle of the wall if the sector is too narrow at its end [1]. The
/// first is more than a grid step, because no wall is shorter than 2^22 of them.
constexpr double kPullsToMiddle[] = {0, 0x1p-20, 0x1p-12, 0x1p-6, 1};

/// A grid point just behind `wall`, as near to p as there is one, that can be reached straight through the wall.
std::optional<Vec2> point_behind(const Map& map, WallId id, Vec2 p) {
    const Wall& wall = map[id];
    const Vec2 on_wall = nearest_on(wall, p), middle = (wall.a + wall.b) * 0.5, inward = step_inward(wall);
    for (double pull : kPullsToMiddle) {
        const Vec2 base = snap_to_point_grid(on_wall + (middle - on_wall) * pull);
        for (double steps : kStepsBeside) {
            const Leg hop{wall.sector, base - inward * steps, base + inward * steps, id};
            if (comes_in_through(wall, hop.from, hop.to) && !way_out(map, hop)) return hop.to;
        }
    }
    return {};
}

std::optional<Leg> carried_leg(const Map& map, const Leg& leg, const Wall& portal) {
    const Wall& exit = map[portal.exit];
    const Vec2 from = map.carried(portal, leg.from), to = map.carried(portal, leg.to);
    if (comes_in_through(exit, from, to)) return Leg{portal.behind, from, to, portal.exit};

    const Vec2 crossing = leg.from + (leg.to - leg.from) * fraction_at(leg, portal);
    const auto start = point_behind(map, portal.exit, map.passage(portal).apply(crossing));
    const auto end = put_on_side(exit, to, 1);
    if (!start || !end) return {};
    return Leg{portal.behind, *start, *end, {}};
}

}  // namespace

WallId way_out(const Map& map, const Leg& leg) {
    if (leg.from == leg.to) return {};
    const Sector& sector = map[leg.sector];
    std::optional<PathFraction> entrance, nearest;
    if (leg.entry) entrance = fraction_along_path(leg.from, leg.to, map[leg.entry].a, map[leg.entry].b);
    WallId out;
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (!boxes_touch(wall, leg.from, leg.to) || !path_leaves_through(leg.from, leg.to, wall.a, wall.b)) continue;
        const PathFraction at = fraction_along_path(leg.from, leg.to, wall.a, wall.b);
        if (entrance && compare(at, *entrance) <= 0) continue;
        if (nearest && compare(at, *nearest) >= 0) continue;
        nearest = at;
        out = WallId(i);
    }
    return out;
}

bool comes_in_through(const Wall& wall, Vec2 from, Vec2 to) { return path_leaves_through(to, from, wall.a, wall.b); }

std::optional<Leg> leg_behind(const Map& map, const Leg& leg, WallId portal) {
    const Wall& wall = map[portal];
    if (wall.link != Wall::kNoLink) return carried_leg(map, leg, wall);
    return Leg{wall.behind, leg.from, leg.to, wall.exit};
}

std::optional<Vec2> last_point_before(const Map& map, const Leg& leg, WallId exit) {
    const Vec2 path = leg.to - leg.from;
    const double step = kPointGrid / std::max(std::fabs(path.x), std::fabs(path.y));
    const double end = fraction_at(leg, map[exit]);
    const double begin = leg.entry ? fraction_at(leg, map[leg.entry]) : 0;
    for (double back = 0; end - back > begin; back = back > 0 ? 2 * back : step) {
        const Vec2 p = snap_to_point_grid(leg.from + path * (end - back));
        if (reaches(map, leg, p)) return p;
    }
    if (leg.entry) return {};
    return leg.from;
}

}  // namespace enfilade
