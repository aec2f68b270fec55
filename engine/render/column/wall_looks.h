// What neighbouring columns see of one wall: where it stands, and which rows show what. Worked out for many columns at
// once, so that compilers do it for two or four of them at a time.
#pragma once
#include "render/column/sector_projection.h"
#include "render/column/viewport.h"

namespace enfilade::column {

/// Columns [begin, begin + count).
struct WallLooks {
    static constexpr int kMost = 64;  ///< as many as fit well into the first-level cache

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
