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
    has_[static_cast<std::size_t>(kind_of(look))] = true;
}

std::array<Range, kKinds> Mesh::sort_by_kind(std::size_t begin) {
    std::array<Range, kKinds> ranges{};
    if (std::none_of(has_.begin() + 1, has_.end(), [](bool has) { return has; })) {
        ranges[0] = {begin, indices_.size()};
        return ranges;
    }
    for (std::size_t i = begin; i < indices_.size(); i += 3) {
        const Kind kind = kind_of(vertices_[indices_[i]].look);
        const auto triangle = indices_.begin() + static_cast<std::ptrdiff_t>(i);
        auto& sorted = sorted_[static_cast<std::size_t>(kind)];
        sorted.insert(sorted.end(), triangle, triangle + 3);
    }
    indices_.resize(begin);
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
        ranges[kind].begin = indices_.size();
        indices_.insert(indices_.end(), sorted_[kind].begin(), sorted_[kind].end());
        ranges[kind].end = indices_.size();
        sorted_[kind].clear();
    }
    return ranges;
}

Kind Mesh::richest_kind(const Range& range) const {
    bool is_lit = false, is_by_table = false;
    const bool may_differ = has(Kind::lit) || has(Kind::by_table) || has(Kind::lit_by_table);
    for (std::size_t i = range.begin; may_differ && i < range.end; i += 3) {
        const Kind kind = kind_of(vertices_[indices_[i]].look);
        is_lit |= kind == Kind::lit || kind == Kind::lit_by_table;
        is_by_table |= kind == Kind::by_table || kind == Kind::lit_by_table;
    }
    if (is_by_table) return is_lit ? Kind::lit_by_table : Kind::by_table;
    return is_lit ? Kind::lit : Kind::plain;
}

}  // namespace enfilade::stencil
