// Pictures made smaller by halves, so that a distant texel is about as large as a pixel (Lance Williams, "Pyramidal
// Parametrics", 1983).
#pragma once
#include <vector>

#include "map/textures.h"

namespace enfilade {

/// The smaller pictures of a set. Pictures with holes have none: what is seen through must not come nearer.
class MipChains {
public:
    /// textures: outlive this, and stay as they are. Those that go by the color table get colours of it.
    /// Cost: a look at each texel; a third of their memory.
    explicit MipChains(const TextureSet& textures);

    /// The picture whose sides are 2^level times smaller, each at least 1; the smallest one beyond that.
    /// picture: of the set, or its placeholder, which is its own only level. level: >= 0.
    const Texture& at(const Texture& picture, int level) const;

private:
    const TextureSet& textures_;
    std::vector<std::vector<Texture>> smaller_;  ///< by picture; without the picture itself
};

/// Which level makes texels that are `texels_per_pixel` apart in neighbouring pixels about one apart: 0 up to the
/// square root of 2, then one more for each doubling.
int mip_level(double texels_per_pixel);

}  // namespace enfilade
