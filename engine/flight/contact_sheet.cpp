#include "flight/contact_sheet.h"

#include <algorithm>

#include "base/result.h"

namespace enfilade {
namespace {

constexpr int kColumns = 4;  ///< pictures side by side: twelve of 80 x 50 make a sheet of a picture's usual shape
constexpr std::uint32_t kBlack = 0xFF000000u;

int parts(int whole, int part) { return (whole + part - 1) / part; }

/// The mean, rounded, of the pixels [left, right) x [top, bottom).
std::uint32_t mean_color(const Frame& picture, int left, int top, int right, int bottom) {
    std::uint64_t sums[3] = {};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            for (int channel = 0; channel < 3; ++channel)
                sums[channel] +=
                    picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] >> 8 * channel & 255;
    const auto count = std::uint64_t(right - left) * std::uint64_t(bottom - top);
    std::uint32_t color = kBlack;
    for (int channel = 0; channel < 3; ++channel)
        color |= static_cast<std::uint32_t>((sums[channel] + count / 2) / count) << 8 * channel;
    return color;
}

}  // namespace

int reduction_of(int width, int height) { return parts(std::max(width, height), kSmallSide); }

Frame reduced(const Frame& picture, int reduction) {
    Frame small;
    small.resize(parts(picture.width, reduction), parts(picture.height, reduction));
    auto pixel = small.pixels.begin();
    for (int top = 0; top < picture.height; top += reduction)
        for (int left = 0; left < picture.width; left += reduction)
            *pixel++ = mean_color(picture, left, top, std::min(left + reduction, picture.width),
                                  std::min(top + reduction, picture.height));
    return small;
}

std::vector<int> frames_on_sheet(int frames) {
    const int count = std::min(frames, kMostOnSheet);
    std::vector<int> chosen{0};
    for (int i = 1; i < count; ++i) chosen.push_back(static_cast<int>(std::int64_t{i} * (frames - 1) / (count - 1)));
    return chosen;
}

ContactSheet::ContactSheet(int frames, int width, int height)
    : frames_(frames_on_sheet(frames)),
      reduction_(reduction_of(width, height)),
      width_(parts(width, reduction_)),
      height_(parts(height, reduction_)) {
    const int count = static_cast<int>(frames_.size());
    image_.resize(std::min(count, kColumns) * width_, parts(count, kColumns) * height_);
    std::ranges::fill(image_.pixels, kBlack);
}

bool ContactSheet::take(Frame image) {
    if (image.width != image_.width || image.height != image_.height) return false;
    image_ = std::move(image);
    return true;
}

std::optional<std::size_t> ContactSheet::place_of(int frame) const {
    const auto found = std::ranges::lower_bound(frames_, frame);
    if (found == frames_.end() || *found != frame) return {};
    const auto number = static_cast<int>(found - frames_.begin());
    const int row = number / kColumns * height_, column = number % kColumns * width_;
    return std::size_t(row) * std::size_t(image_.width) + std::size_t(column);
}

void ContactSheet::put(int frame, const Frame& picture) {
    const auto place = place_of(frame);
    if (!place) return;
    const Frame small = reduced(picture, reduction_);
    ENFILADE_CHECK(small.width == width_ && small.height == height_);
    for (int y = 0; y < height_; ++y)
        std::copy_n(small.pixels.begin() + y * width_, width_,
                    image_.pixels.begin() + std::ptrdiff_t(*place) + y * image_.width);
}

std::optional<Frame> ContactSheet::picture_of(int frame) const {
    const auto place = place_of(frame);
    if (!place) return {};
    Frame small;
    small.resize(width_, height_);
    for (int y = 0; y < height_; ++y)
        std::copy_n(image_.pixels.begin() + std::ptrdiff_t(*place) + y * image_.width, width_,
                    small.pixels.begin() + y * width_);
    return small;
}

}  // namespace enfilade
