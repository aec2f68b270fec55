#include "space/trace.h"

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

/// The whole way from the segment's beginning to p, on a straight line, stays in the sector (once it has come in), and
/// may end there.
bool reaches(const Map& map, const PathSegment& segment, Vec2 p, const MayEnd& may_end) {
    if (segment.entry && !comes_in_through(map[segment.entry], segment.from, p)) return false;
    const PathSegment way{segment.sector, segment.from, p, segment.entry, segment.hop};
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
std::optional<PathSegment> hop_behind(const Map& map, WallId id, Vec2 p) {
    const Wall& wall = map[id];
    const Vec2 on_wall = nearest_on(wall, p), middle = (wall.a + wall.b) * 0.5, inward = step_inward(wall);
    for (double pull : kPullsToMiddle) {
        const Vec2 base = snap_to_point_grid(on_wall + (middle - on_wall) * pull);
        for (double steps : kStepsBeside) {
            const PathSegment hop{wall.sector, base - inward * steps, base + inward * steps, id};
            if (comes_in_through(wall, hop.from, hop.to) && !way_out(map, hop)) return hop;
        }
    }
    return {};
}

std::optional<PathSegment> carried_segment(const Map& map, const PathSegment& segment, const Wall& portal) {
    const Wall& exit = map[portal.exit];
    const Vec2 from = map.carried(portal, segment.from), to = map.carried(portal, segment.to);
    if (comes_in_through(exit, from, to)) return PathSegment{portal.behind, from, to, portal.exit};

    const Vec2 crossing = segment.from + (segment.to - segment.from) * fraction_at(segment, portal.a, portal.b).value();
    const auto hop = hop_behind(map, portal.exit, map.passage(portal).apply(crossing));
    const auto end = put_on_side(exit, to, 1);
    if (!hop || !end) return {};
    return PathSegment{portal.behind, hop->to, *end, {}, Hop{portal.exit, hop->from}};
}

}  // namespace

WallId way_out(const Map& map, const PathSegment& segment) {
    if (segment.from == segment.to) return {};
    const Sector& sector = map[segment.sector];
    std::optional<PathFraction> entrance, nearest;
    if (segment.entry)
        entrance = fraction_along_path(segment.from, segment.to, map[segment.entry].a, map[segment.entry].b);
    WallId out;
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (!boxes_touch(segment, wall.a, wall.b) || !path_leaves_through(segment.from, segment.to, wall.a, wall.b))
            continue;
        const PathFraction at = fraction_along_path(segment.from, segment.to, wall.a, wall.b);
        if (entrance && compare(at, *entrance) <= 0) continue;
        if (nearest && compare(at, *nearest) >= 0) continue;
        nearest = at;
        out = WallId(i);
    }
    return out;
}

bool comes_in_through(const Wall& wall, Vec2 from, Vec2 to) { return path_leaves_through(to, from, wall.a, wall.b); }

std::optional<PathSegment> segment_behind(const Map& map, const PathSegment& segment, WallId portal) {
    const Wall& wall = map[portal];
    if (wall.link != Wall::kNoLink) return carried_segment(map, segment, wall);
    return PathSegment{wall.behind, segment.from, segment.to, wall.exit};
}

std::optional<Vec2> last_point_before(const Map& map, const PathSegment& segment, Vec2 a, Vec2 b,
                                      const MayEnd& may_end) {
    const PathSegment start{segment.sector, segment.from, segment.from, segment.entry, segment.hop};
    if (!may_end(start)) return {};
    const Vec2 path = segment.to - segment.from;
    const double step = kPointGrid / std::max(std::fabs(path.x), std::fabs(path.y));
    const double end = fraction_at(segment, a, b).value();
    const double begin = segment.entry ? fraction_at(segment, map[segment.entry].a, map[segment.entry].b).value() : 0;
    for (double back = 0; end - back > begin; back = back > 0 ? 2 * back : step) {
        const Vec2 p = snap_to_point_grid(segment.from + path * (end - back));
        if (reaches(map, segment, p, may_end)) return p;
    }
    if (segment.entry) return {};
    return segment.from;
}

}  // namespace enfilade
