#include "render/frame.h"

#include <limits>

#include "base/hash.h"

namespace enfilade {

void Frame::resize(int new_width, int new_height) {
    width = new_width;
    height = new_height;
    pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

Image image_of(const Frame& frame) {
    return {std::uint32_t(frame.width), std::uint32_t(frame.height), {frame.pixels.begin(), frame.pixels.end()}};
}

Frame frame_of(const Image& image) {
    return {int(image.width), int(image.height), {image.pixels.begin(), image.pixels.end()}};
}

void reset(FrameFacts& facts, int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    facts.ids.assign(count, kNothing);
    facts.depths.assign(count, std::numeric_limits<double>::infinity());
    facts.texels.assign(count, {});
    facts.writes.assign(count, 0);
    facts.ambiguous.assign(count, 0);
}

std::uint64_t hash_of(const Frame& frame) {
    Hash hash;
    hash.add(std::int32_t{frame.width});
    hash.add(std::int32_t{frame.height});
    for (std::uint32_t pixel : frame.pixels) hash.add(pixel);
    return hash.value();
}

}  // namespace enfilade
