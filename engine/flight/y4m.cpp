#include "flight/y4m.h"

#include <cstdint>
#include <string_view>

namespace enfilade {
namespace {

constexpr std::string_view kFrameMark = "FRAME\n";

struct Yuv {
    std::uint8_t y, u, v;
};

/// BT.601 with coefficients in 65536ths: 219/255 and 224/255 of 0.299 R + 0.587 G + 0.114 B and its differences. Each
/// row of the differences sums to 0, so that grey stays grey; the halves round.
Yuv to_yuv(std::uint32_t color) {
    const std::int32_t r = color & 255, g = color >> 8 & 255, b = color >> 16 & 255;
    const std::int32_t y = 16829 * r + 33039 * g + 6416 * b + (16 << 16) + 32768;
    const std::int32_t u = -9714 * r - 19071 * g + 28785 * b + (128 << 16) + 32768;
    const std::int32_t v = 28785 * r - 24104 * g - 4681 * b + (128 << 16) + 32768;
    return {static_cast<std::uint8_t>(y >> 16), static_cast<std::uint8_t>(u >> 16), static_cast<std::uint8_t>(v >> 16)};
}

}  // namespace

std::string y4m_header(int width, int height, int rate) {
    return "YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F" + std::to_string(rate) +
           ":1 Ip A1:1 C444\n";
}

Bytes y4m_frame(const Frame& frame) {
    const std::size_t count = frame.pixels.size();
    Bytes bytes(kFrameMark.size() + 3 * count);
    for (std::size_t i = 0; i < kFrameMark.size(); ++i) bytes[i] = static_cast<std::byte>(kFrameMark[i]);
    std::byte* y = bytes.data() + kFrameMark.size();
    std::byte *u = y + count, *v = u + count;
    for (std::size_t i = 0; i < count; ++i) {
        const Yuv yuv = to_yuv(frame.pixels[i]);
        y[i] = std::byte{yuv.y};
        u[i] = std::byte{yuv.u};
        v[i] = std::byte{yuv.v};
    }
    return bytes;
}

}  // namespace enfilade
