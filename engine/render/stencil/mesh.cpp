#include "render/stencil/mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::stencil {

void Mesh::clear() {
    vertices_.clear();
    indices_.clear();
}

void Mesh::add_strip(const Screen& screen, const WallOnScreen& wall, double floor, double ceiling, const Look& look) {
    if (!(floor < ceiling)) return;
    const double top = -kMargin, bottom = screen.height + kMargin;
    // An infinite height is beyond the picture's edge and beyond the other height, wherever that is.
    const auto row = [&](double height, double other, double px) {
        if (!std::isinf(height)) return row_of(screen, wall, height, px);
        const double other_row = row_of(screen, wall, other, px);
        return height > 0 ? std::min(top, other_row) : std::max(bottom, other_row);
    };
    const double x0 = wall.begin_px, x1 = wall.end_px;
    corners_ = {{x0, row(ceiling, floor, x0)},
                {x1, row(ceiling, floor, x1)},
                {x1, row(floor, ceiling, x1)},
                {x0, row(floor, ceiling, x0)}};
    clip(top, 1);
    clip(bottom, -1);
    if (corners_.size() < 3) return;
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const Corner& corner : corners_)
        vertices_.push_back({static_cast<float>(corner.x * 2 / screen.width - 1),
                             static_cast<float>(corner.y * 2 / screen.height - 1), look});
    for (std::uint32_t i = 2; i < corners_.size(); ++i)
        indices_.insert(indices_.end(), {first, first + i - 1, first + i});
}

/// Keeps what is on one side of a row. Neighbours share the edges that are cut, and the cut does not depend on the
/// direction an edge is walked in, so they still meet.
void Mesh::clip(double edge_y, double keep) {
    clipped_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Corner p = corners_[i], q = corners_[(i + 1) % corners_.size()];
        const bool p_in = (p.y - edge_y) * keep >= 0, q_in = (q.y - edge_y) * keep >= 0;
        if (p_in) clipped_.push_back(p);
        if (p_in == q_in) continue;
        const auto [low, high] = p.x < q.x ? std::pair{p, q} : std::pair{q, p};
        clipped_.push_back({low.x + (high.x - low.x) * ((edge_y - low.y) / (high.y - low.y)), edge_y});
    }
    std::swap(corners_, clipped_);
}

}  // namespace enfilade::stencil
