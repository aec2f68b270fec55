#include "render/stencil/mesh.h"

#include <algorithm>

namespace enfilade::stencil {

void Mesh::clear() {
    vertices_.clear();
    indices_.clear();
    has_ = {};
    sheet_ = {};
}

void Mesh::add_sheet() {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    sheet_ = {indices_.size(), indices_.size() + 6};
    for (const auto& [x, y] : {Corner{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        vertices_.push_back({static_cast<float>(x), static_cast<float>(y), {}});
    indices_.insert(indices_.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

void Mesh::add_strip(const RayField& rays, const WallOnScreen& wall, const Heights& heights, const Look& look) {
    if (heights.is_empty()) return;
    set_between_ends(outline_, rays, wall);
    keep_between(outline_, rays, wall, heights);
    if (outline_.is_empty()) return;
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const Corner& corner : outline_.corners())
        vertices_.push_back({static_cast<float>(corner.x * 2 / rays.width - 1),
                             static_cast<float>(corner.y * 2 / rays.height - 1), look});
    for (std::uint32_t i = 2; i < outline_.corners().size(); ++i)
        indices_.insert(indices_.end(), {first, first + i - 1, first + i});
}

std::vector<KindRange> Mesh::sort_by_kind(std::size_t begin) {
    for (std::size_t i = begin; i < indices_.size(); i += 3) {
        const auto triangle = indices_.begin() + static_cast<std::ptrdiff_t>(i);
        auto& sorted = sorted_[kind_of(vertices_[indices_[i]].look)];
        sorted.insert(sorted.end(), triangle, triangle + 3);
    }
    indices_.resize(begin);
    std::vector<KindRange> ranges;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        if (sorted_[kind].empty()) continue;
        const std::size_t first = indices_.size();
        indices_.insert(indices_.end(), sorted_[kind].begin(), sorted_[kind].end());
        ranges.push_back({static_cast<Kind>(kind), {first, indices_.size()}});
        sorted_[kind].clear();
        has_[kind] = true;
    }
    return ranges;
}

KindRange Mesh::with_holes(const Range& range) {
    Kind kind = kWithHoles;
    for (std::size_t i = range.begin; i < range.end; i += 3) kind |= kind_of(vertices_[indices_[i]].look);
    if (!range.is_empty()) has_[kind] = true;
    return {kind, range};
}

}  // namespace enfilade::stencil
