// What is drawn into: colours, facts, depth and stencil, away from any window.
#pragma once
#include "base/result.h"
#include "render/frame.h"
#include "render/stencil/gl_object.h"

namespace enfilade::stencil {

/// A framebuffer with 8-bit colours, 8 bits of stencil, depth as a float and, where they are wanted, facts.
class Target {
public:
    /// Makes it fit the picture and binds it. An error where the graphics card has no such buffers.
    Status prepare(int width, int height, bool with_facts);

    /// Sets all pixels to "nothing drawn, infinitely far, level 0".
    void clear();

    /// Which outputs are written from now on.
    void write_all() const;
    void write_color() const;
    void write_facts() const;

    /// Copies the picture out; facts only where they were wanted. writes is 1 where something was drawn.
    void read(Frame& frame) const;
    void read(FrameFacts& facts) const;

private:
    Status make(int width, int height, bool with_facts);

    GlFramebuffer framebuffer_;
    GlRenderbuffer color_, facts_, depth_stencil_;
    int width_ = 0, height_ = 0;
    bool with_facts_ = false;
};

}  // namespace enfilade::stencil
