// Several rays for each pixel: a picture drawn larger, and made smaller by means of light.
#pragma once
#include <cstdint>

#include "render/frame.h"
#include "render/view.h"

namespace enfilade {

/// The mean of colours as an eye mixes them, in linear light (IEC 61966-2-1, "sRGB"). Whole numbers: the same mean on
/// every machine, and in whatever order colours are added.
class LightMean {
public:
    /// At most 2^14 of them.
    void add(std::uint32_t color);

    /// count: of the colours added, >= 1. Opaque.
    std::uint32_t color(std::uint32_t count) const;

private:
    std::uint32_t red_ = 0, green_ = 0, blue_ = 0;
};

/// The view of a picture `samples` times as wide and as high, whose pixels are the parts of the pixels of this one's.
View finer(View view, int samples);

/// Gives each pixel the mean of those that it covers of a picture that is `samples` times as wide and as high. frame:
/// its size is set. Cost: a look at each pixel of the larger picture.
void take_means(const Frame& fine, int samples, Frame& frame);

}  // namespace enfilade
