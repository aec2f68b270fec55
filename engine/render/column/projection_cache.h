// One sector may be seen in one frame through many doorways and many transforms: its walls are projected once for
// each pose, not once for each viewport.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "render/column/sector_projection.h"

namespace enfilade::column {

/// Projections of one frame by (sector, pose). Keeps its memory from frame to frame.
class ProjectionCache {
public:
    void start_frame();

    /// Where the sector's walls stand; projected now if nobody asked before, or what was known had to make room. Valid
    /// until the next call.
    const std::vector<ProjectedWall>& get(const Map& map, SectorId sector, int pose_index, const Pose& pose,
                                          const Screen& screen);

private:
    /// A place in an open-addressed table; empty where frame is not the present one.
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t frame = 0;
        std::uint32_t projection = 0;
    };

    Slot& find(std::uint64_t key);
    void grow();

    std::vector<Slot> slots_{std::vector<Slot>(256)};  ///< a power of two, at most half full
    std::deque<std::vector<ProjectedWall>> projections_;
    std::uint32_t used_ = 0;
    std::size_t walls_ = 0;  ///< of all that are used
    std::uint32_t frame_ = 1;
};

}  // namespace enfilade::column
