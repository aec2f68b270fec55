#include "app/play/play_loop.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "formats/text_parts.h"
#include "math/vec.h"
#include "space/trace.h"
#include "world/input.h"

namespace enfilade {

namespace {

constexpr double kSpeed = 5, kRunFactor = 4;  ///< [m/s], [1]
constexpr double kFullPace = 127;             ///< of TickInput
constexpr double kHighest = kWorldLimit;      ///< as far up and down as to the sides [m]

double within_world(double x) { return std::clamp(x, -kWorldLimit, kWorldLimit); }

}  // namespace

void FreeCamera::move(const Map& map, const TickInput& input, double seconds) {
    eye_.yaw = eye_.yaw + Angle{static_cast<std::uint32_t>(input.yaw_steps)};
    eye_.pitch_steps = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(std::int64_t{eye_.pitch_steps} + input.pitch_steps, -kMaxPitchSteps, kMaxPitchSteps));
    const double metres = kSpeed * seconds * (input.buttons & kButtonRun ? kRunFactor : 1);
    const Vec2 ahead = direction(eye_.yaw), pitch = direction(Angle{static_cast<std::uint32_t>(eye_.pitch_steps)});
    const double forward = input.forward / kFullPace * metres, aside = input.strafe / kFullPace * metres;
    const int rise = int{(input.buttons & kButtonUse) != 0} - int{(input.buttons & kButtonCrouch) != 0};
    eye_.z = std::clamp(eye_.z + forward * pitch.y + rise * metres, -kHighest, kHighest);
    const Vec2 to = eye_.place.point + ahead * (forward * pitch.x) + right_of(ahead) * aside;
    go_to(map, snap_to_point_grid(Vec2{within_world(to.x), within_world(to.y)}));
}

void FreeCamera::go_to(const Map& map, Vec2 to) {
    if (!is_outside_) {
        const Trace way = trace(map, eye_.place, to);
        eye_.yaw = angle_of(way.passage.turn(direction(eye_.yaw)));
        eye_.z = way.passage.apply_height(eye_.z);
        eye_.place = way.end;
        if (!way.is_stopped()) return;
        to = snap_to_point_grid(way.passage.apply(to));
    }
    const SectorId found = locate(map, to);
    is_outside_ = !found;
    eye_.place = {found ? found : eye_.place.sector, to};
}

Whereabouts FreeCamera::whereabouts(const Snapshot& snapshot) const {
    const SectorSnapshot& room = snapshot[eye_.place.sector];
    if (is_outside_) return Whereabouts::outside;
    if (eye_.z >= room.ceiling_z) return Whereabouts::above_ceiling;
    return eye_.z <= room.floor_z ? Whereabouts::below_floor : Whereabouts::in_room;
}

std::string FreeCamera::text(const Map& map, const Snapshot& snapshot) const {
    const char* const places[] = {"in", "above the ceiling of", "below the floor of"};
    const Whereabouts at = whereabouts(snapshot);
    const std::string place = at == Whereabouts::outside ? "outside all rooms"
                                                         : fmt::format("{} {}", places[std::size_t(at)],
                                                                       in_quotes(map[eye_.place.sector].name));
    return fmt::format("Free flight: {}, x {:.2f} y {:.2f} z {:.2f}. F8 goes back.", place, eye_.place.point.x,
                       eye_.place.point.y, eye_.z);
}

namespace {

constexpr Color kRim = 0xFFE0E0E0;

/// The inset's sides in those of the picture [1].
constexpr double kInset = 0.4;

constexpr double kViewZoomFactor = 1.25;
constexpr int kMostViewZoom = 10;

/// Where the inset is: the upper right corner, away from notices and health.
Rect inset_box(const Frame& frame) {
    const int width = std::max(1, int(frame.width * kInset)), height = std::max(1, int(frame.height * kInset));
    return {frame.width - width, 0, width, height};
}

std::size_t pixel_index(const Frame& frame, int x, int y) {
    return std::size_t(y) * std::size_t(frame.width) + std::size_t(x);
}

/// The frame, made as small as `to`: nearest pixels, for it is only a reminder.
void shrink(const Frame& from, Frame& to) {
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            to.pixels[pixel_index(to, x, y)] =
                from.pixels[pixel_index(from, x * from.width / to.width, y * from.height / to.height)];
}

void put(Frame& frame, const Frame& inset, const Rect& box) {
    for (int y = 0; y < box.height; ++y)
        std::copy_n(inset.pixels.begin() + std::ptrdiff_t(pixel_index(inset, 0, y)), box.width,
                    frame.pixels.begin() + std::ptrdiff_t(pixel_index(frame, box.left, box.top + y)));
}

}  // namespace

void OutsideView::show_next() {
    shown_ = shown_ == Shown::nowhere ? Shown::inset : shown_ == Shown::inset ? Shown::full : Shown::nowhere;
}

void OutsideView::zoom(int steps) { zoom_steps_ = std::clamp(zoom_steps_ + steps, -kMostViewZoom, kMostViewZoom); }

void OutsideView::draw(Overlay& overlay, Frame& frame, OutsideRenderer& renderer, const Snapshot& snapshot,
                       const View& view, std::size_t threads) {
    if (shown_ == Shown::nowhere) return;
    const Rect box = inset_box(frame);
    inset_.resize(box.width, box.height);
    const OutsideLook look{from_, kUsualReach / std::pow(kViewZoomFactor, zoom_steps_), frame.width, frame.height};
    if (shown_ == Shown::inset) {
        renderer.render(inset_, snapshot, view, look, threads);
    } else {
        large_.resize(frame.width, frame.height);
        renderer.render(large_, snapshot, view, look, threads);
        shrink(frame, inset_);
        frame.pixels.swap(large_.pixels);
    }
    put(frame, inset_, box);
    overlay.outline(box, kRim);
}

}  // namespace enfilade
