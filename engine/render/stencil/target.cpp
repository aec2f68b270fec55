#include "render/stencil/layer_painter.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

namespace enfilade::stencil {
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
