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

/// A wall, a step, or a picture with holes. peg: height above the eye that the picture hangs from [m].
Look wall_look(const Scene& scene, const SeenWall& wall, const Surface& surface, WallPart part, double peg);
/// The same, hanging from the surface's own peg.
Look wall_look(const Scene& scene, const SeenWall& wall, const Surface& surface, WallPart part);

/// A floor or ceiling, or the sky: above and below a wall everything up to the picture's edge shows it, because there
/// a ray has left the room's heights before it reached the wall. height: of the flat above the eye [m].
Look flat_look(const Scene& scene, const SeenWall& wall, const Flat& flat, double height, SurfaceId id);

/// The end of a chain of links.
Look end_look(const Scene& scene, const SeenWall& wall);

/// Only where it is: for masks.
Look plain_look(const Scene& scene, const WallOnScreen& place);

/// Height above the eye that a surface hangs from [m].
double peg_height(const WallParts& parts, Peg peg);

}  // namespace enfilade::stencil
