// PNG files to pixels and back.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/files.h"
#include "base/result.h"

namespace enfilade {

/// Pixels by row, top row first, 0xAABBGGRR, no padding.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint32_t> pixels;  ///< width * height
};

/// Largest width and height that is read [px].
inline constexpr std::uint32_t kMaxImageSide = 16384;

/// Most pixels that are read: 8192 * 4096 fit; 128 MiB as RGBA.
inline constexpr std::uint64_t kMaxImagePixels = std::uint64_t{1} << 25;

/// What the header of a PNG says about its size, each 1..kMaxImageSide; none where it is no header or says more.
/// Whether the rest is an image is not looked at.
struct ImageSize {
    std::uint32_t width = 0, height = 0;
};
std::optional<ImageSize> png_size(std::span<const std::byte> bytes);

/// Any PNG (grey, palette, 16 bit, …) as 8-bit RGBA. Hostile bytes give an Error without a `where`, and
/// memory is only taken for as many pixels as the bytes can hold.
Result<Image> read_png(std::span<const std::byte> bytes);

/// How much time is spent on making a file small.
enum class PngEffort {
    fast,      ///< a film writes a thousand: four times as fast, a fifth larger
    smallest,  ///< for files that are kept
};

/// The same image always gives the same bytes. width, height >= 1.
Bytes write_png(const Image& image, PngEffort effort = PngEffort::fast);

/// Pixels by row, top row first, as numbers of palette entries, no padding.
struct IndexedImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> pixels;    ///< width * height, each below palette.size()
    std::vector<std::uint32_t> palette;  ///< 1..256 colours 0xAABBGGRR
};

/// The same image always gives the same bytes; a few times smaller and faster than write_png. width, height >= 1.
Bytes write_indexed_png(const IndexedImage& image);

}  // namespace enfilade
