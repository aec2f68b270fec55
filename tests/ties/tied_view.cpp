#include "ties/tied_view.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "math/angle.h"
#include "render/view.h"
#include "space/trace.h"

namespace enfilade::test {
namespace {

template <class T, std::size_t kCount>
const T& any_of(const T (&values)[kCount], Random& random) {
    return values[random.below(kCount)];
}

const Wall& any_wall(const Map& map, Random& random) { return map.walls[random.below(map.walls.size())]; }

const Wall& any_wall(const Map& map, SectorId sector, Random& random) {
    return map.walls[map[sector].first_wall + random.below(map[sector].wall_count)];
}

/// A vertex of the sector, of one behind its portals, or of any other.
Vec2 any_vertex(const Map& map, SectorId sector, Random& random) {
    const Wall& wall = any_wall(map, sector, random);
    switch (random.below(4)) {
        case 0: return any_wall(map, random).a;
        case 1: return any_wall(map, wall.behind ? wall.behind : sector, random).a;
        default: return wall.a;
    }
}

// The picture.

PictureSize any_size(Random& random) {
    constexpr int kWidths[] = {1, 2, 3, 16, 33, 64, 64, 65, 96, 128, 160};
    constexpr int kHeights[] = {1, 2, 3, 16, 17, 24, 24, 25, 32, 48}, kTall = 400;
    const int width = any_of(kWidths, random);
    return {width, width <= 3 && random.below(4) == 0 ? kTall : any_of(kHeights, random)};
}

View any_lens(Random& random) {
    constexpr double kFovs[] = {90, 90, 90, 60, 120, 73.7397952917, kMinFov, kMaxFov};
    View view;
    view.fov_degrees = any_of(kFovs, random);
    view.stretch = random.below(4) ? 1 : 1.2;
    if (random.below(2)) view.ray_offset = ray_offset(RayPoint::corner);
    constexpr double kPitches[] = {0.25, -0.5, kTieClimb / 2, -kTieClimb / 2, -kTieClimb};
    if (random.below(3) == 0) view.pitch_tangent = random.below(2) ? any_of(kPitches, random) : random.uniform(-1, 1);
    return view;
}

/// Often the one along the look, or the first, whose slope is a whole number where the field is a right angle.
int any_column(int width, Random& random) {
    switch (random.below(4)) {
        case 0: return width / 2;
        case 1: return 0;
        default: return static_cast<int>(random.below(static_cast<std::uint64_t>(width)));
    }
}

// The eye.

/// Nothing, mostly, or a step of the eye's grid along each axis.
Vec2 aside(Random& random) {
    constexpr double kSteps[] = {0, 0, kPointGrid, -kPointGrid};
    return random.below(2) ? Vec2{} : Vec2{any_of(kSteps, random), any_of(kSteps, random)};
}

/// A vertex, or a point on the wall's line: whole eighths from its start, also beyond its ends.
Vec2 point_on(const Wall& wall, Random& random) {
    if (random.below(2)) return wall.a;
    const double eighths = random.below(4) ? static_cast<double>(random.below(9)) : random.uniform(-16, 24);
    return wall.a + (wall.b - wall.a) * (std::floor(eighths) / 8);
}

/// Where the eye is, and what space its rays are aimed in: its own, or the one behind a link.
struct Aim {
    Place place;
    Rigid passage;    ///< from the eye's space into the one that is aimed in
    SectorId sector;  ///< that is aimed in
};

std::optional<Place> place_at(const Map& map, SectorId near, Vec2 p) {
    if (std::fabs(p.x) > kWorldLimit || std::fabs(p.y) > kWorldLimit) return {};
    if (contains(map, near, p)) return Place{near, p};
    const SectorId sector = locate_near(map, near, p);
    return sector ? std::optional(Place{sector, p}) : std::nullopt;
}

std::optional<Aim> aim_here(const Map& map, Random& random) {
    const Wall& wall = any_wall(map, random);
    const auto place = place_at(map, wall.sector, snap_to_point_grid(point_on(wall, random) + aside(random)));
    if (!place) return {};
    return Aim{*place, {}, place->sector};
}

/// The eye lies on a tie in the space behind a link, or in its own, and looks through.
std::optional<Aim> aim_through_link(const Map& map, Random& random) {
    const Wall& portal = any_wall(map, random);
    if (portal.link == Wall::kNoLink) return {};
    const Rigid passage = map.passage(portal);
    const SectorId beyond = portal.behind ? portal.behind : portal.sector;
    const bool is_tie_beyond = random.below(2) == 0;
    const Vec2 tie = point_on(any_wall(map, is_tie_beyond ? beyond : portal.sector, random), random);
    const Vec2 eye = (is_tie_beyond ? inverse(passage).apply(tie) : tie) + aside(random);
    const auto place = place_at(map, portal.sector, snap_to_point_grid(eye));
    if (!place || place->sector != portal.sector) return {};
    return Aim{*place, passage, beyond};
}

// The look.

Vec2 unit(Vec2 v) {
    if (v.x == 0 || v.y == 0) return {double((v.x > 0) - (v.x < 0)), double((v.y > 0) - (v.y < 0))};
    return v * (1 / std::sqrt(dot(v, v)));
}

/// Along an axis, a diagonal or a wall, or through a vertex: in the space that is aimed in.
Vec2 any_way(const Map& map, const Aim& aim, Random& random) {
    constexpr Vec2 kAxes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, kDiagonals[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    const Wall& wall = any_wall(map, aim.sector, random);
    switch (random.below(5)) {
        case 0:
        case 1: return any_of(kAxes, random);
        case 2: return random.below(4) ? any_of(kDiagonals, random) : wall.b - wall.a;
        case 3: return random.below(2) ? wall.b - wall.a : wall.a - wall.b;
        default: return any_vertex(map, aim.sector, random) - aim.passage.apply(aim.place.point);
    }
}

/// Of the look whose ray with this slope goes that way.
Vec2 forward_for(Vec2 way, double slope) {
    const Vec2 along = unit(way);
    if (slope == 0) return along;
    return (along - right_of(along) * slope) * (1 / std::sqrt(1 + slope * slope));
}

/// A step of doubles aside, now and then.
void nudge(double& x, Random& random) {
    if (random.below(8) == 0) x = std::nextafter(x, random.below(2) ? 2.0 : -2.0);
}

// The heights.

double any_edge(const Map& map, SectorId sector, Random& random) {
    const Wall& wall = any_wall(map, sector, random);
    const Sector& room = map[random.below(2) && wall.behind ? wall.behind : sector];
    return random.below(2) ? room.floor.z : room.ceiling.z;
}

/// How far the rays of any row climb per metre, or what the tie rule makes of it.
double any_climb(const Projection& projection, Random& random) {
    const double climb = projection.climb(static_cast<int>(random.below(std::uint64_t(projection.height()))));
    return random.below(2) ? climb + kTieClimb : climb;
}

/// At an edge's height; or so that a row passes an edge where the aimed ray is `depth` away, which is often where it
/// passes a vertex; or between floor and ceiling.
double any_eye_z(const Map& map, const Aim& aim, const Projection& projection, double depth, Random& random) {
    const Sector& here = map[aim.place.sector];
    switch (random.below(3)) {
        case 0: return any_edge(map, aim.place.sector, random);
        case 1: return any_edge(map, aim.sector, random) - aim.passage.rise - any_climb(projection, random) * depth;
        default: return here.floor.z + (here.ceiling.z - here.floor.z) * random.uniform(0, 1);
    }
}

std::optional<Aim> any_aim(const Map& map, Random& random) {
    if (!map.links.empty() && random.below(2)) return aim_through_link(map, random);
    return aim_here(map, random);
}

std::optional<TiedView> aimed_view(const Map& map, Random& random) {
    const auto aim = any_aim(map, random);
    if (!aim) return {};
    TiedView tied{any_lens(random), any_size(random), 0};
    View& view = tied.view;
    tied.column = any_column(tied.size.width, random);
    view.sector = aim->place.sector;
    view.eye = aim->place.point;
    const Projection projection(view, tied.size.width, tied.size.height);
    const Vec2 way = inverse(aim->passage).turn(any_way(map, *aim, random));
    if (way == Vec2{}) return {};
    view.forward = forward_for(way, projection.slope(tied.column));
    nudge(view.forward.x, random);
    nudge(view.forward.y, random);
    const double depth = dot(view.forward, way);
    view.eye_z = any_eye_z(map, *aim, projection, depth > 0 ? depth : 1, random);
    return tied;
}

/// The eye so far from a vertex that, along an axis and with a field of 90 degrees, the vertex is exactly on a ray of a
/// column, and often an edge there on a ray of a row: width / 64 away all of it is on the grid.
std::optional<TiedView> exact_view(const Map& map, Random& random) {
    TiedView tied{any_lens(random), any_size(random), 0};
    View& view = tied.view;
    view.fov_degrees = 90;
    view.stretch = 1;
    view.pitch_tangent = 0;
    view.forward = direction(Angle{static_cast<std::uint32_t>(random.below(4)) << 30});
    const double width = tied.size.width, away = width / 64;
    tied.column = static_cast<int>(random.below(static_cast<std::uint64_t>(tied.size.width)));
    const Projection projection(view, tied.size.width, tied.size.height);
    const Wall& wall = any_wall(map, random);
    const double right = (tied.column - projection.middle_column()) / 32;
    const auto place = place_at(map, wall.sector, wall.a - view.forward * away - right_of(view.forward) * right);
    if (!place) return {};
    view.sector = place->sector;
    view.eye = place->point;
    view.eye_z = any_edge(map, wall.sector, random) - any_climb(projection, random) * away;
    return tied;
}

}  // namespace

TiedView tied_view(const Map& map, Random& random) {
    std::optional<TiedView> tied;
    while (!tied) tied = random.below(5) ? aimed_view(map, random) : exact_view(map, random);
    return *tied;
}

}  // namespace enfilade::test
