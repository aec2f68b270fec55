#include "formats/png.h"

#include <png.h>

#include <array>
#include <cstring>
#include <string>

#include "base/attempt.h"
#include "base/result.h"

namespace enfilade {
namespace {

/// Frees what libpng holds, however the function is left.
struct PngHolder {
    png_image image{};
    PngHolder() { image.version = PNG_IMAGE_VERSION; }
    PngHolder(const PngHolder&) = delete;
    PngHolder& operator=(const PngHolder&) = delete;
    ~PngHolder() { png_image_free(&image); }
};

/// libpng gets memory by itself, and where there is none says so as it says everything else: "Out of memory",
/// "png_image_read: out of memory", "insufficient memory".
void heed_shortage(const png_image& image) {
    for (const char* shortage : {"ut of memory", "ut of Memory", "nsufficient memory"})
        if (std::strstr(image.message, shortage)) out_of_memory();
}

Error not_an_image(const png_image& image) {
    heed_shortage(image);
    return {"", std::string("not a PNG image: ") + image.message};
}

/// The most bytes that deflate makes of one (RFC 1951: 258 from two bits).
constexpr std::uint64_t kMostFromOneByte = 1032;

/// Why the header's size cannot be true, or is more than we want to know.
Result<void> refuse_size(const png_image& image, std::size_t file_bytes) {
    const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    if (image.width > kMaxImageSide || image.height > kMaxImageSide)
        return Error{"", "the image is " + size + "; at most " + std::to_string(kMaxImageSide) + " a side are read"};
    if (pixels > kMaxImagePixels)
        return Error{"", "the image is " + size + "; at most " + std::to_string(kMaxImagePixels) + " in all are read"};
    // A pixel has at least one bit.
    if (pixels / 8 > kMostFromOneByte * file_bytes)
        return Error{"", "not a PNG image: " + size + " are more than a file of this size can hold"};
    return {};
}

/// Into a buffer of the size that no PNG of that shape exceeds: asking libpng for the exact size compresses twice.
Bytes encode(PngHolder& png, const void* pixels, const void* palette) {
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    Bytes bytes(size);
    const int written = png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels, 0, palette);
    if (!written) heed_shortage(png.image);
    ENFILADE_CHECK(written);
    bytes.resize(size);
    return bytes;
}

Result<void> finish(PngHolder& png, void* pixels, void* palette) {
    if (!png_image_finish_read(&png.image, nullptr, pixels, 0, palette)) return not_an_image(png.image);
    if (PNG_IMAGE_FAILED(png.image) || png.image.warning_or_error != 0) return not_an_image(png.image);
    return {};
}

/// A picture with a palette: looking its colours up here takes a third of the time that libpng's own way does.
Result<Image> read_indexed(PngHolder& png) {
    png.image.format = PNG_FORMAT_RGBA_COLORMAP;
    Image image{png.image.width, png.image.height, {}};
    const std::size_t count = std::size_t{image.width} * image.height;
    std::array<std::uint32_t, 256> palette{};
    std::vector<std::uint8_t> numbers(count);
    if (const Result<void> done = finish(png, numbers.data(), palette.data()); !done.ok()) return done.error();
    image.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) image.pixels[i] = palette[numbers[i]];
    return image;
}

/// The signature, and what stands around the data of a chunk: its length and type before it, a sum behind it (PNG
/// specification, §5.2 and §5.3) [bytes].
constexpr std::size_t kSignature = 8, kBeforeData = 8, kSum = 4;

bool has_signature(std::span<const std::byte> bytes) {
    return bytes.size() >= kSignature &&
           png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignature) == 0;
}

/// Where the header has the width; the height follows (PNG specification, §5.2 and §11.2.2) [bytes].
constexpr std::size_t kWidthAt = 16;

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (const std::byte b : bytes.subspan(at, 4)) number = number << 8 | std::to_integer<std::uint32_t>(b);
    return number;
}

/// Whether the header is the first chunk, as it has to be (PNG specification, §5.6); libpng takes it anywhere.
bool begins_with_header(std::span<const std::byte> bytes) {
    constexpr std::uint32_t kHeader = 0x49484452;  // "IHDR"
    return has_signature(bytes) && bytes.size() >= kWidthAt + 8 && big_endian(bytes, kSignature + 4) == kHeader;
}

/// libpng takes as much memory as a chunk says it is long, up to 2 GiB, before it sees that there are no such bytes.
/// Not so of the image's own data, which come last.
Result<void> refuse_long_chunks(std::span<const std::byte> bytes) {
    for (std::size_t at = kSignature; bytes.size() >= at + kBeforeData;) {
        const std::uint32_t length = big_endian(bytes, at), type = big_endian(bytes, at + 4);
        constexpr std::uint32_t kImageData = 0x49444154;  // "IDAT"
        if (type == kImageData) return {};
        if (std::size_t{length} + kSum > bytes.size() - at - kBeforeData)
            return Error{"", "not a PNG image: a chunk of " + std::to_string(length) + " bytes begins at byte " +
                                 std::to_string(at) + ", but the file ends after " + std::to_string(bytes.size())};
        at += kBeforeData + length + kSum;
    }
    return {};
}

}  // namespace

std::optional<ImageSize> png_size(std::span<const std::byte> bytes) {
    if (!begins_with_header(bytes)) return {};
    const ImageSize size{big_endian(bytes, kWidthAt), big_endian(bytes, kWidthAt + 4)};
    const auto is_side = [](std::uint32_t side) { return side >= 1 && side <= kMaxImageSide; };
    return is_side(size.width) && is_side(size.height) ? std::optional(size) : std::nullopt;
}

Result<Image> read_png(std::span<const std::byte> bytes) {
    if (has_signature(bytes) && !begins_with_header(bytes))
        return Error{"", "not a PNG image: expected the header (IHDR) as the first chunk"};
    if (has_signature(bytes))
        if (const Result<void> valid = refuse_long_chunks(bytes); !valid.ok()) return valid.error();
    PngHolder png;
    if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size())) return not_an_image(png.image);
    if (const Result<void> valid = refuse_size(png.image, bytes.size()); !valid.ok()) return valid.error();
    if (png.image.format & PNG_FORMAT_FLAG_COLORMAP) return read_indexed(png);
    png.image.format = PNG_FORMAT_RGBA;
    Image image{png.image.width, png.image.height, {}};
    image.pixels.resize(std::size_t{image.width} * image.height);
    if (const Result<void> done = finish(png, image.pixels.data(), nullptr); !done.ok()) return done.error();
    return image;
}

Bytes write_png(const Image& image, PngEffort effort) {
    PngHolder png;
    png.image.width = image.width;
    png.image.height = image.height;
    png.image.format = PNG_FORMAT_RGBA;
    if (effort == PngEffort::fast) png.image.flags |= PNG_IMAGE_FLAG_FAST;
    return encode(png, image.pixels.data(), nullptr);
}

Bytes write_indexed_png(const IndexedImage& image) {
    PngHolder png;
    png.image.width = image.width;
    png.image.height = image.height;
    png.image.format = PNG_FORMAT_RGBA_COLORMAP;
    png.image.colormap_entries = static_cast<png_uint_32>(image.palette.size());
    return encode(png, image.pixels.data(), image.palette.data());
}

}  // namespace enfilade
