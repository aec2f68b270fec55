// What the parts of walls look like: from surfaces, pegs and light to what the shader is told.
#pragma once
#include "map/textures.h"
#include "render/light_grids.h"
#include "render/sprite.h"
#include "render/stencil/paint_params.h"
#include "render/stencil/plan.h"
#include "render/stencil/texel_store.h"

namespace enfilade::stencil {

/// What there is to see, and where its pictures are kept.
struct DrawInput {
    const FrameInput& input;
    const TexelStore& store;
    const Screen& screen;  ///< of the picture; of a tilted one: of its panorama
    const RayField& rays;
    Records& records;    ///< grow while PaintParams are made
    LightGrids* lights;  ///< null: the map has no point lights

    const Map& map() const { return input.map; }
};

/// Everything about one wall of a layer that its parts have in common.
struct SeenWall {
    const Pose& pose;
    const WallOnScreen& place;
    WallParts parts;
};

/// A wall or a step.
PaintParams wall_params(const DrawInput& scene, const SeenWall& wall, SurfaceId surface, WallPart part);

/// A picture with holes in a portal, shown once from top to bottom. top: above the eye [m].
PaintParams hanging_params(const DrawInput& scene, const SeenWall& wall, double top);

PaintParams panel_params(const DrawInput& scene, const PanelOnScreen& panel, const Pose& pose);

/// A floor or ceiling, or the sky: above and below a wall everything up to the picture's edge shows it, because there
/// a ray has left the room's heights before it reached the wall. height: of the flat above the eye [m]. grid: of point
/// lights on it; null: none.
PaintParams flat_params(const DrawInput& scene, const SeenWall& wall, const FlatNow& flat, double height,
                        const LightGrid* grid, PixelSurface id);

/// The end of a chain of links.
PaintParams end_params(const DrawInput& scene, const SeenWall& wall);

/// Only where it is: for masks.
PaintParams plain_params(const DrawInput& scene, const WallOnScreen& place);

PaintParams thing_params(const DrawInput& scene, const ThingOnScreen& thing);

}  // namespace enfilade::stencil
