#include "space/leg.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade {

Vec2 step_inward(const Wall& wall) {
    const Vec2 inward = right_of(wall.b - wall.a);
    if (std::fabs(inward.x) >= std::fabs(inward.y)) return {inward.x > 0 ? kPointGrid : -kPointGrid, 0};
    return {0, inward.y > 0 ? kPointGrid : -kPointGrid};
}

std::optional<Vec2> put_on_side(const Wall& wall, Vec2 p, int side) {
    if (side_of_line(wall.a, wall.b, p) == side) return p;
    for (double steps : kStepsBeside) {
        const Vec2 moved = p + step_inward(wall) * (steps * side);
        if (side_of_line(wall.a, wall.b, moved) == side) return moved;
    }
    return {};
}

namespace {

double fraction_at(const Leg& leg, Vec2 a, Vec2 b) { return fraction_along_path(leg.from, leg.to, a, b).value(); }

/// The whole way from the leg's beginning to p, on a straight line, stays in the sector (once it has come in), and may
/// end there.
bool reaches(const Map& map, const Leg& leg, Vec2 p, const MayEnd& may_end) {
    if (leg.entry && !comes_in_through(map[leg.entry], leg.from, p)) return false;
    const Leg way{leg.sector, leg.from, p, leg.entry, leg.hop};
    return !way_out(map, way) && may_end(way);
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

/// Straight through `wall`, as near to p as can be, to a grid point just behind it: the hop's `to`.
std::optional<Leg> hop_behind(const Map& map, WallId id, Vec2 p) {
    const Wall& wall = map[id];
    const Vec2 on_wall = nearest_on(wall, p), middle = (wall.a + wall.b) * 0.5, inward = step_inward(wall);
    for (double pull : kPullsToMiddle) {
        const Vec2 base = snap_to_point_grid(on_wall + (middle - on_wall) * pull);
        for (double steps : kStepsBeside) {
            const Leg hop{wall.sector, base - inward * steps, base + inward * steps, id};
            if (comes_in_through(wall, hop.from, hop.to) && !way_out(map, hop)) return hop;
        }
    }
    return {};
}

std::optional<Leg> carried_leg(const Map& map, const Leg& leg, const Wall& portal) {
    const Wall& exit = map[portal.exit];
    const Vec2 from = map.carried(portal, leg.from), to = map.carried(portal, leg.to);
    if (comes_in_through(exit, from, to)) return Leg{portal.behind, from, to, portal.exit};

    const Vec2 crossing = leg.from + (leg.to - leg.from) * fraction_at(leg, portal.a, portal.b);
    const auto hop = hop_behind(map, portal.exit, map.passage(portal).apply(crossing));
    const auto end = put_on_side(exit, to, 1);
    if (!hop || !end) return {};
    return Leg{portal.behind, hop->to, *end, {}, Hop{portal.exit, hop->from}};
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
        if (!boxes_touch(leg, wall.a, wall.b) || !path_leaves_through(leg.from, leg.to, wall.a, wall.b)) continue;
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

std::optional<Vec2> last_point_before(const Map& map, const Leg& leg, Vec2 a, Vec2 b, const MayEnd& may_end) {
    const Leg start{leg.sector, leg.from, leg.from, leg.entry, leg.hop};
    if (!may_end(start)) return {};
    const Vec2 path = leg.to - leg.from;
    const double step = kPointGrid / std::max(std::fabs(path.x), std::fabs(path.y));
    const double end = fraction_at(leg, a, b);
    const double begin = leg.entry ? fraction_at(leg, map[leg.entry].a, map[leg.entry].b) : 0;
    for (double back = 0; end - back > begin; back = back > 0 ? 2 * back : step) {
        const Vec2 p = snap_to_point_grid(leg.from + path * (end - back));
        if (reaches(map, leg, p, may_end)) return p;
    }
    if (leg.entry) return {};
    return leg.from;
}

}  // namespace enfilade
