// The slow renderer that is simply right: what the other two are measured against.
#pragma once
#include "formats/dials.h"
#include "map/textures.h"
#include "render/frame.h"
#include "render/lighting.h"
#include "render/sampling.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// How the reference renders.
struct ReferenceOptions {
    /// The colour of a pixel is the mean, in linear light, of samples x samples rays spread evenly over it.
    /// >= 1; samples times the frame's sides must not be over kMaxPictureSide.
    int samples = 1;
    int workers = 1;               ///< threads, >= 1; the picture does not depend on them
    LightGrids* lights = nullptr;  ///< of the map, kept from picture to picture; null: worked out anew for this one
    Sampling sampling = Sampling::nearest;  ///< of walls, steps, floors and ceilings
    const MipChains* mips = nullptr;        ///< of the textures, likewise
    /// Light of lamps is not taken from grids, as the other renderers have it, but worked out for each ray, by straight
    /// ways to the lamps (render/reference/own_light.cpp): some microseconds for each lamp that is near.
    bool own_light = false;
};

/// Draws the whole frame, whose size is set. What a pixel shows is decided in whole numbers (render/exact_ray.h).
/// Shares no drawing code with the other renderers.
///
/// facts: filled where not null, always from the ray through the pixel's centre
/// Cost: about 1 microsecond a pixel and sample, and for each column all walls of the sectors it looks into.
void render_reference(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                      const Snapshot& snapshot, const View& view, const ReferenceOptions& options = {});

/// What one pixel of a picture shows.
struct PixelFacts {
    PixelSurface id = kNothing;
    double depth = 0;  ///< along the view's `forward` [m]; sky: infinity
    TexelPosition texel;
};

/// The facts that render_reference() would give of pixel (x, y) of a picture of this size.
/// 0 <= x < width, 0 <= y < height. Cost: one ray.
PixelFacts look_through_pixel(const Map& map, const TextureSet& textures, const Snapshot& snapshot, const View& view,
                              int width, int height, int x, int y);

}  // namespace enfilade
