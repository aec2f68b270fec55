// A picture laid out by columns while it is drawn, because runs down a column then lie side by side in memory.
#pragma once
#include <cstdint>

#include "render/column/kernels.h"
#include "render/frame.h"

namespace enfilade::column {

/// The columns [begin, end) of a picture, each `height` pixels long, one after another. Each starts on a cache line of
/// its own, and an odd number of lines after the one before, so that rows of neighbouring columns never compete for the
/// same place in the cache.
class Canvas {
public:
    void set(int begin, int end, int height);

    /// Where row 0 of column x is. Row y is y pixels on.
    std::uint32_t* column(int x) { return pixels_.data() + (x - begin_) * pitch_; }
    /// From a column to the next [px].
    std::ptrdiff_t pitch() const { return pitch_; }

    /// Rows [top, bottom) of column x. top <= bottom.
    Run run(int x, int top, int bottom) { return {column(x) + top, top, bottom - top}; }

    /// Copies the columns into a picture by rows. frame has room for them.
    void copy_to(Frame& frame) const;

private:
    int begin_ = 0, end_ = 0, height_ = 0;
    std::ptrdiff_t pitch_ = 0;  ///< whole cache lines [px]
    Pixels pixels_;
};

}  // namespace enfilade::column
