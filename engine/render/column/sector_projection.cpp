#include "render/column/sector_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "math/predicates.h"

namespace enfilade::column {
namespace {

/// The tie rule for an eye that stands on a vertex: the eye counts as (e, e^2) farther, so the vertex lies in the
/// direction -(1, e). The slope 2^-40 is flatter than any wall of the vertex grid (2^-26), and the length 2^-64 [m] is
/// nothing beside any wall.
constexpr Vec2 kVertexAtEye{-0x1p-64, -0x1p-104};

/// The vertex in view space.
Vec2 to_view(Vec2 vertex, const Pose& pose) {
    Vec2 d = vertex - pose.eye;
    if (d == Vec2{}) d = kVertexAtEye;
    return {dot(pose.right, d), dot(pose.forward, d)};
}

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
int split_column(Vec2 v, const Pose& pose, const Screen& screen) {
    const auto is_right = [&](int x) { return runs_right_of(v, screen.slopes[x], pose) == (v.y >= 0); };
    const double guess = std::ceil((v.x / v.y) * screen.column_scale + 0.5 * (screen.width - 1));
    int x = !(guess > 0) ? 0 : guess >= screen.width ? screen.width : static_cast<int>(guess);
    while (x > 0 && is_right(x - 1)) --x;
    while (x < screen.width && !is_right(x)) ++x;
    return x;
}

/// Columns whose rays run to the right of L and to the left of R, given where each changes.
void set_columns(ProjectedWall& w, const Pose& pose, const Screen& screen) {
    const int left = split_column(w.left_v, pose, screen), right = split_column(w.right_v, pose, screen);
    const bool left_ahead = w.left_v.y >= 0, right_ahead = w.right_v.y >= 0;
    w.begin = std::max(left_ahead ? left : 0, right_ahead ? 0 : right);
    w.end = std::min(left_ahead ? screen.width : left, right_ahead ? right : screen.width);
}

ProjectedWall ends_of(const Segment& wall, const Pose& pose) {
    ProjectedWall w;
    w.swapped = pose.flip < 0;
    w.left_v = to_view(w.swapped ? wall.b : wall.a, pose);
    w.right_v = to_view(w.swapped ? wall.a : wall.b, pose);
    return w;
}

void set_depths(ProjectedWall& w, const Segment& wall, const Pose& pose) {
    w.cross = std::max(exact_cross(wall.a, wall.b, pose.eye), 0.0);
    w.inverse_cross = 1 / w.cross;
    w.nearest = std::max(std::min(w.left_v.y, w.right_v.y), 0.0);
    w.farthest = std::max({w.left_v.y, w.right_v.y, 0.0});
}

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

WallHit hit(const ProjectedWall& w, double slope) {
    const double span = edge_span(w, slope);
    if (!(span > 0)) return {w.farthest, w.swapped ? 1.0 : 0.0};  // only where the wall does not cover the column
    const double along = std::clamp(edge(w.left_v, slope) / span, 0.0, 1.0);
    return {std::clamp(w.cross / span, w.nearest, w.farthest), w.swapped ? 1 - along : along};
}

void project(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, std::vector<ProjectedWall>& out) {
    out.clear();
    const Sector& s = map[sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        if (side_of_line(map.walls[i].a, map.walls[i].b, pose.eye) < 0) continue;
        ProjectedWall w = project(map.walls[i], pose, screen);
        if (w.begin >= w.end) continue;
        w.wall = WallId(i);
        out.push_back(w);
    }
}

ProjectedWall project(const Segment& facing, const Pose& pose, const Screen& screen) {
    ProjectedWall w = ends_of(facing, pose);
    set_columns(w, pose, screen);
    if (w.begin < w.end) set_depths(w, facing, pose);
    return w;
}

ProjectedWall least_missed(const Map& map, SectorId sector, const Pose& pose, const Screen& screen, int column,
                           WallId entry) {
    const Sector& s = map[sector];
    ProjectedWall best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (side_of_line(wall.a, wall.b, pose.eye) < 0) continue;
        ProjectedWall w = ends_of(wall, pose);
        w.wall = WallId(i);
        const double slope = screen.slopes[column];
        const bool is_before = entry && (entry == w.wall || !is_beyond(wall, map[entry]));
        const double missed = std::max({-edge(w.left_v, slope), edge(w.right_v, slope), 0.0}) +
                              (is_before ? kWorldLimit * kWorldLimit : 0);
        if (missed >= least) continue;
        least = missed;
        best = w;
    }
    ENFILADE_CHECK(best.wall);  // around a closed outline some wall always faces the eye
    set_depths(best, map[best.wall], pose);
    best.begin = column;
    best.end = column + 1;
    return best;
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

}  // namespace enfilade::column
