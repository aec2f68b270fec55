// Shows pictures on the framebuffer of a window by OpenGL. Included by the files of platform/ only.
#pragma once
#include "base/result.h"
#include "render/frame.h"
#include "render/stencil/gl_context.h"
#include "render/stencil/gl_object.h"

namespace enfilade {

/// Where a picture lies in the window [px], from its upper left corner.
struct PictureArea {
    int left = 0, top = 0, width = 0, height = 0;
    int window_width = 0, window_height = 0;
};

/// All calls with the window's context current.
class GlScreen {
public:
    /// An error says what the driver said.
    Result<void> prepare();

    /// A picture of the CPU's, scaled with sharp pixels, black bars beside it.
    Result<void> show(const Frame& frame, const PictureArea& area);
    /// A picture that was drawn in this context, its light to the power of 1 / brightness; over it a frame of the same
    /// size whose colours are multiplied by their alpha.
    Result<void> show(const GlPicture& picture, const Frame& over, double brightness, const PictureArea& area);

private:
    /// A texture of this size, made anew where it has another.
    struct CardTexture {
        stencil::GlTexture texture;
        int width = 0, height = 0;
        void resize(int new_width, int new_height);
        void upload(const Frame& frame);
    };
    Result<void> draw(bool with_over, double brightness, const PictureArea& area);

    stencil::GlProgram program_;
    stencil::GlVertexArray no_vertices_;
    stencil::GlFramebuffer copy_;
    CardTexture picture_, over_;
    int brightness_at_ = -1, with_over_at_ = -1;
};

}  // namespace enfilade
