// What is drawn into: colours, facts, depth and stencil, away from any window.
#pragma once
#include <deque>

#include "base/result.h"
#include "render/frame.h"
#include "render/stencil/gl_object.h"

namespace enfilade::stencil {

/// A framebuffer with 8-bit colours, 8 bits of stencil, depth as a float and, where they are wanted, facts.
class RenderTarget {
public:
    /// Makes it fit the picture and binds it, with room to keep the levels aside that often.
    /// An error where the graphics card has no such buffers.
    Status prepare(int width, int height, bool with_facts, std::size_t kept = 0);

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

private:
    /// A stencil buffer aside; its depth is not used, but levels can only be copied between buffers of one format.
    struct KeptLevels {
        GlFramebuffer framebuffer;
        GlRenderbuffer depth_stencil;
    };

    Status make(int width, int height, bool with_facts);
    Status make_kept();
    void copy_levels(const GlFramebuffer& from, const GlFramebuffer& to) const;

    GlFramebuffer framebuffer_;
    GlRenderbuffer color_, facts_, depth_stencil_;
    std::deque<KeptLevels> kept_;
    std::size_t kept_now_ = 0;  ///< how many of them hold levels
    int width_ = 0, height_ = 0;
    bool with_facts_ = false;
};

}  // namespace enfilade::stencil
