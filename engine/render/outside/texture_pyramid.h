// Pictures made smaller, so that one seen from far away does not glitter.
#pragma once
#include <vector>

#include "map/textures.h"
#include "math/vec.h"
#include "render/shade.h"

namespace enfilade {

/// A texture and its halves, quarters and so on to a single texel (Lance Williams: "Pyramidal Parametrics", 1983).
class TexturePyramid {
public:
    /// Cost: the texture's pixels.
    explicit TexturePyramid(const Texture& texture);

    /// The texel at a place, of the level in which a texel of the texture is at least half a pixel wide.
    /// u, v: on the tile. texels_per_px: of the texture itself, > 0
    std::uint32_t at(TilePlace u, TilePlace v, double texels_per_px) const;

private:
    struct Level {
        std::uint32_t width = 1, height = 1;
        std::vector<std::uint32_t> pixels;  ///< by column, as in Texture
    };
    static Level halved(const Level& from);

    std::vector<Level> levels_;  ///< the largest first
};

}  // namespace enfilade
