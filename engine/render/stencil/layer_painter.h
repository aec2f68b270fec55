// Draws the layers of a frame into one another.
//
// The method of the recursive stencil papers (METHODS of Eccohedra and others), made robust: a layer is drawn where the
// stencil buffer holds its level. For each of its exits, nearest first: the portal's visible pixels are raised by one
// level, their depth is reset, the layer behind is drawn there, and then the portal's own depth is put back and the
// pixels are lowered again. So every pixel ends at the level it had, and what is drawn later, like a window's glass,
// finds the portal where it is. Where a chain is deeper than the stencil buffer has levels, all of them are kept aside
// while what is behind its deepest layer is drawn, which counts on from level 1; all other pixels wait at level 0.
#pragma once
#include <array>
#include <deque>

#include "base/result.h"
#include "render/frame.h"
#include "render/stencil/gl_object.h"
#include "render/stencil/in_space.h"
#include "render/stencil/mesh.h"
#include "render/stencil/shaders.h"

namespace enfilade::stencil {

// What is drawn into: colours, facts, depth and stencil, away from any window.

/// A framebuffer with 8-bit colours, 8 bits of stencil, depth as a float or in 24 bits and, where they are wanted,
/// facts.
class RenderTarget {
public:
    /// Before it is prepared for the first time: 24 instead of 32.
    void use_24_bits_of_depth();

    /// Makes it fit the picture and binds it, with room to keep the levels aside that often.
    /// An error where the graphics card has no such buffers.
    Result<void> prepare(int width, int height, bool with_facts, std::size_t kept = 0);

    /// Sets all pixels to "nothing drawn, infinitely far, level 0".
    void clear();

    /// Keeps the levels of all pixels aside, and brings back those that were kept last. The scissor test is on after
    /// it.
    void keep_levels();
    void bring_back_levels();

    /// Which outputs are written from now on.
    void write_all() const;
    void write_color() const;
    void write_facts() const;

    /// Copies the picture out; facts only where they were wanted. writes is 1 where something was drawn.
    void read(Frame& frame) const;
    void read(FrameFacts& facts) const;
    /// Whose colour is the picture.
    unsigned framebuffer() const { return framebuffer_.id(); }

private:
    /// A stencil buffer aside; its depth is not used, but levels can only be copied between buffers of one format.
    struct KeptLevels {
        GlFramebuffer framebuffer;
        GlRenderbuffer depth_stencil;
    };

    Result<void> make(int width, int height, bool with_facts);
    Result<void> make_kept();
    void copy_levels(const GlFramebuffer& from, const GlFramebuffer& to) const;

    GlFramebuffer framebuffer_;
    GlRenderbuffer color_, facts_, depth_stencil_;
    GLenum depth_format_ = GL_DEPTH32F_STENCIL8;
    std::deque<KeptLevels> kept_;
    std::size_t kept_now_ = 0;  ///< how many of them hold levels
    int width_ = 0, height_ = 0;
    bool with_facts_ = false;
};

class LayerPainter {
public:
    /// For the current context.
    Result<void> prepare();

    /// Compiles the programs that the mesh needs and no frame before needed.
    Result<void> prepare_for(const Mesh& mesh, VertexPlacing placing);

    /// Draws all layers into the target, which is prepared and cleared. Everything was prepared, records uploaded.
    /// lenses : by layer where polygons are in space; else none
    void paint(RenderTarget& target, const DrawInput& scene, const Plan& plan, const Mesh& mesh,
               const std::vector<LayerRanges>& ranges, const std::vector<SpaceLens>& lenses, bool with_facts);

    std::size_t draws() const { return draws_; }

private:
    struct PaintJob {
        RenderTarget& target;
        const DrawInput& scene;
        const Plan& plan;
        const std::vector<LayerRanges>& ranges;
        const std::vector<SpaceLens>& lenses;
        IndexRange sheet;
        bool with_facts;
    };

    void upload(const Mesh& mesh);
    void set_uniforms(const DrawInput& scene) const;
    void use_masks(const PaintJob& job, const Layer& layer, bool is_far) const;
    static void use_lens(const LensUniforms& uniforms, const PaintJob& job, const Layer& layer);
    void set_uniforms(const SurfaceProgram& program, const DrawInput& scene) const;
    void paint_surfaces(const PaintJob& job, const Layer& layer, const LayerRanges& ranges);
    void set_entry(const SurfaceProgram& program, const PaintJob& job, const Layer& layer);
    // level: what the stencil buffer holds where the layer is.
    void paint_layer(const PaintJob& job, std::size_t index, int level);
    void look_through(const PaintJob& job, const Layer& layer, const LayerRanges& ranges, int level);
    void look_through(const PaintJob& job, const Layer& layer, const Exit& exit, const IndexRange& opening, int level);
    void count_on_from_one(const PaintJob& job, const Layer& layer);
    void paint_panes(const PaintJob& job, const Layer& layer, const LayerRanges& ranges, int level);
    void use_layer(const Layer& layer, int level);
    void draw(const IndexRange& range);

    struct Programs {
        std::array<SurfaceProgram, kKinds> surfaces;
        MaskProgram masks;
    };
    std::array<Programs, kVertexPlacings> all_programs_;
    Programs* programs_ = &all_programs_[0];  ///< of this picture
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
    std::size_t draws_ = 0;
};

}  // namespace enfilade::stencil
