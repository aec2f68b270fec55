// Which wall does each open column of a viewport see first?
#pragma once
#include <span>
#include <vector>

#include "render/column/sector_projection.h"
#include "render/column/viewport.h"

namespace enfilade::column {

/// The answer for the columns of one viewport: an index into the sector's projected walls, or kNoWall where the column
/// is closed.
class NearestWalls {
public:
    static constexpr int kNoWall = -1;

    /// Keeps of the projected walls those beyond the viewport's boundary, and of those the nearest in each column.
    void choose(const Map& map, const Screen& screen, const Viewport& viewport, std::span<const ProjectedWall> walls);

    int at(int x) const { return nearest_[static_cast<std::size_t>(x - begin_)].wall; }
    double inverse_depth_at(int x) const { return nearest_[static_cast<std::size_t>(x - begin_)].inverse_depth; }

private:
    struct Nearest {
        int wall = kNoWall;
        double inverse_depth = 0;
    };

    void offer(const Map& map, const Screen& screen, const Viewport& viewport, std::span<const ProjectedWall> walls,
               int candidate);

    int begin_ = 0;
    std::vector<Nearest> nearest_;
};

}  // namespace enfilade::column
