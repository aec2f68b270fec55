// What is seen through one chain of portals, and the pool and stack that viewports live in.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "base/id.h"
#include "render/column/sector_projection.h"
#include "render/openings.h"

namespace enfilade::column {

/// The portal that a viewport is seen through, in the room before it.
struct Doorway {
    WallId wall;
    int pose = 0;                        ///< index of the eye in the frame's list of poses
    std::optional<double> missed_depth;  ///< where it stands in for a wall [m]
};

/// A sector seen through one chain of portals: which columns, which rows of them, and from how deep on.
struct Viewport {
    SectorId sector;
    WallId entry;                  ///< the wall of `sector` the look comes in through; none for the eye's own sector
    int pose = 0;                  ///< index of the eye in the frame's list of poses
    int depth = 0;                 ///< portals looked through so far
    std::uint32_t spent = 0;       ///< on the looks into this sector and those before it (render/openings.h)
    StrayingLook straying;         ///< of its one column, where it strays
    Doorway doorway;               ///< the portal looked through; nothing of the eye's own sector
    int begin = 0, end = 0;        ///< columns
    std::vector<OpenRows> rows;    ///< occlusion bounds [end - begin]
    std::vector<double> boundary;  ///< 1 / depth of the portal looked through [end - begin]; what is drawn lies beyond.
                                   ///< Infinite in the eye's own sector

    OpenRows& rows_at(int x) { return rows[static_cast<std::size_t>(x - begin)]; }
    double& boundary_at(int x) { return boundary[static_cast<std::size_t>(x - begin)]; }
    const OpenRows& rows_at(int x) const { return rows[static_cast<std::size_t>(x - begin)]; }
    double boundary_at(int x) const { return boundary[static_cast<std::size_t>(x - begin)]; }

    /// Gives up the closed columns at both ends. True if any is left open.
    bool trim();
};

/// Hands viewports out and takes them all back at the end of a frame. Grows as needed and never gives memory back, so
/// that nothing is allocated once the hardest frame has been seen.
class ViewportPool {
public:
    /// A viewport of columns [begin, end), all closed.
    Viewport& take(int begin, int end);
    void take_all_back() { used_ = 0; }

    std::size_t used() const { return used_; }
    const Viewport& operator[](std::size_t i) const { return viewports_[i]; }

private:
    std::deque<Viewport> viewports_;  ///< a deque, so that viewports stay where they are when it grows
    std::size_t used_ = 0;
};

/// Viewports that are still to be drawn. Which comes first does not change the picture, for no two of them have an
/// open pixel in common; last in, first out keeps the stack as short as the chains are.
using ViewportStack = std::vector<Viewport*>;

// Which rows of a column show ceiling, wall, opening and floor.

/// Rows of one column, top to bottom:
///   [top, wall_top) ceiling   [wall_top, opening_top) step down   [opening_top, opening_bottom) what lies behind
///   [opening_bottom, wall_bottom) step up   [wall_bottom, bottom) floor
/// A solid wall has no opening: its rows are [wall_top, wall_bottom).
struct RowSplit {
    int wall_top = 0, opening_top = 0, opening_bottom = 0, wall_bottom = 0;
};

// What neighbouring columns see of one wall: where it stands, and which rows show what. Worked out for many columns at
// once, so that compilers do it for two or four of them at a time.

/// Columns [begin, begin + count).
struct WallLooks {
    static constexpr int kMost = 64;  ///< as many as fit well into the first-level cache

    // All three stay where they are while the looks are used.
    const ProjectedWall* wall = nullptr;
    const Pose* pose = nullptr;
    const RayTables* screen = nullptr;
    Vec2 a, b;  ///< of the wall, turned to the eye
    int begin = 0, count = 0;
    double farthest = 0;          ///< no depth is larger [m]
    double depth[kMost];          ///< [m], >= 0, finite; differs from the exact one by kDepthDoubt at most
    double along[kMost];          ///< position on the wall from a to b, 0..1
    double inverse_depth[kMost];  ///< [1/m]; infinite where the eye is on the wall's line

    WallHit at(int i) const { return {depth[i], along[i]}; }
    RayDepth exact_depth(int i) const;
};

/// The wall is `segment`, turned to the eye. count: 1..WallLooks::kMost.
void look_at(const ProjectedWall& wall, const Segment& segment, const Pose& pose, const RayTables& screen, int begin,
             int count, WallLooks& looks);

// Which rows of a column show what.

/// The rows of one column at a depth.
class RowsAt {
public:
    /// Of a depth that is exact [m].
    RowsAt(const RayTables& screen, double depth) : RowsAt(screen, depth, nullptr, 0) {}

    /// Of the i-th column that is looked at.
    RowsAt(const RayTables& screen, const WallLooks& looks, int i) : RowsAt(screen, looks.depth[i], &looks, i) {}

    /// The first of the rows [top, bottom) in which a surface is lower than `height` above the eye; bottom if none is:
    /// the first that does not reach the height (render/exact_ray.h). The division tells, unless it ends within
    /// rounding of the border between two rows.
    int first_below(double height, int top, int bottom) const {
        const double row = at_eye_ - height * focal_y_ * nearness_;
        if (!(row > top)) return top;
        if (row > bottom + doubt_) return bottom;
        const int y = static_cast<int>(row);
        const double part = row - y;
        return part > doubt_ && part < 1 - doubt_ ? y : settle(height, y, top, bottom);
    }

private:
    RowsAt(const RayTables& screen, double depth, const WallLooks* looks, int i)
        : screen_(screen),
          looks_(looks),
          i_(i),
          focal_y_(screen.focal_y),
          at_eye_(screen.row_at_eye),
          doubt_(screen.row_doubt),
          depth_(depth),
          nearness_(1 / (depth > kAnInstant ? depth : kAnInstant)) {}

    int settle(double height, int y, int top, int bottom) const;

    const RayTables& screen_;
    const WallLooks* looks_;  ///< null: the depth is exact
    int i_;
    double focal_y_, at_eye_, doubt_, depth_, nearness_;
};

/// Splits the open rows at a wall. behind: null for a solid wall.
inline RowSplit split_rows(const RowsAt& rows_at, OpenRows open, const RelativeHeights& here,
                           const RelativeHeights* behind) {
    RowSplit rows;
    rows.wall_top = rows_at.first_below(here.ceiling, open.top, open.bottom);
    rows.wall_bottom = rows_at.first_below(here.floor, rows.wall_top, open.bottom);
    rows.opening_top = rows.opening_bottom = rows.wall_bottom;
    if (behind == nullptr) return rows;
    // A height beyond that of the room here cuts nothing off.
    rows.opening_top = behind->ceiling < here.ceiling
                           ? rows_at.first_below(behind->ceiling, rows.wall_top, rows.wall_bottom)
                           : rows.wall_top;
    rows.opening_bottom = behind->floor > here.floor
                              ? rows_at.first_below(behind->floor, rows.opening_top, rows.wall_bottom)
                              : rows.wall_bottom;
    return rows;
}

// Which wall does each open column of a viewport see first?

/// Columns [begin, end) that see the same wall first.
struct WallColumns {
    int begin, end;
    int wall;  ///< a number for NearestWalls::wall()
};

/// The answer for one viewport, as stretches of columns from left to right. Walls of a room cross nowhere, so which of
/// two is the nearer is the same in all columns that they share: it is asked once for each pair.
class NearestWalls {
public:
    static constexpr int kNoWall = -1;

    /// Keeps of the viewport's projected walls those beyond its boundary, and of those the nearest in each column. The
    /// walls must stay where they are as long as questions are asked.
    void choose(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose,
                std::span<const ProjectedWall> walls);

    /// Without gaps but where columns are closed.
    std::span<const WallColumns> stretches() const { return stretches_; }

    /// Of an open column. Cost: the logarithm of the number of stretches.
    int at(int x) const;

    /// Numbers given out are below this.
    std::size_t count() const { return walls_.size() + lost_.size(); }
    const ProjectedWall& wall(int number) const {
        const auto i = static_cast<std::size_t>(number);
        return i < walls_.size() ? walls_[i] : lost_[i - walls_.size()];
    }

    /// Whether no projected wall covers its column.
    bool is_missed(int number) const { return static_cast<std::size_t>(number) >= walls_.size(); }

private:
    void offer(const Map& map, const RayTables& screen, WallColumns offered);
    void merge(const Map& map, const RayTables& screen, std::size_t first, WallColumns offered);
    void add(int begin, int end, int wall);
    bool is_nearer_in(const Map& map, const RayTables& screen, int candidate, const WallColumns& shared) const;
    void find_lost(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose);
    void lose(const Map& map, const RayTables& screen, const Viewport& viewport, const Pose& pose, int begin, int end);

    std::span<const ProjectedWall> walls_;
    std::vector<WallColumns> stretches_;
    std::vector<WallColumns> merged_;  ///< scratch
    std::vector<ProjectedWall> lost_;  ///< one for each column that no projected wall covers; numbered after those
};

/// RowSplit by column, and the open rows that were split: top to bottom as there.
struct RowSplits {
    int top[WallLooks::kMost], wall_top[WallLooks::kMost], opening_top[WallLooks::kMost],
        opening_bottom[WallLooks::kMost], wall_bottom[WallLooks::kMost], bottom[WallLooks::kMost];
    bool has_ceiling, has_upper, has_lower, has_floor;  ///< whether any column shows rows of it
};

/// open: of each column. behind: null for a solid wall.
void split_rows(const RayTables& screen, const WallLooks& looks, const OpenRows* open, const RelativeHeights& here,
                const RelativeHeights* behind, RowSplits& rows);

}  // namespace enfilade::column
