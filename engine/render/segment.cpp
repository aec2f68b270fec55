#include "render/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/result.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

/// Both ends of `segment` relative to the line of `line`: the smaller and the larger side.
struct Sides {
    int low;
    int high;
};

Sides sides_of(const Segment& segment, const Segment& line) {
    const int a = corner(line.a, line.b, segment.a), b = corner(line.a, line.b, segment.b);
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

Segment facing(const Panel& panel, Vec2 eye) {
    const bool from_behind = side_of_line(panel.a, panel.b, eye) < 0;
    return from_behind ? Segment(panel.b, panel.a) : Segment(panel.a, panel.b);
}

bool is_nearer(const Segment& a, const Segment& b) {
    if (sides_of(b, a).high <= 0) return true;
    return sides_of(a, b).low >= 0;
}

bool is_beyond(const Segment& wall, const Segment& entry) {
    const Sides sides = sides_of(wall, entry);
    if (sides.high <= 0) return false;
    return sides.low >= 0 || sides_of(entry, wall).low >= 0;
}

bool are_on_one_line(const Segment& a, const Segment& b) {
    const Sides sides = sides_of(a, b);
    return sides.low == 0 && sides.high == 0;
}

bool is_panel_beyond(const Segment& panel, const Segment& entry) {
    return are_on_one_line(panel, entry) || is_beyond(panel, entry);
}

namespace {

/// The way from the eye to a vertex that it stands on, by the tie rule's -(e, e^2): flatter than any wall of the vertex
/// grid (2^-26), and nothing beside any wall [m].
constexpr Vec2 kVertexAtEye{-0x1p-64, -0x1p-104};

/// One end of a wall, as columns are split at it.
struct SeenVertex {
    Vec2 vertex, vertex_v;
    double doubt;  ///< of edge() at any slope of the picture [m]

    SeenVertex(Vec2 at, Vec2 at_v, const Pose& pose, const ColumnRays& rays) : vertex(at), vertex_v(at_v) {
        const double steepest = std::max(std::fabs(rays.slopes.front()), std::fabs(rays.slopes.back()));
        doubt = at == pose.eye ? std::numeric_limits<double>::infinity() : edge_doubt(at_v, steepest);
    }
};

/// Rounded numbers decide where they are not in doubt.
bool is_right_of(const SeenVertex& end, double slope, const Pose& pose) {
    const double e = edge(end.vertex_v, slope);
    if (std::fabs(e) > end.doubt) return e > 0;
    return runs_right_of(ray_normal(pose, slope), end.vertex, pose.eye);
}

bool is_ahead(const SeenVertex& end, const Pose& pose) {
    return end.vertex == pose.eye ? is_own_vertex_ahead(pose.forward) : end.vertex_v.y >= 0;
}

/// The first column of those to the right of the vertex's own ray (for a vertex behind the eye: of the ray's other
/// half, where the edge function turns negative). The division only guesses; the edge function decides.
int split_column(const SeenVertex& end, bool ahead, const Pose& pose, const ColumnRays& rays) {
    const int width = static_cast<int>(rays.slopes.size());
    const auto is_right = [&](int x) {
        return is_right_of(end, rays.slopes[static_cast<std::size_t>(x)], pose) == ahead;
    };
    const double guess = std::ceil((end.vertex_v.x / end.vertex_v.y - rays.slopes.front()) * rays.per_slope);
    int x = !(guess > 0) ? 0 : guess >= width ? width : static_cast<int>(guess);
    while (x > 0 && is_right(x - 1)) --x;
    while (x < width && !is_right(x)) ++x;
    return x;
}

}  // namespace

Vec2 to_view(Vec2 vertex, const Pose& pose) {
    Vec2 d = vertex - pose.eye;
    if (d == Vec2{}) d = kVertexAtEye;
    return {dot(pose.right, d), dot(pose.forward, d)};
}

FacingWall facing_wall(const Segment& wall, const Pose& pose) {
    const bool swapped = pose.flip < 0;
    const Vec2 left = swapped ? wall.b : wall.a, right = swapped ? wall.a : wall.b, across = left - right;
    return {
        left,   right, to_view(left, pose), to_view(right, pose), {dot(pose.right, across), dot(pose.forward, across)},
        swapped};
}

CoveredColumns covered_columns(const FacingWall& wall, const Pose& pose, const ColumnRays& rays) {
    const int width = static_cast<int>(rays.slopes.size());
    const SeenVertex left(wall.left, wall.left_v, pose, rays), right(wall.right, wall.right_v, pose, rays);
    const bool left_ahead = is_ahead(left, pose), right_ahead = is_ahead(right, pose);
    const int from = split_column(left, left_ahead, pose, rays), to = split_column(right, right_ahead, pose, rays);
    return {std::max(left_ahead ? from : 0, right_ahead ? 0 : to),
            std::min(left_ahead ? width : from, right_ahead ? to : width)};
}

int first_column_from(double x_v, double depth, const ColumnRays& rays) {
    const int width = static_cast<int>(rays.slopes.size());
    const auto is_from = [&](int x) { return rays.slopes[static_cast<std::size_t>(x)] * depth >= x_v; };
    const double guess = std::ceil((x_v / depth - rays.slopes.front()) * rays.per_slope);
    int x = !(guess > 0) ? 0 : guess >= width ? width : static_cast<int>(guess);
    while (x > 0 && is_from(x - 1)) --x;
    while (x < width && !is_from(x)) ++x;
    return x;
}

namespace {

/// A wall that faces the eye, and how far to the left of the ray its ends are [2^-87 m].
struct MissedEnds {
    double left, right;

    MissedEnds(const Wall& wall, const Pose& pose, const RayNormal& ray) {
        const FacingWall ends = facing_wall(wall, pose);
        left = static_cast<double>(offset_left(ray, ends.left, pose.eye));
        right = static_cast<double>(offset_left(ray, ends.right, pose.eye));
    }

    /// How far the ray passes beside it.
    double by() const { return std::max({-left, right, 0.0}); }
};

WallId least_missed(const Map& map, SectorId sector, const Pose& pose, const RayNormal& ray, WallId entry) {
    constexpr double kFarther = 0x1p120;  // than any wall is missed by
    const Sector& s = map[sector];
    WallId best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (side_of_line(wall.a, wall.b, pose.eye) < 0) continue;
        const bool is_before = entry && (entry == WallId(i) || !is_beyond(wall, map[entry]));
        const double missed = MissedEnds(wall, pose, ray).by() + (is_before ? kFarther : 0);
        if (missed >= least) continue;
        least = missed;
        best = WallId(i);
    }
    ENFILADE_CHECK(best);  // around a closed outline some wall always faces the eye
    return best;
}

}  // namespace

StandIn stand_in(const Map& map, SectorId sector, const Pose& pose, double slope, WallId entry) {
    const RayNormal ray = ray_normal(pose, slope);
    const WallId id = least_missed(map, sector, pose, ray, entry);
    const Wall& wall = map[id];
    const MissedEnds missed(wall, pose, ray);
    const double from_left =
        missed.left != missed.right ? std::clamp(missed.left / (missed.left - missed.right), 0.0, 1.0) : 0.0;
    const double along = pose.flip < 0 ? 1 - from_left : from_left;
    const Vec2 place = wall.a + (wall.b - wall.a) * along;
    return {id, std::max(dot(pose.forward, place - pose.eye), 0.0), along};
}

}  // namespace enfilade
