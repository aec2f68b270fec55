// Sectors and portals by OpenGL: what lies behind links, mirrors and doorways into overlapping rooms is kept apart by
// the stencil buffer.
//
// A frame: the planner follows the view through all portals and finds the layers, and in every column which wall each
// room shows (plan.h); these become polygons (mesh.h, surfaces.h); the painter draws layer after layer,
// each where the stencil buffer holds its level (layer_painter.h); the shaders work out for each pixel what it shows
// (shaders.cpp). Upright pictures are drawn in whole columns, which are decided on the CPU by the functions of the
// column renderer; tilted ones (view.tilt) are planned all around the eye (panorama.h), and their pixels ask the edge
// functions themselves.
//
// Nothing has to be clipped at the plane of a portal, and nothing is at a near plane: a layer draws only walls that are
// beyond the portal that it is seen through, which is decided exactly and for each wall as a whole (render/segment.h).
// The classic alternative, a projection whose near plane is tilted into the portal's (Lengyel: "Oblique View Frustum
// Depth Projection and Clipping", 2005), was left out on purpose: walls in the portal's plane fall to either side by
// rounding, and depth becomes worse in proportion as the eye comes nearer to the plane, until, where portals matter
// most, there is none. Nor has depth to tell walls apart: the depth buffer holds ranks, upright through how many
// portals a wall is seen, tilted its place in the order of a sweep round the eye (tilted_order.cpp), so that walls
// through the very eye, or a millimetre apart at 10 km, are in the order that was found exactly. The dial `portals`
// draws by the classic ways, to see what they cost (in_space.cpp). What 24 bits of depth would tell apart, in a picture
// 90 degrees wide before a portal that is square to the view (one that slants is up to 1.4 times worse;
// tests/render/stencil/near_plane_test.cpp):
//
//   eye to portal    1 m      6 cm     4 mm     1 mm     1/65 mm  on it
//   at 10 m          6 um     0.1 mm   1.5 mm   6 mm     0.4 m    nothing
//   at 100 m         0.6 mm   1 cm     15 cm    0.6 m    64 m     nothing
//
// Floors, ceilings and skies are drawn as what a look meets below or above a wall, not as polygons of their own. So
// every column is closed wherever a wall stands in it, whatever the heights of the rooms; there are no T-junctions, no
// near plane, and a floor seen from below looks as it does in the other renderers.
#pragma once
#include <memory>
#include <vector>

#include "base/result.h"
#include "formats/dials.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/frame.h"
#include "render/stencil/gl_context.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// Work done for the last frame.
struct StencilCounts {
    std::size_t layers = 0;   ///< drawn: the scene of one stencil level of one chain of portals
    std::size_t sectors = 0;  ///< drawn, counted once for each layer
    std::size_t visits = 0;   ///< sectors looked into on the way, each chain of doorways counted
    std::size_t cut = 0;      ///< portals not looked through because a limit was reached
    std::size_t draws = 0;    ///< draw calls
    std::size_t triangles = 0;
    int deepest = 0;  ///< stencil level of the deepest layer
};

/// Where a sector was looked into through one chain of portals in the last frame, for overlays.
struct StencilViewport {
    SectorId sector;
    int depth = 0;                 ///< portals looked through
    int begin = 0, end = 0;        ///< columns
    std::vector<int> top, bottom;  ///< open rows by column [end - begin]; empty in tilted pictures
};

/// Draws pictures of one map, whose pictures it keeps on the graphics card. One renderer draws one picture at a time,
/// on any thread.
class StencilRenderer {
public:
    /// map, textures: outlive it. An error where the context is too old or has no stencil buffer, or the graphics card
    /// has no room for the pictures. light_points_per_m: of LightGrids. portals: exact, or another way to see what it
    /// costs (in_space.cpp). Cost: the pictures' texels, and overlapping_sectors().
    static Result<std::unique_ptr<StencilRenderer>> make(std::unique_ptr<GlContext> context, const Map& map,
                                                         const TextureSet& textures,
                                                         int light_points_per_m = kUsualLightPoints,
                                                         PortalMethod portals = PortalMethod::exact);
    ~StencilRenderer();

    /// Draws the whole picture. An error where the context was lost or the graphics card has no room, or where the
    /// view is tilted and portals are not exact.
    /// The picture is copied out of the graphics card: 4 MB at 1280 x 800, half a millisecond by Mesa's llvmpipe.
    ///
    /// frame    : its size is the picture's; every pixel is set
    /// facts    : null, or what each pixel shows, of the same size after reset()
    /// snapshot : heights and lights of the moment, one for each sector of the map
    /// view     : view.sector contains view.eye under the tie rule
    Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view);

    /// The same picture, not copied: it holds until the next is drawn. An error as above.
    Result<GlPicture> render_on_card(int width, int height, const Snapshot& snapshot, const View& view);

    StencilCounts counts() const;

    /// The last frame's looks into sectors. Allocates; for overlays and tests.
    std::vector<StencilViewport> viewports() const;

private:
    struct State;
    explicit StencilRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace enfilade
