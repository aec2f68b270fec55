// The renderers by name, behind one face: what a command draws with.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/script.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/frame.h"
#include "render/stencil/gl_context.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// "column", "stencil" or "reference"; anything else is an error that says what there is.
Result<RendererKind> parse_renderer(const std::string& name);

/// The name that parse_renderer() takes.
std::string name_of(RendererKind kind);

/// One part of a picture's structure, for overlays: open rows by column when it was begun.
struct ViewportShape {
    SectorId sector;
    int depth = 0;                 ///< portals looked through
    int begin = 0, end = 0;        ///< columns [begin, end)
    std::vector<int> top, bottom;  ///< rows [top, bottom) by column [end - begin]
};

/// Draws pictures of one map, one at a time. The same arguments give the same picture, whichever renderer of its kind
/// draws it.
class Renderer {
public:
    virtual ~Renderer() = default;

    /// Sets every pixel of the frame, whose size is the picture's. facts: null, or reset() to the same size.
    /// An error where a graphics card fails; the frame may then hold anything.
    virtual Status render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) = 0;

    /// The viewports of the last picture; empty where the renderer has none. Cost: allocates.
    virtual std::vector<ViewportShape> viewports() const { return {}; }

    /// The name of the inner loops it draws with ("scalar", "sse2" or "avx2"); empty where there is no choice.
    virtual std::string_view kernels() const { return {}; }
};

/// How pictures are drawn.
struct RendererChoice {
    RendererKind kind = RendererKind::column;
    /// The colour of a pixel is the mean, in linear light, of samples x samples rays spread evenly over it; facts are
    /// those of its middle. 1..kMostSamples; samples times a side of the picture is at most kMaxPictureSide.
    int samples = 1;
    std::size_t threads = 1;  ///< that may draw one picture together, >= 1: it does not depend on them
    GlContextOpener open_gl;  ///< asked for an OpenGL context where the kind is drawn by one, and by no other
};

/// map, textures: outlive it, and stay as they are.
/// An error where there is no such context, or none that will do.
Result<std::unique_ptr<Renderer>> make_renderer(const RendererChoice& choice, const Map& map,
                                                const TextureSet& textures);

}  // namespace enfilade
