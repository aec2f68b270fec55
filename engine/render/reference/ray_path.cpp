#include "render/reference/ray_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/result.h"
#include "math/predicates.h"
#include "render/openings.h"

namespace enfilade {

int side_of_edge(const DirectedEdge& line, const DirectedEdge& e) {
    const int a = corner(line.a, line.b, e.a), b = corner(line.a, line.b, e.b);
    if (a * b < 0) return 0;
    return (a + b > 0) - (a + b < 0);
}

bool are_on_one_line(const DirectedEdge& e, const DirectedEdge& f) {
    return corner(e.a, e.b, f.a) == 0 && corner(e.a, e.b, f.b) == 0;
}

bool is_in_front(const DirectedEdge& e, const DirectedEdge& f) {
    const int side = side_of_edge(e, f);
    return side != 0 ? side < 0 : side_of_edge(f, e) > 0;
}

namespace {

/// Straight down is down and this much ahead: a hair on any floor [1].
constexpr double kLean = 0x1p-40;

}  // namespace

RayCourse ray_course(const Ray& ray) {
    const double aheads[] = {ray.ahead, ray.right, -ray.ahead, -ray.right};
    const double rights[] = {ray.right, -ray.ahead, -ray.right, ray.ahead};
    int best = 0;
    if (!(ray.ahead > 0 && std::fabs(ray.right) <= kMostSlope * ray.ahead))
        best = static_cast<int>(std::max_element(aheads, aheads + 4) - aheads);
    const double ahead = std::max(aheads[best], kLean);
    return {best, rights[best] / ahead, ray.up / ahead, 1 / ahead};
}

View turned(const View& view, int quarters) {
    View turned = view;
    for (; quarters > 0; --quarters) turned.forward = right_of(turned.forward) * view.flip;
    return turned;
}

namespace {

/// Steps of the ray's normal per unit: with slopes up to tan(89.5 degrees) it fits 62 bits.
constexpr double kNormalSteps = 0x1p55;
/// What offset() counts in, as metres.
constexpr double kOffsetUnit = 0x1p-87;

bool faces(const DirectedEdge& edge, Vec2 eye) { return side_of_line(edge.a, edge.b, eye) > 0; }

/// The panel seen from the side on which the eye is.
DirectedEdge turned_to(const Panel& panel, Vec2 eye) {
    const DirectedEdge edge(panel.a, panel.b);
    return faces(edge, eye) ? edge : DirectedEdge(panel.b, panel.a);
}

/// Nearer to each other than anybody should rely on. Two walls that both pass through the eye are at depth 0 exactly.
bool are_close_depths(double depth, double other) {
    return std::fabs(depth - other) < kAmbiguous && (depth != 0 || other != 0);
}

EyeSpace through(const Rigid& link, const EyeSpace& space) {
    return {snap_to_point_grid(link.apply(space.eye)), link.apply_height(space.eye_z), link.turn(space.forward),
            space.flip * link.flip, space.links + 1};
}

}  // namespace

RayPath::RayPath(const Map& map, const Presences* things, const View& view, double slope)
    : map_(map),
      things_(things),
      slope_(slope),
      first_sector_(view.sector),
      first_space_{view.eye, view.eye_z, view.forward, view.flip, 0} {}

const RayHit& RayPath::operator[](std::size_t i) {
    while (hits_.size() <= i) add_next();
    return hits_[i];
}

void RayPath::add_next() {
    if (hits_.empty()) {
        start_step(first_space_);
        return add(next_hit(first_space_, first_sector_), cost_of_look_into(map_[first_sector_], 0));
    }
    const RayHit last = hits_.back();
    ENFILADE_CHECK(!last.comes_round);
    const Wall& wall = map_[last.wall];
    ENFILADE_CHECK(wall.kind != WallKind::solid);
    const bool is_mirror = wall.kind == WallKind::mirror;
    const bool is_linked = wall.link != Wall::kNoLink;
    entry_ = is_mirror ? last.wall : wall.exit;
    entry_depth_ = last.depth;
    const EyeSpace space = is_linked ? through(map_.passage(wall), last.space) : last.space;
    if (is_linked) start_step(space);
    const SectorId sector = is_mirror ? last.sector : wall.behind;
    add(next_hit(space, sector),
        last.spent + cost_of_look_into(map_[sector], things_ ? things_->in(sector).size() : 0));
}

void RayPath::add(RayHit hit, std::uint32_t spent) {
    hit.spent = spent;
    hit.comes_round = straying_.comes_round_to(hit.wall, hit.is_missed);
    hits_.push_back(std::move(hit));
}

void RayPath::start_step(const EyeSpace& space) {
    straying_ = {};
    const Vec2 normal = space.forward * slope_ - right_of(space.forward) * space.flip;
    normal_x_ = std::llround(normal.x * kNormalSteps);
    normal_y_ = std::llround(normal.y * kNormalSteps);
    // With the eye at eye + (e, e^2) every offset changes by -(normal_x e + normal_y e^2).
    side_of_tie_ = normal_x_ != 0 ? (normal_x_ < 0 ? 1 : -1) : (normal_y_ < 0 ? 1 : -1);
}

/// How far the vertex is to the left of the ray, times the normal's length: slope * z - x of view space, exactly.
Int128 RayPath::offset(Vec2 vertex, Vec2 eye) const {
    return Int128{normal_x_} * (to_grid_units(vertex.x) - to_grid_units(eye.x)) +
           Int128{normal_y_} * (to_grid_units(vertex.y) - to_grid_units(eye.y));
}

/// 1 left of the ray, -1 right of it. Never 0.
int RayPath::side(Vec2 vertex, Vec2 eye) const {
    const Int128 o = offset(vertex, eye);
    return o != 0 ? (o > 0 ? 1 : -1) : side_of_tie_;
}

/// For an edge that faces the eye: does the ray, ahead of the eye, run between its ends? Facing, its a is the left end,
/// in a mirror the right one; behind the eye left and right change places, which is why nothing else need be asked.
bool RayPath::covers(const DirectedEdge& edge, const EyeSpace& space) const {
    const bool mirrored = space.flip < 0;
    const Vec2 left = mirrored ? edge.b : edge.a, right = mirrored ? edge.a : edge.b;
    return side(left, space.eye) > 0 && side(right, space.eye) < 0;
}

/// For an edge that faces the eye and covers the ray.
double RayPath::depth_of(const DirectedEdge& edge, const EyeSpace& space) const {
    const Int128 across = offset(edge.a, space.eye) - offset(edge.b, space.eye);
    return exact_cross(edge.a, edge.b, space.eye) / (static_cast<double>(across) * kOffsetUnit * space.flip);
}

/// Of two edges of a sector, the entry being met from behind and `edge` from the front: is `edge` met later?
bool RayPath::is_beyond_entry(const DirectedEdge& edge) const {
    if (entry_.is_none()) return true;
    const Wall& entry = map_[entry_];
    const int side = side_of_edge(entry, edge);
    return side != 0 ? side > 0 : side_of_edge(edge, entry) > 0;
}

WallId RayPath::nearest_covering(const EyeSpace& space, SectorId sector) const {
    const Sector& s = map_[sector];
    WallId nearest;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map_.walls[i];
        if (!faces(wall, space.eye) || !covers(wall, space) || !is_beyond_entry(wall)) continue;
        if (nearest.is_none() || is_in_front(wall, map_[nearest])) nearest = WallId(i);
    }
    return nearest;
}

/// The wall that is nearest to being covered. Rounding the eye onto the grid behind a link can put a ray that came in
/// at the very edge of a doorway just outside it, where a narrow room has no wall for it. Some wall of a closed outline
/// always faces the eye, so there always is an answer.
WallId RayPath::least_missed(const EyeSpace& space, SectorId sector) const {
    const Sector& s = map_[sector];
    WallId best;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map_.walls[i];
        if (!faces(wall, space.eye)) continue;
        const double a = static_cast<double>(offset(wall.a, space.eye)) * space.flip;
        const double b = static_cast<double>(offset(wall.b, space.eye)) * space.flip;
        const double missed = std::max({-a, b, 0.0}) + (is_beyond_entry(wall) ? 0.0 : kWorldLimit / kOffsetUnit);
        if (missed < least) {
            least = missed;
            best = WallId(i);
        }
    }
    return best;
}

RayHit RayPath::next_hit(const EyeSpace& space, SectorId sector) const {
    RayHit hit;
    hit.space = space;
    hit.sector = sector;
    hit.wall = nearest_covering(space, sector);
    hit.is_missed = hit.wall.is_none();
    if (hit.is_missed) hit.wall = least_missed(space, sector);
    const Wall& wall = map_[hit.wall];
    const auto a = static_cast<double>(offset(wall.a, space.eye)), b = static_cast<double>(offset(wall.b, space.eye));
    hit.along = a != b ? std::clamp(a / (a - b), 0.0, 1.0) : 0.0;
    if (hit.is_missed) {
        const Vec2 place = wall.a + (wall.b - wall.a) * hit.along;
        hit.depth = std::max(entry_depth_, dot(space.forward, place - space.eye));
    } else {
        hit.depth = depth_of(wall, space);
    }
    hit.ambiguous = hit.is_missed || is_ambiguous(hit);
    if (map_[sector].panel_count != 0) add_panels(hit);
    return hit;
}

/// An end of the edge, between the entry and the hit, is within kAmbiguous of the ray.
bool RayPath::ends_near_ray(const DirectedEdge& edge, const RayHit& hit) const {
    const EyeSpace& space = hit.space;
    const double normal_length = std::sqrt(1 + slope_ * slope_);
    const auto ahead = [&](Vec2 vertex) { return dot(space.forward, vertex - space.eye); };
    const auto is_near_ray = [&](Vec2 vertex) {
        const double beside = static_cast<double>(offset(vertex, space.eye)) * kOffsetUnit / normal_length;
        return std::fabs(beside) < kAmbiguous && ahead(vertex) > entry_depth_ - kAmbiguous && vertex != space.eye;
    };
    return (is_near_ray(edge.a) || is_near_ray(edge.b)) &&
           std::min(ahead(edge.a), ahead(edge.b)) < hit.depth + kAmbiguous;
}

/// Could the ray, moved by kAmbiguous, meet another wall of the sector first? Then the end of a wall that faces the eye
/// and is not wholly behind the hit is that near to the ray, or another wall is that near to the entry or the hit. An
/// end at the very eye, a wall through the very eye and the other side of the entry are decided exactly in any
/// renderer.
bool RayPath::is_ambiguous(const RayHit& hit) const {
    const EyeSpace& space = hit.space;
    const Wall* entry = entry_.is_none() ? nullptr : &map_[entry_];
    if (entry && are_close_depths(entry_depth_, hit.depth)) return true;
    const Sector& s = map_[hit.sector];
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map_.walls[i];
        if (!faces(wall, space.eye)) continue;
        if (ends_near_ray(wall, hit)) return true;
        const bool is_back_of_entry = entry && ((wall.a == entry->b && wall.b == entry->a) || i == entry_.index);
        if (WallId(i) == hit.wall || is_back_of_entry || !covers(wall, space)) continue;
        const double depth = depth_of(wall, space);
        if (are_close_depths(depth, hit.depth) || (entry && are_close_depths(depth, entry_depth_))) return true;
    }
    return false;
}

/// The panels of the sector between the entry and the hit, by the order of the ray; where panels, or a panel and the
/// wall behind it, are on one line, the panel with the lower number and the panel is the first.
void RayPath::add_panels(RayHit& hit) const {
    const Sector& s = map_[hit.sector];
    const Wall& behind = map_[hit.wall];
    for (std::uint32_t i = s.first_panel; i < s.first_panel + s.panel_count; ++i) {
        const Panel& panel = map_.panels[i];
        if (!panel.surface.texture) continue;
        if (panel.one_sided && !faces(DirectedEdge(panel.a, panel.b), hit.space.eye)) continue;
        const DirectedEdge edge = turned_to(panel, hit.space.eye);
        hit.ambiguous |= ends_near_ray(edge, hit);
        if (!covers(edge, hit.space)) continue;
        PanelHit met{PanelId(i), 0, depth_of(edge, hit.space)};
        hit.ambiguous |= !are_on_one_line(edge, behind) && are_close_depths(met.depth, hit.depth);
        hit.ambiguous |= entry_ && !are_on_one_line(edge, map_[entry_]) && are_close_depths(met.depth, entry_depth_);
        const bool is_beyond = entry_.is_none() || are_on_one_line(edge, map_[entry_]) || is_beyond_entry(edge);
        if (!is_beyond || is_in_front(behind, edge)) continue;
        const auto a = static_cast<double>(offset(panel.a, hit.space.eye));
        const auto b = static_cast<double>(offset(panel.b, hit.space.eye));
        met.along = a != b ? std::clamp(a / (a - b), 0.0, 1.0) : 0.0;
        hit.panels.push_back(met);
    }
    put_in_order(hit);
}

void RayPath::put_in_order(RayHit& hit) const {
    const auto is_before = [&](const PanelHit& p, const PanelHit& q) {
        const DirectedEdge e = turned_to(map_[p.panel], hit.space.eye), f = turned_to(map_[q.panel], hit.space.eye);
        return are_on_one_line(e, f) ? p.panel < q.panel : is_in_front(e, f);
    };
    std::sort(hit.panels.begin(), hit.panels.end(), is_before);
    double depth = 0;
    for (PanelHit& met : hit.panels) depth = met.depth = std::max(depth, met.depth);
}

}  // namespace enfilade
