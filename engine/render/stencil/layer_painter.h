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
#include "render/stencil/mesh.h"
#include "render/stencil/surfaces.h"

namespace enfilade::stencil {

// The programs of the graphics card.

/// How the vertices of a picture's polygons are put into it.
enum class VertexPlacing : std::uint8_t {
    upright,   ///< they are where they are drawn
    tilted,    ///< the same, and each pixel asks which wall it shows
    in_space,  ///< they are in space (in_space.cpp)
};
inline constexpr std::size_t kVertexPlacings = 3;

/// Where points in space are told how they are placed (SpaceLens).
struct LensUniforms {
    GLint picture = -1, depth_row = -1, clip = -1;
};

/// Draws surfaces: colours to output 0, facts (id, depth, texel) to output 1.
struct SurfaceProgram {
    GlProgram program;
    GLint entry = -1, entry_span = -1;  ///< of the layer: the doorway one looks in through, see shaders.cpp
    GLint level = -1;                   ///< a point at or near the horizon [px]
    GLint climb = -1;                   ///< what the ray climbs there, per column, per row
    GLint is_sky_round = -1;            ///< its rows are
    GLint fog = -1;                     ///< its colour and reach
    GLint fog_step = -1;                ///< by which it grows
    GLint least_alpha = -1;             ///< with holes: pixels of a picture with less are left out, 1..255
    GLint texels = -1;
    GLint records = -1;                          ///< where there is more to know than PaintParams
    GLint color_numbers = -1, color_table = -1;  ///< where pictures may go by one
    LensUniforms lens;
};

/// Draws only depth: for masks.
struct MaskProgram {
    GlProgram program;
    LensUniforms lens;
};

/// Compile them for the current context. An error says what the driver said.
Result<void> build(SurfaceProgram& surface, Kind kind, VertexPlacing placing);
Result<void> build(MaskProgram& mask, VertexPlacing placing);

// What the graphics card is told to do, in OpenGL's shading language; put together by shaders.cpp.
//
// A program has the parts that were defined for it, and nothing else: TILTED pictures, or polygons IN_SPACE; surfaces
// that are WALLS, FLATS, SKIES or COLORS, in SMOOTH or CLASSIC light or either, LIT by lamps, BY_TABLE of colours,
// WITH_HOLES; LAYERED_SKY; WITH_RECORDS where LIT or LAYERED_SKY.

extern const char* const kVertexShader;

/// What the shaders of surfaces and of masks begin with.
extern const char* const kWallDepth;

extern const char* const kSurfaceShader;
extern const char* const kMaskShader;

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

// The painter.

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
