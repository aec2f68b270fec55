// Draws the layers of a frame into one another.
//
// The method of the recursive stencil papers (METHODS of Eccohedra and others), made robust: a layer is drawn where the
// stencil buffer holds its level. For each of its exits, nearest first: the portal's visible pixels are raised by one
// level, their depth is reset, the layer behind is drawn there, and then the portal's own depth is put back and the
// pixels are lowered again. So every pixel ends at the level it had, and what is drawn later, like a window's glass,
// finds the portal where it is.
#pragma once
#include <array>

#include "render/stencil/layer_mesh.h"
#include "render/stencil/shaders.h"
#include "render/stencil/target.h"

namespace enfilade::stencil {

class LayerPainter {
public:
    /// For the current context.
    Status prepare();

    /// Compiles the programs that the mesh needs and no frame before needed.
    Status prepare_for(const Mesh& mesh);

    /// Draws all layers into the target, which is prepared and cleared. Everything was prepared, records uploaded.
    void paint(const Target& target, const Scene& scene, const Plan& plan, const Mesh& mesh,
               const std::vector<LayerRanges>& ranges, bool with_facts);

    std::size_t draws() const { return draws_; }

private:
    struct Job {
        const Target& target;
        const Scene& scene;
        const Plan& plan;
        const std::vector<LayerRanges>& ranges;
        bool with_facts;
    };

    void upload(const Mesh& mesh);
    void set_uniforms(const Scene& scene) const;
    void set_uniforms(const SurfaceProgram& program, const Scene& scene) const;
    void paint_surfaces(const Job& job, const Layer& layer, const LayerRanges& ranges);
    void set_entry(const SurfaceProgram& program, const Job& job, const Layer& layer);
    void paint_layer(const Job& job, std::size_t index);
    void look_through(const Job& job, const Layer& layer, const Exit& exit, const Range& opening);
    void paint_panes(const Job& job, const Layer& layer, const LayerRanges& ranges);
    void use_layer(const Layer& layer);
    void draw(const Range& range);

    std::array<SurfaceProgram, kKinds> surfaces_;
    MaskProgram masks_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_, indices_;
    std::size_t draws_ = 0;
};

}  // namespace enfilade::stencil
