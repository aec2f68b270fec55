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
#pragma once
#include <cstdint>

namespace enfilade {

/// Parts of the way from the middle of a texel to the next one's, or from a picture to a smaller one.
inline constexpr int kBlendBits = 8;
inline constexpr std::uint32_t kBlendParts = 1u << kBlendBits;

}  // namespace enfilade
