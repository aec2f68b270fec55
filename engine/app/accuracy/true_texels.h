// Where pixels look on the pictures of walls, floors and ceilings, worked out far more exactly than any renderer does:
// what `enfilade accuracy` measures texels against.
//
// Which walls a ray meets is decided in whole numbers (render/reference/ray_path.h). Everything else, depths, heights
// and places on pictures, is worked out here anew, from the map and the view, in numbers of 113 bits.
#pragma once
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/frame.h"
#include "render/reference/ray_path.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

#if defined(__SIZEOF_FLOAT128__)
__extension__ using Quad = __float128;
#else
using Quad = long double;  // 113 bits wherever there is no __float128 on Linux
#endif

/// What a pixel shows, but for things, panels and pictures with holes, which are looked through.
struct TrueTexel {
    PixelSurface id = kNothing;
    TextureId texture;
    Quad u = 0, v = 0;  ///< on the picture [tiles]; not brought into [0, 1)
};

/// The pixels of one column of a picture.
class TrueColumn {
public:
    /// map, snapshot: outlive it. view: not tilted.
    TrueColumn(const Map& map, const Snapshot& snapshot, const View& view, int width, int height, int x);

    /// None where a sky or the end of a chain of links is seen. Cost: some microseconds.
    std::optional<TrueTexel> at(int y);

private:
    /// One wall that the column's rays meet.
    struct Met {
        const RayHit* hit;
        Quad depth, along;
    };
    Met met(std::size_t i);
    bool is_above(Quad climb, Quad depth, double height) const;
    TrueTexel on_wall(const Met& at, SurfaceId surface, WallPart part, Quad climb, double peg) const;
    std::optional<TrueTexel> on_flat(const Met& at, bool is_floor, Quad climb, const RowClimb& tied,
                                     double height) const;

    const Map& map_;
    const Snapshot& snapshot_;
    Projection projection_;
    int max_depth_;
    Quad slope_;
    RayPath path_;
};

/// How far a place that was drawn is from the true one, along the longer side of a picture of this size, the shorter
/// way round [texels].
double texel_error(const TrueTexel& truth, TexelPosition drawn, std::uint32_t width, std::uint32_t height);

}  // namespace enfilade
