#include "picture.h"

#include <png.h>

#include <stdexcept>

namespace draw_textures {
namespace {

constexpr int kSamples = 3;  // per texel and direction
constexpr int kHollow = 3;   // how far around a texel its surroundings shade it, in texels

Surface sample_texel(int x, int y, int width, int height, const Painter& painter) {
    Surface sum{{0, 0, 0}, 0, 0};
    for (int k = 0; k < kSamples * kSamples; ++k) {
        const double sx = x + (k % kSamples + 0.5) / kSamples, sy = y + (k / kSamples + 0.5) / kSamples;
        const Surface s = painter(sx, sy, sx / width, sy / height);
        sum.color = sum.color + s.color * s.alpha;
        sum.height += s.height;
        sum.alpha += s.alpha;
    }
    const double count = kSamples * kSamples;
    return {sum.alpha > 0 ? sum.color * (1 / sum.alpha) : sum.color, sum.height / count, sum.alpha / count};
}

// How much of the light reaches a texel, 1 where the surface is flat.
double light_at(const Picture& p, int x, int y) {
    const auto height = [&](int dx, int dy) {
        return p.texels[static_cast<std::size_t>(wrap(y + dy, p.height) * p.width + wrap(x + dx, p.width))].height;
    };
    const double sx = (height(1, 0) - height(-1, 0)) / 2, sy = (height(0, 1) - height(0, -1)) / 2;
    const double facing = (1 + 0.45 * sx + 0.75 * sy) / std::sqrt(1 + sx * sx + sy * sy);
    double around = 0;
    for (int k = -kHollow; k <= kHollow; ++k) {
        around += height(k, 0) + height(0, k) + height(k, k) + height(k, -k);
    }
    const double depth = around / (4 * (2 * kHollow + 1)) - height(0, 0);
    return (0.35 + 0.65 * std::clamp(facing, 0.0, 1.6)) * std::clamp(1 - 0.16 * depth, 0.55, 1.1);
}

png_byte to_byte(double t) { return static_cast<png_byte>(clamp01(t) * 255 + 0.5); }

}  // namespace

Picture paint(int width, int height, const Painter& painter) {
    Picture p{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            p.texels.push_back(sample_texel(x, y, width, height, painter));
        }
    }
    std::vector<double> light;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            light.push_back(light_at(p, x, y));
        }
    }
    for (std::size_t i = 0; i < light.size(); ++i) {
        p.texels[i].color = p.texels[i].color * light[i];
    }
    return p;
}

void save_png(const Picture& picture, const std::string& path, bool with_alpha) {
    std::vector<png_byte> bytes;
    for (const Surface& s : picture.texels) {
        bytes.insert(bytes.end(), {to_byte(s.color.r), to_byte(s.color.g), to_byte(s.color.b)});
        if (with_alpha) {
            bytes.push_back(to_byte(s.alpha));
        }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    if (png_image_write_to_file(&image, path.c_str(), 0, bytes.data(), 0, nullptr) == 0) {
        throw std::runtime_error(path + ": " + image.message);
    }
}

}  // namespace draw_textures
