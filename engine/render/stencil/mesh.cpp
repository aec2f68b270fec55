#include "render/stencil/mesh.h"

namespace enfilade::stencil {

void Mesh::clear() {
    vertices_.clear();
    indices_.clear();
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

}  // namespace enfilade::stencil
