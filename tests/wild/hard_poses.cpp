#include "wild/hard_poses.h"

#include <cmath>
#include <iterator>
#include <optional>

#include "math/angle.h"
#include "space/trace.h"

namespace enfilade::test {
namespace {

const Wall& any_wall(const Map& map, Random& random) { return map.walls[random.below(map.walls.size())]; }

/// Nothing, steps of either grid, or a nanometre, along each axis.
Vec2 hair(Random& random) {
    constexpr double kHairs[] = {0, 0, kPointGrid, -kPointGrid, kVertexGrid, -kVertexGrid, 1e-9, -1e-9};
    return {kHairs[random.below(std::size(kHairs))], kHairs[random.below(std::size(kHairs))]};
}

/// On or beside a vertex or a wall, at a whole eighth of it or anywhere on it.
Vec2 point_beside(const Wall& wall, Random& random) {
    switch (random.below(4)) {
        case 0: return snap_to_point_grid(wall.a + hair(random));
        case 1: return snap_to_point_grid(wall.a + (wall.b - wall.a) * (double(random.below(9)) / 8) + hair(random));
        case 2: return snap_to_point_grid(wall.a + (wall.b - wall.a) * random.uniform(0, 1) + hair(random));
        default: {
            const Vec2 d = wall.b - wall.a;
            return snap_to_point_grid(wall.a + d * random.uniform(0, 1) + right_of(d) * random.uniform(0, 1));
        }
    }
}

std::optional<Place> hard_place(const Map& map, Random& random) {
    const Wall& wall = any_wall(map, random);
    const Vec2 p = point_beside(wall, random);
    if (std::fabs(p.x) > kWorldLimit || std::fabs(p.y) > kWorldLimit) return {};
    if (contains(map, wall.sector, p)) return Place{wall.sector, p};
    if (wall.behind && wall.link == Wall::kNoLink && contains(map, wall.behind, p)) return Place{wall.behind, p};
    const SectorId sector = locate(map, p);
    return sector ? std::optional(Place{sector, p}) : std::nullopt;
}

double hard_height(const Map& map, SectorId sector, Random& random) {
    const Sector& here = map[sector];
    const Wall& wall = map.walls[here.first_wall + random.below(here.wall_count)];
    const Sector& there = map[wall.behind ? wall.behind : sector];
    const double heights[] = {here.floor.z,
                              here.ceiling.z,
                              there.floor.z,
                              there.ceiling.z,
                              random.uniform(here.floor.z, here.ceiling.z),
                              (here.floor.z + here.ceiling.z) / 2};
    return heights[random.below(std::size(heights))] + (random.below(8) == 0 ? 1e-9 : 0);
}

/// Along an axis, a diagonal or a wall, at a vertex, or anywhere.
Vec2 hard_direction(const Map& map, Vec2 eye, Random& random) {
    const Wall& wall = any_wall(map, random);
    const Vec2 ways[] = {wall.b - wall.a, wall.a - wall.b, wall.a - eye};
    const Vec2 d = ways[random.below(std::size(ways))];
    const double length = std::sqrt(dot(d, d));
    const auto turn = static_cast<std::uint32_t>(random.bits());
    if (length > 0 && random.below(2) == 0) return {d.x / length, d.y / length};
    return direction(Angle{random.below(2) == 0 ? turn : turn & 0xE0000000u});
}

double any_fov(Random& random) {
    constexpr double kEnds[] = {kMinFov, 90, kMaxFov};
    return random.below(2) ? kEnds[random.below(std::size(kEnds))] : random.uniform(kMinFov, kMaxFov);
}

int any_side(int largest, Random& random) {
    return random.below(4) ? largest : 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(largest)));
}

}  // namespace

HardPose hard_pose(const Map& map, PictureSize largest, Random& random) {
    std::optional<Place> place;
    while (!place) place = hard_place(map, random);
    HardPose pose;
    pose.view.sector = place->sector;
    pose.view.eye = place->point;
    pose.view.eye_z = hard_height(map, place->sector, random);
    pose.view.forward = hard_direction(map, place->point, random);
    pose.view.fov_degrees = any_fov(random);
    pose.view.pitch_tangent = random.below(2) ? random.uniform(-1.5, 1.5) : 0;
    pose.view.stretch = random.below(4) ? 1 : 1.2;
    if (pose.view.stretch != 1) pose.view.ray_offset = ray_offset(RayPoint::corner);  // as Doom's pictures
    pose.size = {any_side(largest.width, random), any_side(largest.height, random)};
    return pose;
}

}  // namespace enfilade::test
