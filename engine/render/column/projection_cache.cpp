#include "render/column/projection_cache.h"

#include <utility>

namespace enfilade::column {
namespace {

/// What is kept of one frame: 120 MB of walls, and as many sectors as the largest views look into a hundred times.
constexpr std::size_t kMostWalls = std::size_t{1} << 20, kMostProjections = std::size_t{1} << 16;

}  // namespace

void ProjectionCache::start_frame() {
    used_ = 0;
    walls_ = 0;
    if (++frame_ == 0) {  // after 2^32 frames old marks would look new
        slots_.assign(slots_.size(), {});
        frame_ = 1;
    }
}

const std::vector<ProjectedWall>& ProjectionCache::get(const Map& map, SectorId sector, int pose_index,
                                                       const Pose& pose, const Screen& screen) {
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(pose_index)} << 32 | sector.index;
    Slot* slot = &find(key);
    if (slot->frame == frame_) return projections_[slot->projection];
    if (walls_ > kMostWalls || used_ > kMostProjections) {
        start_frame();
        slot = &find(key);
    }
    if (2 * (used_ + 1) > slots_.size()) {
        grow();
        slot = &find(key);
    }
    if (used_ == projections_.size()) projections_.emplace_back();
    *slot = {key, frame_, used_};
    project(map, sector, pose, screen, projections_[used_]);
    walls_ += projections_[used_].size();
    return projections_[used_++];
}

ProjectionCache::Slot& ProjectionCache::find(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (key * 0x9E3779B97F4A7C15u) >> 32;  // Fibonacci hashing: the golden ratio spreads close keys
    while (slots_[i & mask].frame == frame_ && slots_[i & mask].key != key) ++i;
    return slots_[i & mask];
}

void ProjectionCache::grow() {
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(slots_.size() * 2));
    for (const Slot& slot : old)
        if (slot.frame == frame_) find(slot.key) = slot;
}

}  // namespace enfilade::column
