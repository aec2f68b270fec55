#include "world/player.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr double kStandingEye = 1.55, kCrouchedEye = 0.85;  ///< above the feet [m]

/// Tries to leave walls that are nearer than the radius. In a room that is narrower than the body there is nothing to
/// be won; a few tries find the way out of a corner.
constexpr int kTriesToGetFree = 8;

/// Rounding that a place which was moved off a wall may lose again [grid steps].
constexpr double kStepsToSpare = 4;

/// The way off the nearest of the walls found.
struct WayOff {
    Vec2 direction;                 ///< unit vector
    double distance = kWorldLimit;  ///< from the wall [m]
};

WayOff way_off(const ReachedWall& reached) {
    const Vec2 away = reached.centre - nearest_point(reached.stretch, reached.centre);
    const double distance = std::sqrt(dot(away, away));
    const Vec2 along = reached.b - reached.a;
    const Vec2 direction = distance > 0 ? away * (1 / distance) : right_of(along) * (1 / std::sqrt(dot(along, along)));
    return {inverse(reached.passage).turn(direction), distance};
}

WayOff way_off_nearest(const Reach& found) {
    WayOff nearest;
    for (const ReachedWall& reached : found.walls) {
        const WayOff off = way_off(reached);
        if (off.distance < nearest.distance) nearest = off;
    }
    return nearest;
}

/// The body, which is as wide as there is room, moved to a full radius from the wall that is nearest.
Body moved_off(const Instant& now, const Body& narrow) {
    Body wide = narrow;
    wide.radius = kBodyRadius;
    const WayOff off = way_off_nearest(around(now, wide));
    const double by = kBodyRadius - off.distance + kStepsToSpare * kPointGrid;
    // Not through a link: then heights and yaw would have to follow.
    const auto may_pass = [&](WallId portal, const Rigid& passage) {
        return now.map[portal].link == Wall::kNoLink && can_pass(now, narrow, portal, passage);
    };
    const Vec2 target = snap_to_point_grid(narrow.place.point + off.direction * by);
    wide.place = trace(now.map, narrow.place, target, may_pass, bodies_may_cross(now.map)).end;
    return squeezed(now, wide);
}

/// The widest body found on the way off walls that are nearer than its radius.
Body moved_free(const Instant& now, const Body& body) {
    Body best = squeezed(now, body), last = best;
    for (int i = 0; i < kTriesToGetFree && best.radius < kBodyRadius; ++i) {
        last = moved_off(now, last);
        if (last.radius > best.radius) best = last;
    }
    return best;
}

}  // namespace

double eye_height(double height) {
    if (height < kCrouchedHeight) return kCrouchedEye * height;
    const double standing = (height - kCrouchedHeight) / (kStandingHeight - kCrouchedHeight);
    return kCrouchedEye + (kStandingEye - kCrouchedEye) * standing;
}

Body body_of(const Instant& now, const Player& player) {
    return squeezed(now, {player.place, player.feet_z, player.height, kBodyRadius, kWorldLimit});
}

double eye_z_of(const Player& player, double ceiling_z) {
    const double feet_to_eye = eye_height(player.height);
    const double highest = std::max(player.feet_z + feet_to_eye, ceiling_z - kEyeBelowCeiling);
    const double lowest = player.feet_z + std::min(feet_to_eye, kEyeBelowCeiling);
    return std::clamp(player.feet_z + feet_to_eye + player.eye_lag, lowest, highest);
}

Player player_at(const Instant& now, const PlayerStart& start) {
    const Heights here = heights_of(now, start.sector);
    Body body{{start.sector, start.position}, start.eye_z - kStandingEye, kStandingHeight, kBodyRadius, kWorldLimit};
    body.feet_z = std::max(here.floor_z, std::min(body.feet_z, here.ceiling_z - body.height));
    body = moved_free(now, body);

    Player player;
    player.place = body.place;
    player.height = body.height;
    const Clearance free = clearance(now, body, around(now, body).sectors);
    player.feet_z = std::max(body.feet_z, free.floor_z);
    player.on_ground = player.feet_z <= free.floor_z;
    player.yaw = start.yaw;
    player.eye_z = eye_z_of(player, free.ceiling_z);
    return player;
}

}  // namespace enfilade
