// Where the walls of one sector stand on the screen, seen from one pose.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "map/map.h"
#include "render/segment.h"
#include "render/view.h"

namespace enfilade::column {

// The numbers of one picture size and look, worked out once a frame for every column and row.

/// Rays by index: what Projection computes, kept in tables.
struct RayTables {
    int width = 0;
    int height = 0;
    double focal_y = 1;              ///< [px]
    double horizon = 0;              ///< [px]
    double row_at_eye = 0;           ///< where rays by the tie rule for rows are level, from the top [px]
    double row_doubt = 0;            ///< how far kDepthDoubt may take the row in which a height is met [px]
    double column_scale = 1;         ///< columns per unit of slope
    std::vector<double> slopes;      ///< [width] tangent right of the middle
    std::vector<double> row_rises;   ///< [height] rows above the horizon [px]
    std::vector<double> tied_rises;  ///< [height] the same by the tie rule: of these is asked what a row passes
    std::vector<double> row_depths;  ///< [height] depth at which a ray has climbed 1 m; infinite on the horizon [m/m]

    void set(const Projection& projection);
};

/// A wall that faces the eye, as columns see it: covers those between its left end L and its right end R
/// (render/segment.h).
struct ProjectedWall {
    WallId wall;             ///< none: a panel
    int begin = 0, end = 0;  ///< columns covered, within the screen
    Vec2 left_v, right_v;    ///< L and R in view space: x right, y stands for depth
    Vec2 across_v;           ///< L - R, with the rounding of so short a way only
    double cross = 0;        ///< cross(L, R) = 2 x area of eye, L, R [m^2]; 0 where the eye is on the wall's line
    double inverse_cross = 0;
    double nearest = 0, farthest = 0;  ///< bounds of the depth anywhere on the wall [m]
    double sure_span = 0;     ///< where e_L - e_R is less, rounding takes the depth farther than kDepthDoubt [m]
    bool swapped = false;     ///< L is the wall's b: it is seen in a mirror
    bool stands_in = false;   ///< for a wall that covers its one column: this one does not, and is met at `nearest`
    double missed_along = 0;  ///< where, from its a to its b, if it stands in, 0..1
};

/// What a column sees of a wall.
struct WallHit {
    double depth = 0;  ///< [m], >= 0, finite
    double along = 0;  ///< position on the wall from a to b, 0..1
};

/// e_L - e_R: positive wherever the wall covers the column, because e_L and e_R are not both 0 there.
inline double edge_span(const ProjectedWall& w, double slope) { return edge(w.across_v, slope); }

/// 1 / depth at slope s: linear in s, infinite where the eye is on the wall's line.
inline double inverse_depth(const ProjectedWall& w, double slope) { return edge_span(w, slope) * w.inverse_cross; }

/// How far rounding may take it from the true one [1/m]. Infinite where the eye is on the wall's line.
inline double inverse_depth_doubt(const ProjectedWall& w, double slope) {
    return edge_doubt(w.across_v, slope) * w.inverse_cross;
}

/// Up to rounding, and never outside the wall however grazing the look.
WallHit hit(const ProjectedWall& wall, double slope);

/// inverse_depth(); where the wall stands in for one, that of its hit().
inline double inverse_depth_seen(const ProjectedWall& w, double slope) {
    return w.stands_in ? 1 / hit(w, slope).depth : inverse_depth(w, slope);
}

/// The walls of `sector` that face the eye and cover at least one column, in the order of the map.
/// `out` is emptied first and keeps its memory.
void project(const Map& map, SectorId sector, const Pose& pose, const RayTables& screen,
             std::vector<ProjectedWall>& out);

/// For a column that no wall of the sector covers: the one that stands in (render/segment.h), as if it covered
/// that column alone.
ProjectedWall least_missed(const Map& map, SectorId sector, const Pose& pose, const RayTables& screen, int column,
                           WallId entry);

/// How deep the ray of column x is at the wall, which is `segment` turned to the eye and covers the column. Exact.
RayDepth exact_depth(const Segment& segment, const Pose& pose, const RayTables& screen, int x);

/// A single edge, which faces the eye: without its number. Covers no column (begin >= end) where it is not seen.
ProjectedWall project(const Segment& facing, const Pose& pose, const RayTables& screen);

// One sector may be seen in one frame through many doorways and many transforms: its walls are projected once for
// each pose, not once for each viewport.

/// Projections of one frame by (sector, pose). Keeps its memory from frame to frame.
class ProjectionCache {
public:
    void start_frame();

    /// Where the sector's walls stand; projected now if nobody asked before, or what was known had to make room. Valid
    /// until the next call.
    const std::vector<ProjectedWall>& get(const Map& map, SectorId sector, int pose_index, const Pose& pose,
                                          const RayTables& screen);

private:
    /// A place in an open-addressed table; empty where frame is not the present one.
    struct TableSlot {
        std::uint64_t key = 0;
        std::uint32_t frame = 0;
        std::uint32_t projection = 0;
    };

    TableSlot& find(std::uint64_t key);
    void grow();

    std::vector<TableSlot> slots_{std::vector<TableSlot>(256)};  ///< a power of two, at most half full
    std::deque<std::vector<ProjectedWall>> projections_;
    std::uint32_t used_ = 0;
    std::size_t walls_ = 0;  ///< of all that are used
    std::uint32_t frame_ = 1;
};

}  // namespace enfilade::column
