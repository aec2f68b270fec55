// What the parts of walls look like: from surfaces, pegs and light to what the shader is told.
#pragma once
#include "map/textures.h"
#include "render/stencil/mesh.h"
#include "render/stencil/plan.h"
#include "render/stencil/texel_store.h"

namespace enfilade::stencil {

/// What there is to see, and where its pictures are kept.
struct Scene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    const TexelStore& store;
    const Screen& screen;
};

/// Everything about one wall of a layer that its parts have in common.
struct SeenWall {
    const Eye& eye;
    const WallOnScreen& place;
    WallParts parts;
};

/// A wall or a step.
Look wall_look(const Scene& scene, const SeenWall& wall, const Surface& surface, WallPart part);

/// A picture with holes in a portal, shown once from top to bottom. top: above the eye [m].
Look pane_look(const Scene& scene, const SeenWall& wall, double top);

/// A floor or ceiling, or the sky: above and below a wall everything up to the picture's edge shows it, because there
/// a ray has left the room's heights before it reached the wall. height: of the flat above the eye [m].
Look flat_look(const Scene& scene, const SeenWall& wall, const Flat& flat, double height, SurfaceId id);

/// The end of a chain of links.
Look end_look(const Scene& scene, const SeenWall& wall);

/// Only where it is: for masks.
Look plain_look(const Scene& scene, const WallOnScreen& place);

/// A thing.
Look thing_look(const Scene& scene, const ThingOnScreen& thing);

/// Height above the eye that a surface hangs from [m].
double peg_height(const WallParts& parts, Peg peg);

}  // namespace enfilade::stencil
