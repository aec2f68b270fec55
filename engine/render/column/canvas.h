// A picture laid out by columns while it is drawn, because runs down a column then lie side by side in memory.
#pragma once
#include <cstdint>
#include <vector>

#include "render/column/kernels.h"
#include "render/frame.h"

namespace enfilade::column {

/// The columns [begin, end) of a picture, each `height` pixels long, one after another.
class Canvas {
public:
    void set(int begin, int end, int height);

    /// Rows [top, bottom) of column x. top <= bottom.
    Run run(int x, int top, int bottom) {
        return {&pixels_[static_cast<std::size_t>(x - begin_) * static_cast<std::size_t>(height_) +
                         static_cast<std::size_t>(top)],
                top, bottom - top};
    }

    /// Copies the columns into a picture by rows. frame has room for them.
    void copy_to(Frame& frame) const;

private:
    int begin_ = 0, end_ = 0, height_ = 0;
    std::vector<std::uint32_t> pixels_;
};

}  // namespace enfilade::column
