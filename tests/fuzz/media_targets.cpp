// Pictures, sounds and Doom's archives.
#include <zlib.h>

#include <cmath>

#include "formats/png.h"
#include "fuzz/targets.h"
#include "platform/audio.h"
#include "wadconv/digest.h"
#include "wadconv/wad_builder.h"

namespace enfilade::test {
namespace {

constexpr std::size_t kSignature = 8, kBeforeData = 8, kSum = 4;  // of a PNG and of its chunks [bytes]

std::uint32_t big_endian(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (const std::byte b : bytes.first(4)) value = value << 8 | std::to_integer<std::uint32_t>(b);
    return value;
}

/// With the sum that each chunk ought to have, without which a PNG is refused before anything is unpacked.
Bytes with_right_sums(Bytes png) {
    std::size_t at = kSignature;
    while (at + kBeforeData + kSum <= png.size()) {
        const std::uint32_t length = big_endian(std::span(png).subspan(at));
        if (length > png.size() - at - kBeforeData - kSum) break;
        const auto* type = reinterpret_cast<const unsigned char*>(png.data() + at + 4);
        auto sum = static_cast<std::uint32_t>(::crc32(0, type, length + 4));
        at += kBeforeData + length + kSum;
        for (std::size_t i = 1; i <= kSum; ++i, sum >>= 8) png[at - i] = static_cast<std::byte>(sum);
    }
    return png;
}

void read_as_png(std::span<const std::byte> bytes) {
    const auto size = png_size(bytes);
    const auto image = read_png(bytes);
    if (!image.ok()) return;
    ENFILADE_CHECK(size && size->width == image.value().width && size->height == image.value().height);
    const auto again = read_png(write_png(image.value()));
    ENFILADE_CHECK(again.ok() && again.value().pixels == image.value().pixels);
}

}  // namespace

void fuzz_png(std::span<const std::byte> bytes) {
    read_as_png(bytes);
    read_as_png(with_right_sums({bytes.begin(), bytes.end()}));
}

void fuzz_wav(std::span<const std::byte> bytes) {
    const auto samples = read_wav(bytes);
    if (!samples.ok()) return;
    for (const float sample : samples.value()) ENFILADE_CHECK(std::fabs(sample) <= 1);
}

void fuzz_wad(std::span<const std::byte> bytes) {
    static const Bytes game = wadconv::test::picture_wad().finish();
    const Bytes archive(bytes.begin(), bytes.end());
    ENFILADE_CHECK(wadconv::test::digest({archive}).has_all_sides);
    ENFILADE_CHECK(wadconv::test::digest({game, archive}).has_all_sides);
}

}  // namespace enfilade::test
