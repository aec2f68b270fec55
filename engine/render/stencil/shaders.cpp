// The programs of the graphics card, put together and compiled, and what they draw into.
#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "render/stencil/layer_painter.h"

namespace enfilade::stencil {
namespace {

const char* preamble() {
    return epoxy_is_desktop_gl() ? "#version 330 core\n"
                                 : "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                                   "precision highp usampler2D;\n";
}

Error driver_says(const std::string& log) {
    return {"stencil renderer", "the graphics driver refuses a shader: " + log};
}

Result<void> compile(GLuint program, GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const std::string whole = preamble() + text;
    const char* source = whole.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // it lives as long as the program
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done != 0) return {};
    char log[1024] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    return driver_says(log);
}

/// parts: what both shaders are to have.
Result<void> link(GlProgram& program, const std::string& parts, const std::string& fragment_shader) {
    program.create();
    if (const Result<void> done = compile(program.id(), GL_VERTEX_SHADER, parts + kVertexShader); !done.ok())
        return done.error();
    if (const Result<void> done = compile(program.id(), GL_FRAGMENT_SHADER, parts + kWallDepth + fragment_shader);
        !done.ok())
        return done.error();
    glLinkProgram(program.id());
    GLint done = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &done);
    if (done != 0) return {};
    char log[1024] = "";
    glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
    return driver_says(log);
}

GLint uniform(const GlProgram& program, const char* name) { return glGetUniformLocation(program.id(), name); }

std::string part(const std::string& name) { return "#define " + name + "\n"; }

std::string parts_of(Kind kind) {
    constexpr const char* kPaints[] = {"WALLS", "FLATS", "SKIES", "COLORS"};
    std::string parts = part(kPaints[paints(kind)]);
    if (kind & kWithRecords) parts += part("WITH_RECORDS") + part(paints(kind) == kSkies ? "LAYERED_SKY" : "LIT");
    if (kind & kWithLayers) parts += part("LAYERED_FLAT");
    if (kind & (kGoingByTable | kWithLayers)) parts += part("BY_TABLE");
    if (kind & kInSmoothLight) parts += part("SMOOTH");
    if (kind & kInClassicLight) parts += part("CLASSIC");
    if (kind & kWithHoles) parts += part("WITH_HOLES");
    return parts;
}

std::string parts_of(VertexPlacing placing) {
    return placing == VertexPlacing::tilted     ? part("TILTED")
           : placing == VertexPlacing::in_space ? part("IN_SPACE")
                                                : "";
}

LensUniforms lens_uniforms(const GlProgram& program) {
    return {uniform(program, "lens"), uniform(program, "depth_row"), uniform(program, "clip")};
}

}  // namespace

Result<void> build(SurfaceProgram& surface, Kind kind, VertexPlacing placing) {
    if (const Result<void> done = link(surface.program, parts_of(placing) + parts_of(kind), kSurfaceShader); !done.ok())
        return done.error();
    surface.entry = uniform(surface.program, "entry");
    surface.entry_span = uniform(surface.program, "entry_span");
    surface.level = uniform(surface.program, "level");
    surface.climb = uniform(surface.program, "climb");
    surface.is_sky_round = uniform(surface.program, "is_sky_round");
    surface.fog = uniform(surface.program, "fog");
    surface.fog_step = uniform(surface.program, "fog_step");
    surface.least_alpha = uniform(surface.program, "least_alpha");
    surface.texels = uniform(surface.program, "texels");
    surface.records = uniform(surface.program, "records");
    surface.color_numbers = uniform(surface.program, "color_numbers");
    surface.color_table = uniform(surface.program, "color_table");
    surface.lens = lens_uniforms(surface.program);
    return {};
}

Result<void> build(MaskProgram& mask, VertexPlacing placing) {
    if (const Result<void> done = link(mask.program, parts_of(placing), kMaskShader); !done.ok()) return done.error();
    mask.lens = lens_uniforms(mask.program);
    return {};
}

// What is drawn into.

namespace {

constexpr GLenum kColor = GL_COLOR_ATTACHMENT0, kFacts = GL_COLOR_ATTACHMENT1;

void give_storage(GlRenderbuffer& buffer, GLenum format, int width, int height, GLenum attachment) {
    buffer.create();
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
}

Result<void> no_buffers(int width, int height) {
    return Error{"stencil renderer",
                 "expected a picture with 8 bits of stencil and a depth buffer; this graphics card or its driver has "
                 "none of " +
                     std::to_string(width) + "x" + std::to_string(height) + " pixels"};
}

void write_to(GLenum first, GLenum second) {
    const GLenum buffers[] = {first, second};
    glDrawBuffers(2, buffers);
}

}  // namespace

void RenderTarget::use_24_bits_of_depth() { depth_format_ = GL_DEPTH24_STENCIL8; }

Result<void> RenderTarget::prepare(int width, int height, bool with_facts, std::size_t kept) {
    framebuffer_.create();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    if (width != width_ || height != height_ || (with_facts && !with_facts_))
        if (const Result<void> done = make(width, height, with_facts); !done.ok()) return done.error();
    while (kept_.size() < kept)
        if (const Result<void> done = make_kept(); !done.ok()) return done.error();
    kept_now_ = 0;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width, height);
    return {};
}

Result<void> RenderTarget::make(int width, int height, bool with_facts) {
    width_ = height_ = 0;  // until it is made
    kept_.clear();
    GLint most = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    if (std::max(width, height) > most)
        return Error{"stencil renderer", "expected a picture of at most " + std::to_string(most) +
                                             " pixels a side, which is what this graphics card can draw; found " +
                                             std::to_string(width) + "x" + std::to_string(height)};
    give_storage(color_, GL_RGBA8, width, height, kColor);
    give_storage(depth_stencil_, depth_format_, width, height, GL_DEPTH_STENCIL_ATTACHMENT);
    if (with_facts) give_storage(facts_, GL_RGBA32UI, width, height, kFacts);
    if (!with_facts) glFramebufferRenderbuffer(GL_FRAMEBUFFER, kFacts, GL_RENDERBUFFER, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return no_buffers(width, height);
    width_ = width;
    height_ = height;
    with_facts_ = with_facts;
    return {};
}

Result<void> RenderTarget::make_kept() {
    KeptLevels& kept = kept_.emplace_back();
    kept.framebuffer.create();
    glBindFramebuffer(GL_FRAMEBUFFER, kept.framebuffer.id());
    give_storage(kept.depth_stencil, depth_format_, width_, height_, GL_DEPTH_STENCIL_ATTACHMENT);
    write_to(GL_NONE, GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return {};
    kept_.pop_back();
    return no_buffers(width_, height_);
}

void RenderTarget::keep_levels() { copy_levels(framebuffer_, kept_[kept_now_++].framebuffer); }
void RenderTarget::bring_back_levels() { copy_levels(kept_[--kept_now_].framebuffer, framebuffer_); }

void RenderTarget::copy_levels(const GlFramebuffer& from, const GlFramebuffer& to) const {
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glEnable(GL_SCISSOR_TEST);
}

void RenderTarget::clear() {
    const GLfloat black[] = {0, 0, 0, 1};
    const GLuint nothing[] = {kNothing, 0, 0, 0};
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glStencilMask(0xFF);
    write_all();
    glClearBufferfv(GL_COLOR, 0, black);
    if (with_facts_) glClearBufferuiv(GL_COLOR, 1, nothing);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 0, 0);
}

void RenderTarget::write_all() const { write_to(kColor, with_facts_ ? kFacts : GL_NONE); }
void RenderTarget::write_color() const { write_to(kColor, GL_NONE); }
void RenderTarget::write_facts() const { write_to(GL_NONE, with_facts_ ? kFacts : GL_NONE); }

void RenderTarget::read(Frame& frame) const {
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadBuffer(kColor);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, frame.pixels.data());
}

void RenderTarget::read(FrameFacts& facts) const {
    struct Fact {
        std::uint32_t id, depth, u, v;
    };
    std::vector<Fact> all(facts.ids.size());
    glReadBuffer(kFacts);
    glReadPixels(0, 0, width_, height_, GL_RGBA_INTEGER, GL_UNSIGNED_INT, all.data());
    for (std::size_t i = 0; i < all.size(); ++i) {
        facts.ids[i] = all[i].id;
        facts.depths[i] = static_cast<double>(std::bit_cast<float>(all[i].depth));
        facts.texels[i] = {std::bit_cast<float>(all[i].u), std::bit_cast<float>(all[i].v)};
        facts.writes[i] = all[i].id != kNothing;
    }
}

}  // namespace enfilade::stencil
