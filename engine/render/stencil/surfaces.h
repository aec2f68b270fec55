// What the parts of walls look like: from surfaces, pegs and light to what the shader is told.
#pragma once
#include "map/textures.h"
#include "render/light_grids.h"
#include "render/sprite.h"
#include "render/stencil/look.h"
#include "render/stencil/plan.h"
#include "render/stencil/texel_store.h"

namespace enfilade::stencil {

/// What there is to see, and where its pictures are kept.
struct Scene {
    const FrameInput& input;
    const TexelStore& store;
    const Screen& screen;  ///< of the picture; of a tilted one: of its panorama
    const RayField& rays;
    Records& records;    ///< grow while looks are made
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
Look wall_look(const Scene& scene, const SeenWall& wall, LayId surface, WallPart part);

/// A picture with holes in a portal, shown once from top to bottom. top: above the eye [m].
Look hanging_look(const Scene& scene, const SeenWall& wall, double top);

Look panel_look(const Scene& scene, const PanelOnScreen& panel, const Pose& pose);

/// A floor or ceiling, or the sky: above and below a wall everything up to the picture's edge shows it, because there
/// a ray has left the room's heights before it reached the wall. height: of the flat above the eye [m]. grid: of point
/// lights on it; null: none.
Look flat_look(const Scene& scene, const SeenWall& wall, const FlatNow& flat, double height, const LightGrid* grid,
               SurfaceId id);

/// The end of a chain of links.
Look end_look(const Scene& scene, const SeenWall& wall);

/// Only where it is: for masks.
Look plain_look(const Scene& scene, const WallOnScreen& place);

Look thing_look(const Scene& scene, const ThingOnScreen& thing);

}  // namespace enfilade::stencil
