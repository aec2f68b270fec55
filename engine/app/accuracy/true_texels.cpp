#include "app/accuracy/true_texels.h"

#include <algorithm>
#include <cmath>

#include "render/openings.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

struct QuadVec {
    Quad x, y;
};
QuadVec way_from(Vec2 b, Vec2 a) { return {Quad(a.x) - b.x, Quad(a.y) - b.y}; }
Quad cross(QuadVec a, QuadVec b) { return a.x * b.y - a.y * b.x; }

/// Newton's method from the nearest double: good to all bits.
Quad square_root(Quad x) {
    Quad root = std::sqrt(static_cast<double>(x));
    for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
    return root;
}

/// A sector's heights above the eye.
struct EyeHeights {
    double floor, ceiling;
};

EyeHeights heights_from(const Snapshot& snapshot, SectorId sector, double eye_z) {
    const Heights heights = heights_at(snapshot, sector);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

double peg_height(Peg peg, const EyeHeights& own, const EyeHeights& behind) {
    switch (peg) {
        case Peg::ceiling: return own.ceiling;
        case Peg::floor: return own.floor;
        case Peg::opening_top: return std::min(own.ceiling, behind.ceiling);
        case Peg::opening_bottom: return std::max(own.floor, behind.floor);
    }
    return own.ceiling;
}

/// From one place to another on a tile that repeats, the shorter way round [tiles].
double way(Quad from, double to) {
    constexpr double kManyTiles = 0x1p40;  // farther than any place is
    const Quad apart = from - to + kManyTiles;
    const Quad whole = static_cast<Quad>(static_cast<std::int64_t>(apart));
    const double part = static_cast<double>(apart - whole);
    return std::min(part, 1 - part);
}

}  // namespace

TrueColumn::TrueColumn(const Map& map, const Snapshot& snapshot, const View& view, int width, int height, int x)
    : map_(map),
      snapshot_(snapshot),
      projection_(view, width, height),
      max_depth_(map.render.max_depth),
      slope_(Quad(2 * (x - projection_.middle_column())) / width * projection_.half_fov_tangent()),
      path_(map, &snapshot.things, view, projection_.slope(x)) {}

TrueColumn::Met TrueColumn::met(std::size_t i) {
    const RayHit& hit = path_[i];
    const Wall& wall = map_[hit.wall];
    const Vec2 forward = hit.space.forward, right = right_of(forward) * hit.space.flip;
    const QuadVec ray{forward.x + slope_ * right.x, forward.y + slope_ * right.y};
    const QuadVec to_a = way_from(hit.space.eye, wall.a), along = way_from(wall.a, wall.b);
    const Quad turn = cross(ray, along);
    if (turn == 0) return {&hit, Quad(hit.depth.value), Quad(hit.along)};  // the eye is on its line
    return {&hit, cross(to_a, along) / turn, cross(to_a, ray) / turn};
}

/// Is the ray at `height` above the eye, or higher, at this depth? By the tie rule for rows.
bool TrueColumn::is_above(Quad climb, Quad depth, double height) const {
    if (depth == 0 && height == 0) return climb >= 0;
    return (climb + kTieClimb) * depth >= height;
}

TrueTexel TrueColumn::on_wall(const Met& at, SurfaceId id, WallPart part, Quad climb, double peg) const {
    const Wall& wall = map_[at.hit->wall];
    const Surface surface = picture_now(map_, snapshot_, at.hit->wall, id);
    const QuadVec along = way_from(wall.a, wall.b);
    const Quad length = square_root(along.x * along.x + along.y * along.y);
    return {wall_id(map_, at.hit->wall, part), surface.texture,
            at.along * length / surface.tile_m.x - surface.offset_tiles.x,
            (peg - climb * at.depth) / surface.tile_m.y - surface.offset_tiles.y};
}

std::optional<TrueTexel> TrueColumn::on_flat(const Met& at, bool is_floor, Quad climb, const RowClimb& tied,
                                             double height) const {
    const SectorId sector = at.hit->sector;
    const FlatNow flat = is_floor ? floor_now(map_, snapshot_, sector) : ceiling_now(map_, snapshot_, sector);
    if (flat.sky) return {};
    const bool is_tied = height > 0 && climb < kAlmostLevel && tied.rise > 0;
    const Quad crossed = is_tied ? Quad(height) * tied.run / tied.rise : climb == 0 ? at.depth : height / climb;
    const Quad depth = crossed < 0 ? 0 : crossed < at.depth ? crossed : at.depth;
    const RayHit& hit = *at.hit;
    const Vec2 forward = hit.space.forward, right = right_of(forward) * hit.space.flip;
    const Quad x = hit.space.eye.x + (forward.x + slope_ * right.x) * depth - flat.origin.x;
    const Quad y = hit.space.eye.y + (forward.y + slope_ * right.y) * depth - flat.origin.y;
    const Surface& surface = flat.surface;
    return TrueTexel{is_floor ? floor_id(sector) : ceiling_id(sector), surface.texture,
                     x / surface.tile_m.x - surface.offset_tiles.x, y / surface.tile_m.y - surface.offset_tiles.y};
}

std::optional<TrueTexel> TrueColumn::at(int y) {
    const Quad climb = Quad(projection_.row_from_horizon(y)) / projection_.focal_y();
    const RowClimb tied = projection_.row_climb(y);
    for (std::size_t i = 0;; ++i) {
        const Met at = met(i);
        const RayHit& hit = *at.hit;
        const Wall& wall = map_[hit.wall];
        const EyeHeights own = heights_from(snapshot_, hit.sector, hit.space.eye_z);
        if (is_above(climb, at.depth, own.ceiling)) return on_flat(at, false, climb, tied, own.ceiling);
        if (!is_above(climb, at.depth, own.floor)) return on_flat(at, true, climb, tied, own.floor);
        const WallKind kind = kind_now(map_, snapshot_, hit.wall);
        const auto painted = [&](SurfaceId surface, WallPart part, const EyeHeights& behind) {
            return on_wall(at, surface, part, climb, peg_height(map_[surface].peg, own, behind));
        };
        if (kind == WallKind::solid) return painted(wall.texture, WallPart::middle, own);
        if (kind == WallKind::portal) {
            const double eye_z = map_.passage(wall).apply_height(hit.space.eye_z);
            const EyeHeights behind = heights_from(snapshot_, wall.behind, eye_z);
            const bool above = is_above(climb, at.depth, behind.ceiling);
            if (above && has_upper_step(map_, wall)) return painted(wall.upper, WallPart::upper, behind);
            if (!above && !is_above(climb, at.depth, behind.floor) && has_lower_step(map_, wall))
                return painted(wall.lower, WallPart::lower, behind);
        }
        if (hit.spent >= kLookBudget || (wall.link != Wall::kNoLink && hit.space.links >= max_depth_)) return {};
    }
}

double texel_error(const TrueTexel& truth, TexelPosition drawn, std::uint32_t width, std::uint32_t height) {
    return std::max(way(truth.u, drawn.u) * width, way(truth.v, drawn.v) * height);
}

}  // namespace enfilade
