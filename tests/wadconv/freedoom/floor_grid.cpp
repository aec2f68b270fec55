#include "wadconv/freedoom/floor_grid.h"

#include <algorithm>
#include <cmath>

#include "world/body.h"

namespace enfilade::test {
namespace {

/// Directions of steps: along the axes first, so that ways do not zigzag.
constexpr std::array<Vec2, 8> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// Where something is near, only steps along the axes are tried: half the work, and hardly ever another way.
constexpr std::uint32_t kAxes = 4;

constexpr double kDiagonalStep = 1.5 * kGridSpacing;  ///< rounded up [m]

/// How many lattice steps away a body looks for a point to begin with.
constexpr int kLookAround = 2;

std::uint64_t key_of(Vec2 point) {
    const auto steps = [](double x) { return static_cast<std::uint32_t>(std::int32_t(std::lround(x / kGridSpacing))); };
    return std::uint64_t{steps(point.x)} << 32 | steps(point.y);
}

/// A crouching body that stands on the floor there, fallen as deep as it can. It came with its feet at that height.
Body standing(const Map& map, const Place& place, double feet_z) {
    Body body{place, feet_z, kCrouchedHeight};
    for (bool falls = true; falls;) {
        body.ceiling_z = kWorldLimit;
        const Clearance free = clearance(map, body, around(map, body).sectors);
        falls = free.floor_z < body.feet_z;
        body.feet_z = free.floor_z;
        body.ceiling_z = free.ceiling_z;
    }
    return body;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double part = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    const Vec2 off = p - (a + along * part);
    return std::sqrt(dot(off, off));
}

/// How far the nearest thing is that may be in the way: a wall, a portal, whatever is behind it, a solid thing [m].
double clear_around(const Map& map, const Place& place) {
    double clear = kWorldLimit;
    const Sector& sector = map[place.sector];
    for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
        clear = std::min(clear, distance_to_segment(place.point, map.walls[w].a, map.walls[w].b));
    for (std::uint32_t p = sector.first_panel; p < sector.first_panel + sector.panel_count; ++p)
        if (map.panels[p].blocks)
            clear = std::min(clear, distance_to_segment(place.point, map.panels[p].a, map.panels[p].b));
    for (const ThingId id : map.solid_things) {
        const Vec2 off = place.point - map[id].position;
        clear = std::min(clear, std::sqrt(dot(off, off)) - map[id].radius);
    }
    return clear;
}

FloorPoint point_of(const Map& map, const Place& place, double feet_z) {
    const Body body = standing(map, place, feet_z);
    FloorPoint point{place, body.feet_z, body.ceiling_z, clear_around(map, place), 0, {}, {}};
    point.next.fill(FloorPoint::kNowhere);
    return point;
}

/// The point a step beside one with nothing near.
FloorPoint point_beside(const Map& map, const FloorPoint& free, Vec2 to) {
    FloorPoint point = free;
    point.place.point = to;
    point.clear_m -= kDiagonalStep;
    if (!point.is_free()) point.clear_m = clear_around(map, point.place);
    point.tried = 0;
    point.next.fill(FloorPoint::kNowhere);
    return point;
}

}  // namespace

/// Where a body gets that walks straight to a point, or nothing where it does not get there.
std::optional<Place> FloorGrid::walked(const FloorPoint& from, Vec2 to) const {
    // Where nothing is near there is nothing to try.
    if (from.is_free()) return Place{from.place.sector, to};
    const Body body{from.place, from.feet_z, kCrouchedHeight, kBodyRadius, from.ceiling_z};
    const Walk walk = enfilade::walk(map_, body, to - from.place.point, 1);
    return walk.end.point == to ? std::optional(walk.end) : std::nullopt;
}

std::uint32_t FloorGrid::add(const FloorPoint& point) {
    known_.emplace(key_of(point.place.point), static_cast<std::uint32_t>(points_.size()));
    points_.push_back(point);
    came_from_.push_back(FloorPoint::kNowhere);
    return static_cast<std::uint32_t>(points_.size() - 1);
}

std::uint32_t FloorGrid::step(std::uint32_t from, std::uint32_t direction) {
    const auto bit = static_cast<std::uint8_t>(1u << direction);
    if (points_[from].tried & bit) return points_[from].next[direction];
    points_[from].tried |= bit;
    const FloorPoint& here = points_[from];
    const std::optional<Place> place = walked(here, here.place.point + kDirections[direction] * kGridSpacing);
    if (!place) return FloorPoint::kNowhere;
    if (!here.is_free()) note_passed(from, direction, *place);
    const auto known = known_.find(key_of(place->point));
    if (known != known_.end()) return points_[from].next[direction] = known->second;
    const FloorPoint there =
        here.is_free() ? point_beside(map_, here, place->point) : point_of(map_, *place, here.feet_z);
    if (!is_at_most(kCrouchedHeight, there.ceiling_z - there.feet_z)) return FloorPoint::kNowhere;
    const std::uint32_t point = add(there);
    return points_[from].next[direction] = point;
}

/// Sectors that are so narrow that a step leads over them.
void FloorGrid::note_passed(std::uint32_t from, std::uint32_t direction, const Place& to) {
    const Trace way = trace(map_, points_[from].place, to.point);
    for (const Crossing& crossing : way.crossings)
        if (const SectorId behind = map_[crossing.portal].behind; behind != to.sector)
            points_[from].passed.emplace_back(direction, behind);
}

std::optional<std::uint32_t> FloorGrid::point_near(const Body& body) {
    const Vec2 middle = body.place.point * (1 / kGridSpacing);
    std::vector<Vec2> candidates;
    for (int x = -kLookAround; x <= kLookAround; ++x)
        for (int y = -kLookAround; y <= kLookAround; ++y)
            candidates.push_back(Vec2{std::floor(middle.x + 0.5) + x, std::floor(middle.y + 0.5) + y} * kGridSpacing);
    const auto distance = [&](Vec2 p) { return dot(p - body.place.point, p - body.place.point); };
    std::ranges::sort(candidates, [&](Vec2 p, Vec2 q) { return distance(p) < distance(q); });
    for (const Vec2 p : candidates) {
        const Walk walk = enfilade::walk(map_, body, p - body.place.point, 1);
        if (walk.end.point != p) continue;
        const auto known = known_.find(key_of(p));
        return known != known_.end() ? known->second : add(point_of(map_, walk.end, body.feet_z));
    }
    return {};
}

std::vector<std::uint32_t> FloorGrid::way_to(std::uint32_t start, const std::function<bool(SectorId)>& is_wanted,
                                             Drops drops, std::vector<std::uint32_t>* reached) {
    std::ranges::fill(came_from_, FloorPoint::kNowhere);
    came_from_[start] = start;
    std::vector<std::uint32_t> order{start};
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t here = order[i];
        if (is_wanted(points_[here].place.sector)) return way_back(here);
        const std::uint32_t directions = points_[here].is_free() ? kDirections.size() : kAxes;
        for (std::uint32_t d = 0; d < directions; ++d) {
            const std::uint32_t there = step(here, d);
            if (there == FloorPoint::kNowhere || (drops == Drops::avoided && is_drop(here, there))) continue;
            const auto is_passed = [&](const auto& way) { return way.first == d && is_wanted(way.second); };
            const bool passes = std::ranges::any_of(points_[here].passed, is_passed);
            if (came_from_[there] == FloorPoint::kNowhere) {
                came_from_[there] = here;
                order.push_back(there);
            }
            if (!passes) continue;
            std::vector<std::uint32_t> way = way_back(here);
            way.push_back(there);
            return way;
        }
    }
    if (reached) *reached = std::move(order);
    return {};
}

bool FloorGrid::is_drop(std::uint32_t from, std::uint32_t to) const {
    // Whose middle is over the edge already has hardly a foot left on the ledge.
    return !is_at_most(points_[from].feet_z - map_[points_[to].place.sector].floor.z, kMaxStep);
}

std::vector<std::uint32_t> FloorGrid::way_back(std::uint32_t point) const {
    std::vector<std::uint32_t> way{point};
    while (came_from_[way.back()] != way.back()) way.push_back(came_from_[way.back()]);
    std::ranges::reverse(way);
    return way;
}

void FloorGrid::close(std::uint32_t from, std::uint32_t to) {
    std::ranges::replace(points_[from].next, to, FloorPoint::kNowhere);
}

}  // namespace enfilade::test
