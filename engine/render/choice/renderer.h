// The renderers by name, behind one face: what a command draws with.
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/dials.h"
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

    /// Sets every pixel of the frame, whose size is the picture's: 1..kMaxPictureSide / Dials::samples each way. facts:
    /// null, or reset() to the same size. view: its eye is in its sector; a tilt is a broken contract of the column
    /// renderer. An error where a graphics card fails; the frame may then hold anything.
    virtual Result<void> render(Frame& frame, FrameFacts* facts, const Snapshot& snapshot, const View& view) = 0;

    /// Whether pictures may stay on the graphics card, in the context that was opened for this renderer.
    virtual bool keeps_on_card() const { return false; }
    /// As render(), for a renderer that keeps_on_card(): the picture holds until the next is drawn.
    virtual Result<GlPicture> render_on_card(int width, int height, const Snapshot& snapshot, const View& view);

    /// The viewports of the last picture; empty where the renderer has none. Cost: allocates.
    virtual std::vector<ViewportShape> viewports() const { return {}; }

    /// The name of the inner loops it draws with ("scalar", "sse2" or "avx2"); empty where there is no choice.
    virtual std::string_view kernels() const { return {}; }
};

/// How pictures are drawn.
struct RendererChoice {
    RendererKind kind = RendererKind::column;
    /// Where a pixel has several samples, its facts are those of its middle.
    Dials dials;
    std::size_t threads = 1;  ///< that may draw one picture together, >= 1: it does not depend on them
    GlContextOpener open_gl;  ///< asked for an OpenGL context where the kind is drawn by one, and by no other
};

/// An error where dials are set that this renderer has not, or where a promise stands beside dials that break it.
Result<void> check_dials(RendererKind kind, const Dials& dials);

/// Those that this renderer has, the others as usual: what a picture is compared with is drawn by them.
Dials dials_for(RendererKind kind, const Dials& dials);

/// map, textures: outlive it, and stay as they are.
/// An error where there is no such context, or none that will do, and where check_dials() has one.
Result<std::unique_ptr<Renderer>> make_renderer(const RendererChoice& choice, const Map& map,
                                                const TextureSet& textures);

}  // namespace enfilade
