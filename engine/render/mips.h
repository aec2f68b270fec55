// Pictures made smaller by halves, so that a distant texel is about as large as a pixel (Lance Williams, "Pyramidal
// Parametrics", 1983).
#pragma once
#include <cstdint>
#include <vector>

#include "map/textures.h"
#include "render/texel_blend.h"

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

/// Between two levels.
struct MipPlace {
    int level = 0;           ///< the larger picture's
    std::uint32_t part = 0;  ///< of kBlendParts to the next level, less than that
};

/// Where texels are `texels_per_pixel` apart in neighbouring pixels: at level 0 up to 1; on a straight line from 1 to 2
/// between levels 0 and 1, from 2 to 4 between levels 1 and 2, and so on. Taken in 24 bits, so that round distances,
/// which renderers compute in different ways, fall on the same part.
MipPlace mip_place(double texels_per_pixel);

/// Which level makes texels that are `texels_per_pixel` apart in neighbouring pixels about one apart: 0 up to the
/// square root of 2, then one more for each doubling.
int mip_level(double texels_per_pixel);

}  // namespace enfilade
