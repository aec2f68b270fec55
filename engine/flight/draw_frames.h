// Drawing a flythrough: many frames on several threads.
#pragma once
#include <functional>

#include "base/result.h"
#include "flight/flight.h"
#include "flight/renderer.h"

namespace enfilade {

/// A flythrough with all it shows. Only looks at what it is given.
struct FlightScene {
    const Flight& flight;
    const Map& map;
    const TextureSet& textures;
};

/// How and which frames are drawn.
struct DrawPlan {
    RendererKind renderer = RendererKind::column;
    int samples = 1;                ///< as RendererChoice::samples
    int width = 640, height = 400;  ///< [px]
    int first = 0, last = 0;        ///< frames, both included
    std::size_t workers = 1;        ///< threads, >= 1
    GlContextOpener open_gl;        ///< for renderers that draw by OpenGL: each worker opens one
};

/// Takes a finished frame; an error ends the drawing. The frame is valid during the call.
using FrameTaker = std::function<Status(int number, const Frame& frame, std::size_t worker)>;

/// Draws one frame. renderer: of the scene's map.
Status draw_frame(const FlightScene& scene, int number, Renderer& renderer, Frame& frame);

/// Draws each frame once and hands it to `take`, in any order, from several threads, but never two at a time with the
/// same worker. The first error in order of workers is returned.
Status draw_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

/// The same, but hands the frames over in order and on the calling thread, for films. Keeps a few frames per worker.
Status draw_frames_in_order(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take);

}  // namespace enfilade
