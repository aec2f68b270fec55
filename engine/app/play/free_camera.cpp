#include "app/play/free_camera.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/quoted.h"
#include "math/grid.h"
#include "space/locate.h"
#include "space/trace.h"
#include "world/input.h"

namespace enfilade {
namespace {

constexpr double kSpeed = 5, kRunFactor = 4;  ///< [m/s], [1]
constexpr double kFullPace = 127;             ///< of TickInput
constexpr double kHighest = kWorldLimit;      ///< as far up and down as to the sides [m]

double within_world(double x) { return std::clamp(x, -kWorldLimit, kWorldLimit); }

}  // namespace

void FreeCamera::move(const Map& map, const TickInput& input) {
    eye_.yaw = eye_.yaw + Angle{static_cast<std::uint32_t>(input.yaw_steps)};
    eye_.pitch_steps = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(std::int64_t{eye_.pitch_steps} + input.pitch_steps, -kMaxPitchSteps, kMaxPitchSteps));
    const double metres = kSpeed * kTickSeconds * (input.buttons & kButtonRun ? kRunFactor : 1);
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
    const std::string place = at == Whereabouts::outside
                                  ? "outside all rooms"
                                  : fmt::format("{} {}", places[std::size_t(at)], quoted(map[eye_.place.sector].name));
    return fmt::format("Free flight: {}, x {:.2f} y {:.2f} z {:.2f}. F8 goes back.", place, eye_.place.point.x,
                       eye_.place.point.y, eye_.z);
}

}  // namespace enfilade
