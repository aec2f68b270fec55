// What few surfaces need beyond their look, in one texture of the graphics card: pairs of numbers, found by their
// place.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/result.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/light_grid.h"
#include "render/picture_now.h"
#include "render/stencil/list_texture.h"
#include "render/stencil/texel_store.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

/// The records of one frame. The first pair is not used, so that 0 is no record.
class Records {
public:
    using Pair = std::array<std::uint32_t, 2>;
    /// Forgets all of the frame before.
    void clear();

    /// Where the pairs are. They keep their order.
    std::uint32_t add(std::span<const Pair> pairs);

    /// The layers over a sky, how many first; 0: it has none. The same sky has the same record.
    std::uint32_t sky(const Map& map, const Snapshot& snapshot, const TextureSet& textures, const TexelStore& store,
                      const FlatNow& sky);

    /// Point lights on a surface: their grid, and how its points are counted: scale * what the shader knows + start.
    std::uint32_t glow(const LightGrid& grid, Vec2 scale, Vec2 start);

    /// For the graphics card. Costs nothing where there are none. An error where they do not fit.
    Status upload();

    GLuint texture() const { return texture_.id(); }

private:
    ListTexture texture_;
    std::vector<Pair> pairs_;
    std::map<const LightGrid*, std::uint32_t> grids_;  ///< where their points are
    std::vector<std::uint32_t> skies_;                 ///< by first layer; 0: not yet asked for
};

}  // namespace enfilade::stencil
