// What a pixel shows that stands for more than one place: several texels, several rays, or a texel of a smaller
// picture.
#pragma once
#include <cstdint>
#include <vector>

#include "map/textures.h"
#include "render/frame.h"
#include "render/view.h"

namespace enfilade {

// What it means that a pixel shows several texels (formats/dials.h, Sampling), for all renderers that do so.
//
// A place on a picture, which repeats, lies between the middles of two columns of texels and of two rows. How far it is
// on the way from the first to the second is rounded to the nearest of 1/256. Each of the four texels counts by the
// product of what is left of both ways; the sum is rounded once, channel by channel, the half up. So many of 256 ways
// from one picture to the next smaller one mix the two colours in the same way, rounded once more. All of it is done
// in whole numbers: the same colour on every machine.
//
// Channels are mixed as they are written, as graphics cards do with such pictures, and not in linear light: what is
// mixed is darkened, lit and hidden by fog in the same numbers. Where a picture goes by a color table, its texels are
// mixed after the table has darkened them, for a number between two colours is no colour.
//
// Texels per pixel, by which smaller pictures are chosen: how far texels are apart from one column of the screen to the
// next or from one row to the next, whichever is more, along either side of the picture.
//   wall : depth^2 / (distance of the eye from its line) a column, along it; depth / focal length a row, down it
//   flat : depth times the look to the right a column; depth^2 / (height of the eye over it) / focal length times the
//          look ahead a row; 0 of a floor not below the eye and a ceiling not above it
// A tilted picture is taken for one that is not, with depths along its line of sight.

/// Parts of the way from the middle of a texel to the next one's, or from a picture to a smaller one.
inline constexpr int kBlendBits = 8;
inline constexpr std::uint32_t kBlendParts = 1u << kBlendBits;

// Several rays for each pixel: a picture drawn larger, and made smaller by means of light.

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

// Pictures made smaller by halves, so that a distant texel is about as large as a pixel (Lance Williams, "Pyramidal
// Parametrics", 1983).

/// The smaller pictures of a set. Pictures with holes have none: what is seen through must not come nearer.
class MipChains {
public:
    /// textures: outlive this, and stay as they are. Those that go by the color table get colours of it.
    /// Cost: a look at each texel; a third of their memory.
    explicit MipChains(const TextureSet& textures);

    /// The picture whose sides are 2^level times smaller, each at least 1; the smallest one beyond that.
    /// picture: of the set, or its placeholder, which is its own only level. level: >= 0.
    const Texture& at(const Texture& picture, int level) const;

private:
    const TextureSet& textures_;
    std::vector<std::vector<Texture>> smaller_;  ///< by picture; without the picture itself
};

/// Between two levels.
struct MipPlace {
    int level = 0;           ///< the larger picture's
    std::uint32_t part = 0;  ///< of kBlendParts to the next level, less than that
};

/// Where texels are `texels_per_pixel` apart in neighbouring pixels: at level 0 up to 1; on a straight line from 1 to 2
/// between levels 0 and 1, from 2 to 4 between levels 1 and 2, and so on. Taken in 24 bits, so that round distances,
/// which renderers compute in different ways, fall on the same part.
MipPlace mip_place(double texels_per_pixel);

/// Which level makes texels that are `texels_per_pixel` apart in neighbouring pixels about one apart: 0 up to the
/// square root of 2, then one more for each doubling.
int mip_level(double texels_per_pixel);

}  // namespace enfilade
