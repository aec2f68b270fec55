#include "world/camera.h"

#include <algorithm>

#include "math/grid.h"

namespace enfilade {
namespace {

double between(double a, double b, double part) { return a + (b - a) * part; }

/// Over the shorter arc.
Angle between(Angle a, Angle b, double part) {
    const auto arc = static_cast<std::int32_t>((b - a).steps);
    return {a.steps + static_cast<std::uint32_t>(static_cast<std::int64_t>(arc * part))};
}

Angle turn_of(const Rigid& passage) { return angle_of({passage.c, passage.s}); }

}  // namespace

Eye eye_between_ticks(const Map& map, const World& world, double part) {
    const Player &before = world.before, &now = world.player;
    if (part >= 1) return {now.place, now.eye_z, now.yaw, now.pitch_steps};
    // In the space of the tick before; from there the eye goes its way again.
    const Rigid back = inverse(world.passage);
    const Vec2 way = back.apply(now.place.point) - before.place.point;
    const Instant then{map, world.history, static_cast<double>(world.tick) - 1 + part};
    const Trace path = trace(map, before.place, snap_to_point_grid(before.place.point + way * part),
                             [&](WallId portal, const Rigid&) { return is_portal(then, portal); });
    const double z = between(before.eye_z, back.apply_height(now.eye_z), part) + path.passage.rise;
    const Heights here = heights_of(then, path.end.sector);
    return {path.end, std::max(here.floor_z, std::min(z, here.ceiling_z)),
            between(before.yaw, now.yaw - turn_of(world.passage), part) + turn_of(path.passage),
            static_cast<std::int32_t>(between(before.pitch_steps, now.pitch_steps, part))};
}

}  // namespace enfilade
