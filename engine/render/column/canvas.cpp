#include "render/column/canvas.h"

#include <algorithm>

namespace enfilade::column {

void Canvas::set(int begin, int end, int height) {
    begin_ = begin;
    end_ = end;
    height_ = height;
    pixels_.resize(static_cast<std::size_t>(end - begin) * static_cast<std::size_t>(height));
}

void Canvas::copy_to(Frame& frame) const {
    // Square blocks, so that lines of both layouts stay in the first-level cache: 16 pixels are one cache line.
    constexpr int kBlock = 16;
    for (int y0 = 0; y0 < height_; y0 += kBlock)
        for (int x0 = begin_; x0 < end_; x0 += kBlock)
            for (int y = y0; y < std::min(y0 + kBlock, height_); ++y) {
                std::uint32_t* row = &frame.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width)];
                for (int x = x0; x < std::min(x0 + kBlock, end_); ++x)
                    row[x] = pixels_[static_cast<std::size_t>(x - begin_) * static_cast<std::size_t>(height_) +
                                     static_cast<std::size_t>(y)];
            }
}

}  // namespace enfilade::column
