#include "render/stencil/layer_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/shade.h"
#include "render/stencil/panorama.h"

namespace enfilade::stencil {
namespace {

/// A horizon that is farther outside the picture than this is not looked for [px].
constexpr double kFarHorizon = 1e6;

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void float_attribute(GLuint index, GLint count, std::size_t at) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), offset(at));
}

void describe_vertices() {
    constexpr std::size_t kParams = offsetof(MeshVertex, params);
    float_attribute(0, 2, offsetof(MeshVertex, x));
    float_attribute(1, 4, kParams + offsetof(PaintParams, from));
    float_attribute(2, 3, kParams + offsetof(PaintParams, span));
    float_attribute(3, 4, kParams + offsetof(PaintParams, nearest));
    float_attribute(4, 4, kParams + offsetof(PaintParams, a));
    float_attribute(5, 4, kParams + offsetof(PaintParams, b));
    float_attribute(6, 4, kParams + offsetof(PaintParams, c));
    glEnableVertexAttribArray(7);
    glVertexAttribIPointer(7, 4, GL_UNSIGNED_INT, sizeof(MeshVertex),
                           offset(kParams + offsetof(PaintParams, id_and_paint)));
    float_attribute(8, 3, kParams + offsetof(PaintParams, left_edge));
    float_attribute(9, 3, kParams + offsetof(PaintParams, right_edge));
}

/// The whole point nearest to the picture's middle where rays are nearly level; straight up or down, the middle.
PixelPoint near_horizon(const RayField& rays) {
    const Even& up = rays.up;
    const double x = rays.is_tilted ? rays.width * 0.5 : 0, y = rays.is_tilted ? rays.height * 0.5 : 0;
    const double steepness = up.per_x * up.per_x + up.per_y * up.per_y, away = up.at(x, y) / steepness;
    if (!(std::fabs(away * std::sqrt(steepness)) < kFarHorizon)) return {std::floor(x), std::floor(y)};
    return {std::floor(x - up.per_x * away), std::floor(y - up.per_y * away)};
}

/// Depths from 0 to `farthest`. Neither call is known to both kinds of OpenGL.
void depth_range(float farthest) {
    if (epoxy_is_desktop_gl())
        glDepthRange(0, static_cast<double>(farthest));
    else
        glDepthRangef(0, farthest);
}

/// Only pixels of this level; what happens to it where depth passes.
void at_level(int level, GLenum then) {
    glStencilFunc(GL_EQUAL, level, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, then);
}

}  // namespace

Result<void> LayerPainter::prepare() {
    vertex_array_.create();
    vertices_.create();
    indices_.create();
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    describe_vertices();
    return {};
}

Result<void> LayerPainter::prepare_for(const Mesh& mesh, VertexPlacing placing) {
    programs_ = &all_programs_[static_cast<std::size_t>(placing)];
    if (programs_->masks.program.id() == 0)
        if (const Result<void> done = build(programs_->masks, placing); !done.ok()) return done.error();
    for (std::size_t kind = 0; kind < kKinds; ++kind)
        if (mesh.has(static_cast<Kind>(kind)) && programs_->surfaces[kind].program.id() == 0)
            if (const Result<void> done = build(programs_->surfaces[kind], static_cast<Kind>(kind), placing);
                !done.ok())
                return done.error();
    return {};
}

void LayerPainter::paint(RenderTarget& target, const DrawInput& scene, const Plan& plan, const Mesh& mesh,
                         const std::vector<LayerRanges>& ranges, const std::vector<SpaceLens>& lenses,
                         bool with_facts) {
    draws_ = 0;
    upload(mesh);
    set_uniforms(scene);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    if (!lenses.empty()) glEnable(GL_CLIP_DISTANCE0);
    paint_layer({target, scene, plan, ranges, lenses, mesh.sheet(), with_facts}, 0, 0);
    if (!lenses.empty()) glDisable(GL_CLIP_DISTANCE0);
    if (!lenses.empty()) glDisable(GL_DEPTH_CLAMP);
}

void LayerPainter::upload(const Mesh& mesh) {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices().size() * sizeof(MeshVertex)), mesh.vertices().data(),
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices().size() * sizeof(std::uint32_t)),
                 mesh.indices().data(), GL_STREAM_DRAW);
}

void LayerPainter::set_uniforms(const DrawInput& scene) const {
    for (const SurfaceProgram& program : programs_->surfaces)
        if (program.program.id() != 0) set_uniforms(program, scene);
    const GLuint textures[] = {scene.store.texture(), scene.records.texture(), scene.store.color_numbers(),
                               scene.store.color_table()};
    for (const GLuint unit : {3u, 2u, 1u, 0u}) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, textures[unit]);
    }
}

void LayerPainter::set_uniforms(const SurfaceProgram& program, const DrawInput& scene) const {
    const RayField& rays = scene.rays;
    const PixelPoint level = near_horizon(rays);
    glUseProgram(program.program.id());
    glUniform2f(program.level, static_cast<float>(level.x), static_cast<float>(level.y));
    glUniform3f(program.climb, static_cast<float>(rays.up.at(level.x, level.y)), static_cast<float>(rays.up.per_x),
                static_cast<float>(rays.up.per_y));
    const std::uint32_t fog = pixel_of(scene.map().render.fog_color);
    const auto channel = [&](int shift) { return static_cast<float>(fog >> shift & 0xFF); };
    glUniform4f(program.fog, channel(0), channel(8), channel(16), static_cast<float>(scene.map().render.fog_reach));
    glUniform1ui(program.fog_step, scene.map().render.fog_step);
    glUniform1i(program.is_sky_round, sky_rows(scene.map().render, rays.is_tilted) == SkyRows::round);
    glUniform1i(program.texels, 0);
    glUniform1i(program.records, 1);
    glUniform1i(program.color_numbers, 2);
    glUniform1i(program.color_table, 3);
}

void LayerPainter::set_entry(const SurfaceProgram& program, const PaintJob& job, const Layer& layer) {
    const WallOnScreen& doorway = layer.opened;
    const double x = (doorway.begin + doorway.end) / 2, y = 0;
    const Even there = span(job.scene.rays, doorway);
    glUniform3f(program.entry, layer.entry ? static_cast<float>(depth_factor(doorway)) : 0.0f, static_cast<float>(x),
                static_cast<float>(y));
    glUniform3f(program.entry_span, static_cast<float>(there.at(x, y)), static_cast<float>(there.per_x),
                static_cast<float>(there.per_y));
}

void LayerPainter::paint_layer(const PaintJob& job, std::size_t index, int level) {
    const Layer& layer = job.plan.layers[index];
    const LayerRanges& ranges = job.ranges[index];
    use_layer(layer, level);
    job.target.write_all();
    glDepthFunc(GL_GREATER);
    paint_surfaces(job, layer, ranges);
    look_through(job, layer, ranges, level);
    if (!ranges.panes.range.is_empty()) paint_panes(job, layer, ranges, level);
}

void LayerPainter::paint_surfaces(const PaintJob& job, const Layer& layer, const LayerRanges& ranges) {
    for (const auto& [kind, range] : ranges.surfaces) {
        const SurfaceProgram& program = programs_->surfaces[kind];
        glUseProgram(program.program.id());
        set_entry(program, job, layer);
        use_lens(program.lens, job, layer);
        draw(range);
    }
}

void LayerPainter::use_layer(const Layer& layer, int level) {
    const ScreenBox& box = layer.box;
    glScissor(box.begin_x, box.begin_y, box.end_x - box.begin_x, box.end_y - box.begin_y);
    glDepthMask(GL_TRUE);
    at_level(level, GL_KEEP);
}

void LayerPainter::use_lens(const LensUniforms& uniforms, const PaintJob& job, const Layer& layer) {
    if (job.lenses.empty()) return;
    const SpaceLens& lens = job.lenses[static_cast<std::size_t>(&layer - job.plan.layers.data())];
    glUniform4fv(uniforms.picture, 1, lens.picture.data());
    glUniform4fv(uniforms.depth_row, 1, lens.depth_row.data());
    glUniform4fv(uniforms.clip, 1, lens.clip.data());
    if (lens.clips_at_near_plane)
        glDisable(GL_DEPTH_CLAMP);
    else
        glEnable(GL_DEPTH_CLAMP);
}

/// is_far: behind everything, instead of where the portal is.
void LayerPainter::use_masks(const PaintJob& job, const Layer& layer, bool is_far) const {
    glUseProgram(programs_->masks.program.id());
    use_lens(programs_->masks.lens, job, layer);
    if (!job.lenses.empty()) glEnable(GL_DEPTH_CLAMP);  // whoever is nearer to a portal than the near plane sees it
    depth_range(is_far ? 0 : 1);
}

void LayerPainter::look_through(const PaintJob& job, const Layer& layer, const LayerRanges& ranges, int level) {
    const auto is_followed = [](const Exit& exit) { return exit.layer != Exit::kCut; };
    const bool is_deepest = level == kDeepestLevel && std::any_of(layer.exits.begin(), layer.exits.end(), is_followed);
    if (is_deepest) count_on_from_one(job, layer);
    for (std::size_t i = 0; i < layer.exits.size(); ++i)
        if (is_followed(layer.exits[i]))
            look_through(job, layer, layer.exits[i], ranges.exits[i], is_deepest ? 1 : level);
    if (is_deepest) job.target.bring_back_levels();
}

void LayerPainter::count_on_from_one(const PaintJob& job, const Layer& layer) {
    job.target.keep_levels();
    use_layer(layer, kDeepestLevel);
    use_masks(job, job.plan.layers.front(), false);  // which nothing is cut off from
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_NOTEQUAL, kDeepestLevel, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    draw(job.sheet);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    glStencilMask(0xFE);  // of all ones only the last is left
    draw(job.sheet);
    glStencilMask(0xFF);
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void LayerPainter::look_through(const PaintJob& job, const Layer& layer, const Exit& exit, const IndexRange& opening,
                                int level) {
    use_layer(layer, level);
    use_masks(job, layer, false);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    // Mark: what of the portal is not hidden rises by one level.
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);
    at_level(level, GL_INCR);
    draw(opening);
    // Reset: behind it nothing is drawn yet.
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    at_level(level + 1, GL_KEEP);
    use_masks(job, layer, true);
    draw(opening);
    use_masks(job, layer, false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    paint_layer(job, exit.layer, level + 1);
    // Restore: the portal's own depth, and the level it had.
    use_layer(layer, level);
    use_masks(job, layer, false);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_ALWAYS);
    at_level(level + 1, GL_DECR);
    draw(opening);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void LayerPainter::paint_panes(const PaintJob& job, const Layer& layer, const LayerRanges& ranges, int level) {
    use_layer(layer, level);
    const SurfaceProgram& program = programs_->surfaces[ranges.panes.kind];
    glUseProgram(program.program.id());
    use_lens(program.lens, job, layer);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    // In space, what hangs on a wall is brought before it by a slope and a step, as is usual.
    if (!job.lenses.empty()) glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
    // Facts first, of what hides more than half of what is behind; then colours, mixed.
    if (job.with_facts) {
        job.target.write_facts();
        glUniform1ui(program.least_alpha, kSolidAlpha);
        draw(ranges.panes.range);
    }
    job.target.write_color();
    glUniform1ui(program.least_alpha, 1);
    glEnable(GL_BLEND);
    draw(ranges.panes.range);
    glDisable(GL_BLEND);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void LayerPainter::draw(const IndexRange& range) {
    if (range.is_empty()) return;
    ++draws_;
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.end - range.begin), GL_UNSIGNED_INT,
                   offset(range.begin * sizeof(std::uint32_t)));
}

}  // namespace enfilade::stencil
