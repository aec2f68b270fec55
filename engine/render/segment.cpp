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

/// The tie rule for an eye that stands on a vertex: the eye counts as (e, e^2) farther, so the vertex lies in the
/// direction -(1, e). The slope 2^-40 is flatter than any wall of the vertex grid (2^-26), and the length 2^-64 [m] is
/// nothing beside any wall.
constexpr Vec2 kVertexAtEye{-0x1p-64, -0x1p-104};

/// Whether the ray of a column runs to the right of a vertex. For a vertex exactly on it the tie rule decides: the eye
/// at eye + (e, e^2) adds -(n.x e + n.y e^2), n = slope * forward - right, to the edge functions of all vertices alike.
/// Any rule of the vertex's own would lose the ray of an eye that stands on a doorway's line and looks along it.
bool runs_right_of(Vec2 vertex_v, double slope, const Pose& pose) {
    const double e = edge(vertex_v, slope);
    if (e != 0) return e > 0;
    const Vec2 normal = pose.forward * slope - pose.right;
    return normal.x != 0 ? normal.x < 0 : normal.y < 0;
}

/// The first column of those to the right of the vertex's own ray (for a vertex behind the eye: of the ray's other
/// half, where the edge function turns negative). The division only guesses; the edge function decides.
int split_column(Vec2 v, const Pose& pose, const ColumnRays& rays) {
    const int width = static_cast<int>(rays.slopes.size());
    const auto is_right = [&](int x) {
        return runs_right_of(v, rays.slopes[static_cast<std::size_t>(x)], pose) == (v.y >= 0);
    };
    const double guess = std::ceil((v.x / v.y - rays.slopes.front()) * rays.per_slope);
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

CoveredColumns covered_columns(Vec2 left_v, Vec2 right_v, const Pose& pose, const ColumnRays& rays) {
    const int width = static_cast<int>(rays.slopes.size());
    const int left = split_column(left_v, pose, rays), right = split_column(right_v, pose, rays);
    const bool left_ahead = left_v.y >= 0, right_ahead = right_v.y >= 0;
    return {std::max(left_ahead ? left : 0, right_ahead ? 0 : right),
            std::min(left_ahead ? width : left, right_ahead ? right : width)};
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

/// How far the ray passes beside a wall that faces the eye, times its distance [m^2].
double missed_by(const Wall& wall, const Pose& pose, double slope) {
    const bool is_swapped = pose.flip < 0;
    const Vec2 left_v = to_view(is_swapped ? wall.b : wall.a, pose),
               right_v = to_view(is_swapped ? wall.a : wall.b, pose);
    return std::max({-edge(left_v, slope), edge(right_v, slope), 0.0});
}

}  // namespace

WallId least_missed(const Map& map, SectorId sector, const Pose& pose, double slope, WallId entry) {
    const Sector& s = map[sector];
    WallId best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (side_of_line(wall.a, wall.b, pose.eye) < 0) continue;
        const bool is_before = entry && (entry == WallId(i) || !is_beyond(wall, map[entry]));
        const double missed = missed_by(wall, pose, slope) + (is_before ? kWorldLimit * kWorldLimit : 0);
        if (missed >= least) continue;
        least = missed;
        best = WallId(i);
    }
    ENFILADE_CHECK(best);  // around a closed outline some wall always faces the eye
    return best;
}

}  // namespace enfilade
