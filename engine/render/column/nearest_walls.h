// Which wall does each open column of a viewport see first?
#pragma once
#include <span>
#include <vector>

#include "render/column/sector_projection.h"
#include "render/column/viewport.h"

namespace enfilade::column {

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

}  // namespace enfilade::column
