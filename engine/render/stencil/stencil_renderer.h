// Sectors and portals by OpenGL: what lies behind links, mirrors and doorways into overlapping rooms is kept apart by
// the stencil buffer.
//
// A frame: the planner follows the view through all portals and finds the layers (plan.h); their walls become polygons
// (layer_mesh.h, mesh.h, surfaces.h); the painter draws layer after layer, each where the stencil buffer holds its
// level (layer_painter.h); the shaders work out for each pixel what it shows (shaders.cpp).
//
// Floors, ceilings and skies are drawn as what a look meets below or above a wall, not as polygons of their own. So
// every column is closed wherever a wall stands in it, whatever the heights of the rooms; there are no T-junctions, no
// near plane, and a floor seen from below looks as it does in the other renderers.
#pragma once
#include <memory>

#include "base/result.h"
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

/// Draws pictures of a map. Keeps the map's pictures on the graphics card from frame to frame and notices when they are
/// others. One renderer draws one picture at a time, on any thread.
class StencilRenderer {
public:
    /// An error where the context is too old or has no stencil buffer.
    static Result<std::unique_ptr<StencilRenderer>> make(std::unique_ptr<GlContext> context);
    ~StencilRenderer();

    /// Draws the whole picture. An error where the context was lost or the graphics card has no room.
    ///
    /// frame    : its size is the picture's; every pixel is set
    /// facts    : null, or what each pixel shows, of the same size after reset()
    /// snapshot : heights and lights of the moment, one for each sector of the map
    /// view     : view.sector contains view.eye under the tie rule
    Status render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                  const View& view);

    StencilCounts counts() const;

private:
    struct State;
    explicit StencilRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace enfilade
