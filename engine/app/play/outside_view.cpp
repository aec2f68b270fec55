#include "app/play/outside_view.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr Color kRim = 0xFFE0E0E0;

/// The inset's sides in those of the picture [1].
constexpr double kInset = 0.4;

constexpr double kZoomFactor = 1.25;
constexpr int kMostZoom = 10;

/// Where the inset is: the upper right corner, away from notices and health.
Box inset_box(const Frame& frame) {
    const int width = std::max(1, int(frame.width * kInset)), height = std::max(1, int(frame.height * kInset));
    return {frame.width - width, 0, width, height};
}

std::size_t index_of(const Frame& frame, int x, int y) {
    return std::size_t(y) * std::size_t(frame.width) + std::size_t(x);
}

/// The frame, made as small as `to`: nearest pixels, for it is only a reminder.
void shrink(const Frame& from, Frame& to) {
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            to.pixels[index_of(to, x, y)] =
                from.pixels[index_of(from, x * from.width / to.width, y * from.height / to.height)];
}

void put(Frame& frame, const Frame& inset, const Box& box) {
    for (int y = 0; y < box.height; ++y)
        std::copy_n(inset.pixels.begin() + std::ptrdiff_t(index_of(inset, 0, y)), box.width,
                    frame.pixels.begin() + std::ptrdiff_t(index_of(frame, box.left, box.top + y)));
}

}  // namespace

void OutsideView::show_next() {
    shown_ = shown_ == Shown::nowhere ? Shown::inset : shown_ == Shown::inset ? Shown::full : Shown::nowhere;
}

void OutsideView::zoom(int steps) { zoom_steps_ = std::clamp(zoom_steps_ + steps, -kMostZoom, kMostZoom); }

void OutsideView::draw(Overlay& overlay, Frame& frame, const Map& map, const TextureSet& textures,
                       const Snapshot& snapshot, const View& view, std::size_t threads) {
    if (shown_ == Shown::nowhere) return;
    const Box box = inset_box(frame);
    inset_.resize(box.width, box.height);
    const OutsideLook look{from_, kUsualReach / std::pow(kZoomFactor, zoom_steps_), frame.width, frame.height};
    if (shown_ == Shown::inset) {
        renderer_.render(inset_, map, textures, snapshot, view, look, threads);
    } else {
        large_.resize(frame.width, frame.height);
        renderer_.render(large_, map, textures, snapshot, view, look, threads);
        shrink(frame, inset_);
        frame.pixels.swap(large_.pixels);
    }
    put(frame, inset_, box);
    overlay.outline(box, kRim);
}

}  // namespace enfilade
