// A picture, and beside it, for those who ask, what each pixel shows.
#pragma once
#include <cstdint>
#include <vector>

#include "render/pixel_surface.h"

namespace enfilade {

/// Texel coordinates in tiles, in [0, 1): position within the picture on that surface.
struct TexelPosition {
    float u = 0;
    float v = 0;
};

/// What each pixel shows; for tests, ids pictures and overlays. All arrays are by row, width * height long.
struct FrameFacts {
    std::vector<PixelSurface> ids;
    std::vector<double> depths;  ///< along `forward` [m]; sky: infinity
    std::vector<TexelPosition> texels;
    std::vector<std::uint8_t> writes;     ///< how often the opaque pass wrote the pixel: 1 everywhere in a sound frame
    std::vector<std::uint8_t> ambiguous;  ///< reference only: 1 where a decision was closer than 1e-7
};

/// width * height pixels by row, row 0 at the top, 0xAABBGGRR (bytes R, G, B, A), no padding.
struct Frame {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
    bool is_cut_short = false;  ///< somewhere a look ended because its budget was spent (render/look_budget.h)

    /// Sets the size and makes room. Pixels keep whatever they were: every renderer writes every one.
    void resize(int new_width, int new_height);
};

/// Makes room and sets everything to "nothing drawn, 0 writes, infinitely far".
void reset(FrameFacts& facts, int width, int height);

/// Of size and pixels: the number goldens record.
std::uint64_t hash_of(const Frame& frame);

}  // namespace enfilade
