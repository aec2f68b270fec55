#include "hard_cases/poses.h"

#include <cmath>
#include <optional>

#include "math/vec.h"
#include "space/trace.h"

namespace enfilade::test {
namespace {

constexpr int kTries = 64;  ///< a place that is inside is found in a few, unless the sector fills little of its box

SectorId any_sector(const Map& map, Random& random) {
    return SectorId(static_cast<std::size_t>(random.below(map.sectors.size())));
}

const Wall& any_wall(const Map& map, SectorId sector, Random& random) {
    return map.walls[map[sector].first_wall + static_cast<std::uint32_t>(random.below(map[sector].wall_count))];
}

/// The sector at `wall` that the point is in under the tie rule, or none.
SectorId sector_at(const Map& map, const Wall& wall, Vec2 p) {
    if (contains(map, wall.sector, p)) return wall.sector;
    if (wall.behind && wall.link == Wall::kNoLink && contains(map, wall.behind, p)) return wall.behind;
    return {};
}

struct Place {
    SectorId sector;
    Vec2 eye;
};

using MaybePlace = std::optional<Place>;

MaybePlace somewhere_inside(const Map& map, double grid, Random& random) {
    const SectorId id = any_sector(map, random);
    const Sector& s = map[id];
    for (int i = 0; i < kTries; ++i) {
        Vec2 p{random.uniform(s.min.x, s.max.x), random.uniform(s.min.y, s.max.y)};
        if (grid > 0) p = {std::round(p.x / grid) * grid, std::round(p.y / grid) * grid};
        p = snap_to_point_grid(p);
        if (contains(map, id, p)) return Place{id, p};
    }
    return std::nullopt;
}

MaybePlace on_a_wall(const Map& map, Random& random, std::uint64_t first_eighth, std::uint64_t eighths) {
    const Wall& wall = any_wall(map, any_sector(map, random), random);
    if (wall.kind == WallKind::mirror) return std::nullopt;
    const double part = static_cast<double>(first_eighth + random.below(eighths)) / 8;
    const Vec2 p = wall.a + (wall.b - wall.a) * part;
    const SectorId sector = sector_at(map, wall, p);
    return sector ? MaybePlace(Place{sector, p}) : std::nullopt;
}

/// The eye so far from a vertex that, looking along an axis with a field of 90 degrees, the vertex is exactly on the
/// centre of a pixel column: z = width / 64 and x = (2 column + 1 - width) / 64 are both on the grid.
MaybePlace with_a_vertex_on_a_pixel(const Map& map, int width, Vec2 forward, Random& random) {
    const Wall& wall = any_wall(map, any_sector(map, random), random);
    const int column = static_cast<int>(random.below(static_cast<std::uint64_t>(width)));
    const Vec2 p = wall.a - forward * (width / 64.0) - right_of(forward) * ((2 * column + 1 - width) / 64.0);
    const SectorId sector = locate(map, p);
    return sector ? MaybePlace(Place{sector, p}) : std::nullopt;
}

double any_height(const Map& map, SectorId sector, Random& random) {
    const Sector& s = map[sector];
    return random.uniform(s.floor.z, s.ceiling.z + 0x1p-20);
}

double tied_height(const Map& map, SectorId sector, Random& random) {
    const Sector& s = map[sector];
    const Wall& wall = any_wall(map, sector, random);
    const Sector& behind = map[wall.behind ? wall.behind : sector];
    switch (random.below(6)) {
        case 0: return s.floor.z;
        case 1: return s.ceiling.z;
        case 2: return behind.floor.z;
        case 3: return behind.ceiling.z;
        default: return std::floor((s.floor.z + s.ceiling.z) + 0.5) / 2;
    }
}

View look(const Place& place, double eye_z, Vec2 forward) {
    View view;
    view.sector = place.sector;
    view.eye = place.eye;
    view.eye_z = eye_z;
    view.forward = forward;
    return view;
}

/// Along a wall of the sector, forwards or backwards; not exactly, unless it lies along an axis or a diagonal.
Vec2 along_a_wall(const Map& map, SectorId sector, Random& random) {
    const Wall& wall = any_wall(map, sector, random);
    const Vec2 d = wall.b - wall.a;
    const double length = std::sqrt(dot(d, d)) * (random.below(2) ? 1 : -1);
    return {d.x / length, d.y / length};
}

}  // namespace

View random_pose(const Map& map, Random& random) {
    MaybePlace place;
    while (!place) place = somewhere_inside(map, 0, random);
    const Angle yaw{static_cast<std::uint32_t>(random.bits())};
    View view = look(*place, any_height(map, place->sector, random), direction(yaw));
    view.fov_degrees = random.uniform(40, 120);
    view.pitch_tangent = random.below(2) ? random.uniform(-1, 1) : 0;
    view.stretch = random.below(4) ? 1 : 1.2;
    if (view.stretch != 1) view.ray_offset = ray_offset(RayPoint::corner);  // as Doom's pictures
    return view;
}

View lattice_pose(const Map& map, PictureSize size, Random& random) {
    MaybePlace place;
    Vec2 forward;
    while (!place) {
        const auto eighths_of_a_turn = static_cast<std::uint32_t>(random.below(8));
        forward = direction(Angle{eighths_of_a_turn << 29});
        switch (random.below(5)) {
            case 0: place = somewhere_inside(map, random.below(2) ? 1 : 0.5, random); break;
            case 1: place = on_a_wall(map, random, 1, 7); break;
            case 2: place = on_a_wall(map, random, 0, 1); break;
            case 3:
                forward = direction(Angle{eighths_of_a_turn / 2 << 30});
                place = with_a_vertex_on_a_pixel(map, size.width, forward, random);
                break;
            default:
                place = on_a_wall(map, random, 0, 8);
                if (place) forward = along_a_wall(map, place->sector, random);
        }
    }
    return look(*place, tied_height(map, place->sector, random), forward);
}

}  // namespace enfilade::test
