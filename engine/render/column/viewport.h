// What is seen through one chain of portals, and the pool and stack that viewports live in.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "base/id.h"
#include "render/column/sector_projection.h"
#include "render/openings.h"

namespace enfilade::column {

/// A sector seen through one chain of portals: which columns, which rows of them, and from how deep on.
struct Viewport {
    SectorId sector;
    WallId entry;                  ///< the wall of `sector` the look comes in through; none for the eye's own sector
    int pose = 0;                  ///< index of the eye in the frame's list of poses
    int depth = 0;                 ///< portals looked through so far
    std::uint32_t spent = 0;       ///< on the looks into this sector and those before it (render/openings.h)
    StrayingLook straying;         ///< of its one column, where it strays
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

/// A wall that passes through the eye is met an instant after the start: nearer than any height matters, but not so
/// near that an eye at the very height of a ceiling would find all rows above it [m].
inline constexpr double kAnInstant = 0x1p-1000;

/// The rows of one column at a depth.
class RowsAt {
public:
    RowsAt(const RayTables& screen, double depth)
        : rises_(screen.tied_rises.data()),
          focal_y_(screen.focal_y),
          guess_at_eye_(screen.horizon + 0.5),
          met_(depth > kAnInstant ? depth : kAnInstant),
          nearness_(1 / met_) {}

    /// The first of the rows [top, bottom) in which a surface is lower than `height` above the eye; bottom if none is.
    /// Row y is not lower where tied_rises[y] * depth >= height * focal_y: a product; the reciprocal only guesses.
    /// Depth 0 (the eye in the wall's plane) is an instant more than nothing, so that an eye exactly at `height` has
    /// the rows under its horizon below it.
    int first_below(double height, int top, int bottom) const {
        const double height_px = height * focal_y_;
        const double guess = guess_at_eye_ - height_px * nearness_;
        int y = !(guess > top) ? top : guess >= bottom ? bottom : static_cast<int>(guess);
        while (y > top && rises_[y - 1] * met_ < height_px) --y;
        while (y < bottom && !(rises_[y] * met_ < height_px)) ++y;
        return y;
    }

private:
    const double* rises_;
    double focal_y_, guess_at_eye_, met_, nearness_;
};

/// Splits the open rows at a wall `depth` away. behind: null for a solid wall.
inline RowSplit split_rows(const RayTables& screen, OpenRows open, double depth, const RelativeHeights& here,
                           const RelativeHeights* behind) {
    const RowsAt rows_at(screen, depth);
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
    double inverse_depth_at(const RayTables& screen, int x) const;

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

// What neighbouring columns see of one wall: where it stands, and which rows show what. Worked out for many columns at
// once, so that compilers do it for two or four of them at a time.

/// Columns [begin, begin + count).
struct WallLooks {
    static constexpr int kMost = 64;  ///< as many as fit well into the first-level cache

    const ProjectedWall* wall = nullptr;  ///< stays where it is while they are used
    int begin = 0, count = 0;
    double farthest = 0;          ///< no depth is larger [m]
    double depth[kMost];          ///< [m], >= 0, finite
    double along[kMost];          ///< position on the wall from a to b, 0..1
    double inverse_depth[kMost];  ///< [1/m]; infinite where the eye is on the wall's line

    WallHit at(int i) const { return {depth[i], along[i]}; }
};

/// count: 1..WallLooks::kMost. Every column gets what hit() and inverse_depth_seen() say.
void look_at(const ProjectedWall& wall, const RayTables& screen, int begin, int count, WallLooks& looks);

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
