// What the stencil renderer draws with: an OpenGL context that somebody else opened.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "base/result.h"

namespace enfilade {

/// A context of OpenGL 3.3 core or OpenGL ES 3.0, or newer. It is current only while something is drawn, so that it may
/// be used by one thread after another.
class GlContext {
public:
    virtual ~GlContext() = default;

    /// The calling thread's OpenGL calls go to it from now on. An error where it was lost.
    virtual Result<void> make_current() = 0;
    /// They go nowhere again.
    virtual void release() = 0;
};

/// A picture that stays where it was drawn: in the colour of a framebuffer, row 0 of the picture being its row 0.
struct GlPicture {
    unsigned framebuffer = 0;  ///< of the context it was drawn in
    int width = 0, height = 0;
    bool is_cut_short = false;  ///< as a frame's
};

/// Opens a context, or says in a sentence why there is none.
using GlContextOpener = std::function<Result<std::unique_ptr<GlContext>>()>;

}  // namespace enfilade
