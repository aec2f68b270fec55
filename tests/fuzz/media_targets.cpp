// Pictures, sounds and Doom's archives.
#include <zlib.h>

#include <cmath>

#include "app/sounds.h"
#include "formats/png.h"
#include "fuzz/targets.h"
#include "map/textures.h"
#include "platform/audio.h"
#include "support/map_builder.h"
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

namespace {

/// As a map loads its pictures: on a wall, and as its table of colours.
void load_as_pictures(std::span<const std::byte> bytes) {
    static const MapFile file = [] {
        MapFile made = map_of({box_room("room", 0, 0, 8, 4)});
        made.render.color_table = "table";
        return made;
    }();
    const auto read = [&](const std::string& path) -> Result<Bytes> {
        if (!path.ends_with("table.png") && !path.ends_with("wall.png")) return Error{path, "there is none"};
        return Bytes(bytes.begin(), bytes.end());
    };
    Findings findings;
    const TextureSet pictures = load_textures(file, {"textures"}, read, findings);
    ENFILADE_CHECK(!pictures.textures.empty());
}

}  // namespace

void fuzz_png(std::span<const std::byte> bytes) {
    read_as_png(bytes);
    const Bytes right = with_right_sums({bytes.begin(), bytes.end()});
    read_as_png(right);
    load_as_pictures(right);
}

void fuzz_wav(std::span<const std::byte> bytes) {
    static const Map map = [] {
        MapFile made = map_of({box_room("room", 0, 0, 8, 4)});
        made.sounds.emplace_back();
        made.sounds.back().name = "hum";
        made.sounds.back().file = "hum.wav";
        return built(made);
    }();
    load_sounds(map, "map.toml", [&](const std::string&) { return Bytes(bytes.begin(), bytes.end()); });
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
