// The inner loops where a pixel shows several texels (render/sampling.h): what stands in for fill_walls and
// fill_flats of kernels.h then, pixel by pixel, and as far away as one likes.
#pragma once
#include <cstdint>
#include <functional>

#include "formats/dials.h"
#include "render/column/kernels.h"
#include "render/frame.h"
#include "render/sampling.h"

namespace enfilade::column {

/// Two neighbouring columns or rows of texels of a picture that repeats.
struct TexelPair {
    std::uint32_t first, second;  ///< below the picture's side
    std::uint32_t part;           ///< of kBlendParts from the first's middle to the second's, less than that
};

/// Those whose middles a place lies between. size_px: of the picture along this side, < 2^31.
inline TexelPair texels_around(TilePlace place, std::uint32_t size_px) {
    constexpr int kPlaceBits = 32;
    constexpr std::uint64_t kHalfTexel = std::uint64_t{1} << (kPlaceBits - 1), kHalfPart = kHalfTexel >> kBlendBits;
    const std::uint64_t whole = std::uint64_t{size_px} << kPlaceBits;
    std::uint64_t at = std::uint64_t{place} * size_px + whole - kHalfTexel + kHalfPart;
    at -= at >= whole ? whole : 0;
    const auto first = static_cast<std::uint32_t>(at >> kPlaceBits);
    return {first, first + 1 == size_px ? 0 : first + 1,
            static_cast<std::uint32_t>(at >> (kPlaceBits - kBlendBits)) & (kBlendParts - 1)};
}

/// Four texels 0xAABBGGRR, two down the first column and two down the second; only their colours count.
struct FourTexels {
    std::uint32_t upper_left, lower_left, upper_right, lower_right;
};

/// Their mean by how near they are. across, down: of kBlendParts. Opaque.
std::uint32_t blended(const FourTexels& texels, std::uint32_t across, std::uint32_t down);

/// Between two colours, `part` of kBlendParts of the way. Opaque.
std::uint32_t mixed(std::uint32_t color, std::uint32_t next, std::uint32_t part);

/// How texels of some columns of a wall are blended.
struct WallBlend {
    const TilePlace* u;          ///< of each column [count]
    const Texture* smaller;      ///< the next smaller picture; null: there is none to mix with
    const std::uint32_t* parts;  ///< of the way to it, of each column [count]; where there is one
};

/// As PlainKernels::fill_walls; first_texels do not count.
void fill_blended_walls(const PlainWalls& walls, const WallBlend& blend);

/// How texels of a flat are blended.
struct FlatBlend {
    const Texture* smaller;          ///< as of walls
    const std::uint32_t* row_parts;  ///< by row
};

/// As PlainKernels::fill_flats, with positions in these numbers, which are not vanilla's, and however far.
void fill_blended_flats(NumberKind number, const PlainFlats& flats, const FlatBlend& blend);

/// The same where places on the picture are position(i, y) of the i-th column and row y.
void fill_blended_flats_at(const PlainFlats& flats, const FlatBlend& blend,
                           const std::function<TexelPosition(int i, int y)>& position);

}  // namespace enfilade::column
