#include "app/accuracy/crops.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/accuracy/errors.h"
#include "app/pictures.h"
#include "formats/png.h"
#include "render/view_from.h"

namespace enfilade {
namespace {

constexpr int kWidth = 640, kHeight = 400;         // of the whole picture [px]
constexpr int kCropWidth = 120, kCropHeight = 75;  // of the part [px]
constexpr std::size_t kLeft = 60, kTop = 195;      // a wall that goes away from the eye, and the floor before it
constexpr int kZoom = 3, kGap = 6;                 // [1], [px of the file]

Image crop_of(const JudgedPicture& picture) {
    constexpr std::uint32_t kPaper = 0xFFFFFFFF;
    Image image{2 * kCropWidth * kZoom + kGap, kCropHeight * kZoom, {}};
    image.pixels.assign(std::size_t{image.width} * image.height, kPaper);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < kCropWidth * kZoom; ++x) {
            const auto column = kLeft + x / kZoom;
            const auto i = (kTop + y / kZoom) * kWidth + column;
            image.pixels[std::size_t{y} * image.width + x] = picture.frame.pixels[i];
            image.pixels[std::size_t{y} * image.width + x + kCropWidth * kZoom + kGap] = error_color(picture.errors[i]);
        }
    return image;
}

}  // namespace

std::vector<AccuracySetting> crop_settings() {
    return {AccuracySetting(),
            promise_of(0.25),
            promise_of(1),
            promise_of(4),
            dial_of("span=16"),
            dial_of("number=fixed"),
            dial_of("number=vanilla"),
            dial_of("sampling=mip"),
            dial_of("samples=4")};
}

std::string crop_name(const AccuracySetting& setting) {
    std::string name = name_of(setting);
    name = name.substr(name.rfind(' ') + 1);
    std::ranges::replace(name, '=', '-');
    return name;
}

std::uint32_t error_color(std::optional<double> texel_error) {
    constexpr std::uint32_t kNone = 0xFF204020;
    constexpr std::array<std::array<double, 3>, 5> kStops{
        {{0, 0, 0}, {40, 60, 200}, {220, 30, 40}, {255, 220, 40}, {255, 255, 255}}};  // red, green, blue
    constexpr double kLeast = -6, kMost = 1;                                          // powers of ten
    if (!texel_error) return kNone;
    const double power = std::clamp(std::log10(std::max(*texel_error, 1e-30)), kLeast, kMost);
    const double place = (power - kLeast) / (kMost - kLeast) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(below);
    std::uint32_t color = 0xFF;
    for (std::size_t i = 3; i-- > 0;)
        color = color << 8 | static_cast<std::uint32_t>(kStops[below][i] * (1 - part) + kStops[below + 1][i] * part);
    return color;
}

Result<void> write_crops(const std::string& folder, const OpenMap& map, const std::vector<AccuracySetting>& settings) {
    const auto view = view_at_start(map.map, lens_for(map.map.render));
    if (!view.ok()) return view.error();
    if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    const auto pictures = judge_pictures(map, view.value(), settings, kWidth, kHeight);
    if (!pictures.ok()) return pictures.error();
    for (std::size_t s = 0; s < settings.size(); ++s) {
        const Image crop = crop_of(pictures.value()[s]);
        if (const Result<void> done = write_picture(folder + "/" + crop_name(settings[s]) + ".png", crop); !done.ok())
            return done.error();
    }
    return {};
}

}  // namespace enfilade
