#include "ties/exact_column.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::test {

int Polynomial::sign() const { return c0.sign() != 0 ? c0.sign() : c1.sign() != 0 ? c1.sign() : c2.sign(); }

namespace {

Polynomial operator-(const Polynomial& p, const Polynomial& q) { return {p.c0 - q.c0, p.c1 - q.c1, p.c2 - q.c2}; }
Polynomial operator*(const Polynomial& p, const Integer& k) { return {p.c0 * k, p.c1 * k, p.c2 * k}; }

/// The place along a ray where it meets a line, in lengths of its way.
struct ExactPlace {
    Polynomial numerator;
    Integer denominator;  ///< > 0
};

bool is_before(const ExactPlace& p, const ExactPlace& q) {
    return (p.numerator * q.denominator - q.numerator * p.denominator).sign() < 0;
}

constexpr int kGridBits = 32, kNormalBits = 55;

Integer steps(double x) { return Integer::scaled(x, kGridBits); }

ExactSpace space_of(Vec2 eye, double eye_z, Vec2 forward, double flip, std::int64_t links, double slope) {
    const double right_x = -forward.y * flip, right_y = forward.x * flip;
    const std::int64_t nx = std::llround((forward.x * slope - right_x) * 0x1p55);
    const std::int64_t ny = std::llround((forward.y * slope - right_y) * 0x1p55);
    // Of the two ways along the ray one has nearly the length of the normal along `forward`, the other as much against.
    const bool turns_right = static_cast<double>(nx) * forward.y - static_cast<double>(ny) * forward.x > 0;
    const Integer x = nx, y = ny;
    return {
        eye, eye_z, forward, flip, links, steps(eye.x), steps(eye.y), x, y, turns_right ? -y : y, turns_right ? x : -x};
}

ExactSpace behind(const ExactSpace& space, const Rigid& link, double slope) {
    return space_of(snap_to_point_grid(link.apply(space.eye)), link.apply_height(space.eye_z), link.turn(space.forward),
                    space.flip * link.flip, space.links + 1, slope);
}

/// n.(V - E - (e, e^2))
Polynomial offset(const ExactSpace& space, Vec2 vertex) {
    return {space.normal_x * (steps(vertex.x) - space.eye_x) + space.normal_y * (steps(vertex.y) - space.eye_y),
            -space.normal_x, -space.normal_y};
}

/// cross(b - a, E + (e, e^2) - a)
Polynomial side_of_eye(const ExactSpace& space, const Wall& wall) {
    const Integer dx = steps(wall.b.x) - steps(wall.a.x), dy = steps(wall.b.y) - steps(wall.a.y);
    return {dx * (space.eye_y - steps(wall.a.y)) - dy * (space.eye_x - steps(wall.a.x)), -dy, dx};
}

/// How fast the ray comes nearer to the wall's line: cross(ahead, b - a).
Integer approach(const ExactSpace& space, const Wall& wall) {
    return space.ahead_x * (steps(wall.b.y) - steps(wall.a.y)) - space.ahead_y * (steps(wall.b.x) - steps(wall.a.x));
}

/// None where the ray runs along the line.
std::optional<ExactPlace> place_on_line(const ExactSpace& space, const Wall& wall) {
    const Polynomial side = side_of_eye(space, wall);
    const Integer speed = approach(space, wall);
    if (speed.sign() == 0) return {};
    if (speed.sign() > 0) return ExactPlace{side, speed};
    return ExactPlace{side * -1, -speed};
}

bool is_between_ends(const ExactSpace& space, const Wall& wall) {
    return offset(space, wall.a).sign() != offset(space, wall.b).sign();
}

/// A double taken apart: mantissa * 2^exponent.
struct Dyadic {
    Integer mantissa;
    int exponent;

    static Dyadic of(double x) {
        int exponent = 0;
        const double fraction = std::frexp(x, &exponent);
        return {static_cast<std::int64_t>(fraction * 0x1p53), exponent - 53};
    }
};

Dyadic operator*(const Dyadic& a, const Dyadic& b) { return {a.mantissa * b.mantissa, a.exponent + b.exponent}; }

bool is_at_least(const Dyadic& a, const Dyadic& b) {
    const int least = std::min(a.exponent, b.exponent);
    return (a.mantissa << (a.exponent - least)) >= (b.mantissa << (b.exponent - least));
}

/// Is the ray at `height` above the eye, or higher, where it meets the wall?
bool reaches(const ExactHit& hit, double rise, double focal_y, double height) {
    if (hit.cross.sign() == 0) return height < 0 || (height == 0 && rise >= 0);
    const Dyadic climbed = Dyadic::of(rise) * Dyadic{hit.cross, -2 * kGridBits};
    const Dyadic asked = Dyadic::of(height) * Dyadic::of(focal_y) * Dyadic{hit.across, -kNormalBits - kGridBits};
    return is_at_least(climbed, asked);
}

bool has_picture(const Map& map, SurfaceId surface) { return surface && map.surfaces[surface.index].texture; }

// Told in maps/FORMAT.md.
constexpr std::uint64_t kMostSpent = 65536, kRoom = 32;

std::uint64_t cost_of(const Sector& sector) { return std::uint64_t{sector.wall_count} + sector.panel_count + kRoom; }

}  // namespace

ExactColumn::ExactColumn(const Map& map, const std::vector<Heights>& heights, const View& view, double slope)
    : map_(map), heights_(heights), slope_(slope), view_(view) {}

ExactHit ExactColumn::first_wall(const ExactSpace& space, SectorId sector, WallId entry) const {
    std::optional<ExactPlace> begin, nearest;
    if (entry) {
        Wall back = map_.walls[entry.index];
        std::swap(back.a, back.b);
        if (!is_between_ends(space, back)) return {space, sector, {}, 0, 0};
        begin = place_on_line(space, back);
    }
    WallId met;
    const Sector& room = map_.sectors[sector.index];
    for (std::uint32_t i = room.first_wall; i < room.first_wall + room.wall_count; ++i) {
        const Wall& wall = map_.walls[i];
        if (side_of_eye(space, wall).sign() < 0 || !is_between_ends(space, wall)) continue;
        const auto place = place_on_line(space, wall);
        if (!place || place->numerator.sign() < 0) continue;  // behind the eye
        if ((begin && !is_before(*begin, *place)) || (nearest && !is_before(*place, *nearest))) continue;
        nearest = place;
        met = WallId(i);
    }
    if (!met) return {space, sector, met, 0, 0};
    return {space, sector, met, side_of_eye(space, map_.walls[met.index]).c0, nearest->denominator};
}

const ExactHit& ExactColumn::hit(std::size_t i) {
    while (hits_.size() <= i) {
        if (hits_.empty()) {
            const View& v = view_;
            hits_.push_back(first_wall(space_of(v.eye, v.eye_z, v.forward, v.flip, 0, slope_), v.sector, {}));
            hits_.back().spent = cost_of(map_.sectors[v.sector.index]);
            continue;
        }
        const ExactHit& last = hits_.back();
        const Wall& wall = map_.walls[last.wall.index];
        const bool is_mirror = wall.kind == WallKind::mirror;
        const SectorId sector = is_mirror ? last.sector : wall.behind;
        const ExactSpace space =
            wall.link == Wall::kNoLink ? last.space : behind(last.space, map_.links[wall.link], slope_);
        ExactHit next = first_wall(space, sector, is_mirror ? last.wall : wall.exit);
        next.spent = last.spent + cost_of(map_.sectors[sector.index]);
        hits_.push_back(std::move(next));
    }
    return hits_[i];
}

/// Where the ray ends if it ends at this wall.
std::optional<PixelSurface> ExactColumn::end_at(const ExactHit& hit, double rise, double focal_y) const {
    const Wall& wall = map_.walls[hit.wall.index];
    const auto is_at = [&](double z, double eye_z) { return reaches(hit, rise, focal_y, z - eye_z); };
    const Heights& own = heights_[hit.sector.index];
    if (is_at(own.ceiling_z, hit.space.eye_z)) return ceiling_id(hit.sector);
    if (!is_at(own.floor_z, hit.space.eye_z)) return floor_id(hit.sector);
    if (wall.kind == WallKind::solid || wall.kind == WallKind::way_back)
        return wall_id(map_, hit.wall, WallPart::middle);
    if (wall.kind == WallKind::portal) {
        const bool is_link = wall.link != Wall::kNoLink;
        const double eye_z = is_link ? map_.links[wall.link].apply_height(hit.space.eye_z) : hit.space.eye_z;
        const Heights& there = heights_[wall.behind.index];
        const bool is_sky_to_sky =
            map_.sectors[hit.sector.index].ceiling.sky && map_.sectors[wall.behind.index].ceiling.sky;
        if (is_at(there.ceiling_z, eye_z)) {
            if (has_picture(map_, wall.upper) && !is_sky_to_sky) return wall_id(map_, hit.wall, WallPart::upper);
        } else if (!is_at(there.floor_z, eye_z)) {
            if (has_picture(map_, wall.lower)) return wall_id(map_, hit.wall, WallPart::lower);
        }
    }
    const bool is_too_deep = wall.link != Wall::kNoLink && hit.space.links >= std::int64_t{map_.render.max_depth};
    if (is_too_deep || hit.spent >= kMostSpent) return kRecursionEnd;
    return std::nullopt;
}

std::optional<PixelSurface> ExactColumn::surface(double rise, double focal_y) {
    for (std::size_t i = 0;; ++i) {
        const ExactHit& met = hit(i);
        if (!met.wall) return std::nullopt;
        if (const auto end = end_at(met, rise, focal_y)) return end;
    }
}

}  // namespace enfilade::test
