#include "render/stencil/layer_painter.h"

#include <cmath>
#include <cstddef>

#include "render/shade.h"

namespace enfilade::stencil {
namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void float_attribute(GLuint index, GLint count, std::size_t at) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(at));
}

void describe_vertices() {
    constexpr std::size_t kLook = offsetof(Vertex, look);
    float_attribute(0, 2, offsetof(Vertex, x));
    float_attribute(1, 4, kLook + offsetof(Look, from_px));
    float_attribute(2, 4, kLook + offsetof(Look, nearest));
    float_attribute(3, 4, kLook + offsetof(Look, a));
    float_attribute(4, 4, kLook + offsetof(Look, b));
    glEnableVertexAttribArray(5);
    glVertexAttribIPointer(5, 4, GL_UNSIGNED_INT, sizeof(Vertex), offset(kLook + offsetof(Look, id_and_paint)));
}

/// Only pixels of this level; what happens to it where depth passes.
void at_level(int level, GLenum then) {
    glStencilFunc(GL_EQUAL, level, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, then);
}

}  // namespace

Status LayerPainter::prepare() {
    if (Status failed = build(surfaces_, masks_)) return failed;
    vertex_array_.create();
    vertices_.create();
    indices_.create();
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    describe_vertices();
    return {};
}

void LayerPainter::paint(const Target& target, const Scene& scene, const Plan& plan, const Mesh& mesh,
                         const std::vector<LayerRanges>& ranges, bool with_facts) {
    draws_ = 0;
    upload(mesh);
    set_uniforms(scene);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    paint_layer({target, scene.screen, plan, ranges, with_facts}, 0);
}

void LayerPainter::upload(const Mesh& mesh) {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices().size() * sizeof(Vertex)), mesh.vertices().data(),
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices().size() * sizeof(std::uint32_t)),
                 mesh.indices().data(), GL_STREAM_DRAW);
}

void LayerPainter::set_uniforms(const Scene& scene) {
    const double whole = std::floor(scene.screen.horizon);
    glUseProgram(surfaces_.program.id());
    glUniform2f(surfaces_.horizon, static_cast<float>(whole), static_cast<float>(scene.screen.horizon - whole));
    glUniform1f(surfaces_.per_focal, static_cast<float>(1 / scene.screen.focal_y));
    glUniform1i(surfaces_.is_classic, scene.map.render.light == LightModel::classic);
    glUniform1i(surfaces_.texels, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, scene.store.texture());
}

/// slope * forward - right: on which side of it a vertex lies exactly on the ray counts (see column_of()).
void LayerPainter::set_normal(GLint uniform, const Job& job, const Eye& eye) const {
    const Vec2 at_0 = eye.forward * job.screen.slope_at(0) - eye.right;
    const Vec2 per_px = eye.forward * job.screen.slope_per_px;
    glUniform4f(uniform, static_cast<float>(at_0.x), static_cast<float>(at_0.y), static_cast<float>(per_px.x),
                static_cast<float>(per_px.y));
}

void LayerPainter::paint_layer(const Job& job, std::size_t index) {
    const Layer& layer = job.plan.layers[index];
    const LayerRanges& ranges = job.ranges[index];
    use_layer(layer);
    job.target.write_all();
    glUseProgram(surfaces_.program.id());
    set_normal(surfaces_.normal, job, layer.eye);
    glUniform1ui(surfaces_.least_alpha, 0);
    glDepthFunc(GL_GREATER);
    draw(ranges.surfaces);
    for (std::size_t i = 0; i < layer.exits.size(); ++i)
        if (layer.exits[i].layer != Exit::kCut) look_through(job, layer, layer.exits[i], ranges.exits[i]);
    if (!ranges.panes.empty()) paint_panes(job, layer, ranges);
}

void LayerPainter::use_layer(const Layer& layer) {
    const Box& box = layer.box;
    glScissor(box.begin_x, box.begin_y, box.end_x - box.begin_x, box.end_y - box.begin_y);
    glDepthMask(GL_TRUE);
    at_level(layer.level, GL_KEEP);
}

void LayerPainter::look_through(const Job& job, const Layer& layer, const Exit& exit, const Range& opening) {
    use_layer(layer);
    glUseProgram(masks_.program.id());
    set_normal(masks_.normal, job, layer.eye);
    glUniform1i(masks_.is_far, 0);  // the level above is at its own reset
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    // Mark: what of the portal is not hidden rises by one level.
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);
    at_level(layer.level, GL_INCR);
    draw(opening);
    // Reset: behind it nothing is drawn yet.
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    at_level(layer.level + 1, GL_KEEP);
    glUniform1i(masks_.is_far, 1);
    draw(opening);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    paint_layer(job, exit.layer);
    // Restore: the portal's own depth, and the level it had.
    use_layer(layer);
    glUseProgram(masks_.program.id());
    set_normal(masks_.normal, job, layer.eye);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    at_level(layer.level + 1, GL_DECR);
    glUniform1i(masks_.is_far, 0);
    draw(opening);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// Facts first, of those that hide more than half of what is behind; then colours, mixed.
void LayerPainter::paint_panes(const Job& job, const Layer& layer, const LayerRanges& ranges) {
    use_layer(layer);
    glUseProgram(surfaces_.program.id());
    set_normal(surfaces_.normal, job, layer.eye);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    if (job.with_facts) {
        job.target.write_facts();
        glUniform1ui(surfaces_.least_alpha, kSolidAlpha);
        for (const Range& pane : ranges.panes) draw(pane);
    }
    job.target.write_color();
    glUniform1ui(surfaces_.least_alpha, 1);
    glEnable(GL_BLEND);
    for (const Range& pane : ranges.panes) draw(pane);
    glDisable(GL_BLEND);
}

void LayerPainter::draw(const Range& range) {
    if (range.is_empty()) return;
    ++draws_;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.end - range.begin), GL_UNSIGNED_INT,
                   offset(range.begin * sizeof(std::uint32_t)));
}

}  // namespace enfilade::stencil
