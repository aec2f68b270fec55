// Which wall does each open column of a viewport see first?
#pragma once
#include <span>
#include <vector>

#include "render/column/sector_projection.h"
#include "render/column/viewport.h"

namespace enfilade::column {

/// The answer for the columns of one viewport: a number for wall(), or kNoWall where the column is closed.
class NearestWalls {
public:
    static constexpr int kNoWall = -1;

    /// Keeps of the viewport's projected walls those beyond its boundary, and of those the nearest in each column. The
    /// walls must stay where they are as long as questions are asked.
    void choose(const Map& map, const Screen& screen, const Viewport& viewport, const Pose& pose,
                std::span<const ProjectedWall> walls);

    int at(int x) const { return nearest_[static_cast<std::size_t>(x - begin_)].wall; }
    double inverse_depth_at(int x) const { return nearest_[static_cast<std::size_t>(x - begin_)].inverse_depth; }

    /// Numbers given out are below this.
    std::size_t count() const { return walls_.size() + lost_.size(); }
    const ProjectedWall& wall(int number) const {
        const auto i = static_cast<std::size_t>(number);
        return i < walls_.size() ? walls_[i] : lost_[i - walls_.size()];
    }

private:
    struct Nearest {
        int wall = kNoWall;
        double inverse_depth = 0;
    };

    void offer(const Map& map, const Screen& screen, const Viewport& viewport, int candidate);
    void find_lost(const Map& map, const Screen& screen, const Viewport& viewport, const Pose& pose);

    int begin_ = 0;
    std::span<const ProjectedWall> walls_;
    std::vector<Nearest> nearest_;
    std::vector<ProjectedWall> lost_;  ///< one for each column that no projected wall covers; numbered after those
};

}  // namespace enfilade::column
