#include "render/reference/ray_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/result.h"
#include "math/predicates.h"
#include "render/openings.h"
#include "render/segment.h"

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

RayCourse ray_course(const Projection& projection, int x, int y) {
    const Ray ray = projection.ray(x, y);
    if (!projection.is_tilted()) return {0, ray.right, ray.up, 1, projection.row_climb(y)};
    const double aheads[] = {ray.ahead, ray.right, -ray.ahead, -ray.right};
    const double rights[] = {ray.right, -ray.ahead, -ray.right, ray.ahead};
    int best = 0;
    if (!(ray.ahead > 0 && std::fabs(ray.right) <= kMostSlope * ray.ahead))
        best = static_cast<int>(std::max_element(aheads, aheads + 4) - aheads);
    const double ahead = std::max(aheads[best], kLean);
    return {best, rights[best] / ahead, ray.up / ahead, 1 / ahead, {ray.up / ahead + kTieClimb, 1}};
}

View turned(const View& view, int quarters) {
    View turned = view;
    for (; quarters > 0; --quarters) turned.forward = right_of(turned.forward) * view.flip;
    return turned;
}

namespace {

bool faces(const DirectedEdge& edge, Vec2 eye) { return side_of_line(edge.a, edge.b, eye) > 0; }

/// The panel seen from the side on which the eye is.
DirectedEdge turned_to(const Panel& panel, Vec2 eye) {
    const DirectedEdge edge(panel.a, panel.b);
    return faces(edge, eye) ? edge : DirectedEdge(panel.b, panel.a);
}

}  // namespace

RayPath::RayPath(const Map& map, const Presences* things, const View& view, double slope)
    : map_(map), things_(things), slope_(slope), first_sector_(view.sector), first_space_(pose_of(view)) {}

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
    const Pose space = is_linked ? beyond(last.space, map_.passage(wall)) : last.space;
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

void RayPath::start_step(const Pose& space) {
    straying_ = {};
    normal_ = ray_normal(space, slope_);
}

/// For an edge that faces the eye: does the ray, ahead of the eye, run between its ends? Facing, its a is the left end,
/// in a mirror the right one; behind the eye left and right change places, which is why nothing else need be asked.
bool RayPath::covers(const DirectedEdge& edge, const Pose& space) const {
    const bool mirrored = space.flip < 0;
    const Vec2 left = mirrored ? edge.b : edge.a, right = mirrored ? edge.a : edge.b;
    return runs_right_of(normal_, left, space.eye) && !runs_right_of(normal_, right, space.eye);
}

/// For an edge that covers the ray: where it is met, 0 at its a, 1 at its b.
double RayPath::along(const DirectedEdge& edge, const Pose& space) const {
    const auto a = static_cast<double>(offset_left(normal_, edge.a, space.eye)),
               b = static_cast<double>(offset_left(normal_, edge.b, space.eye));
    return a != b ? std::clamp(a / (a - b), 0.0, 1.0) : 0.0;
}

/// Of two edges of a sector, the entry being met from behind and `edge` from the front: is `edge` met later?
bool RayPath::is_beyond_entry(const DirectedEdge& edge) const {
    if (entry_.is_none()) return true;
    const Wall& entry = map_[entry_];
    const int side = side_of_edge(entry, edge);
    return side != 0 ? side > 0 : side_of_edge(edge, entry) > 0;
}

WallId RayPath::nearest_covering(const Pose& space, SectorId sector) const {
    const Sector& s = map_[sector];
    WallId nearest;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& wall = map_.walls[i];
        if (!faces(wall, space.eye) || !covers(wall, space) || !is_beyond_entry(wall)) continue;
        if (nearest.is_none() || is_in_front(wall, map_[nearest])) nearest = WallId(i);
    }
    return nearest;
}

RayHit RayPath::next_hit(const Pose& space, SectorId sector) const {
    RayHit hit;
    hit.space = space;
    hit.sector = sector;
    hit.wall = nearest_covering(space, sector);
    hit.is_missed = hit.wall.is_none();
    if (hit.is_missed) {
        const StandIn missed = stand_in(map_, sector, space, slope_, entry_);
        hit.wall = missed.wall;
        hit.along = missed.along;
        hit.depth.value = missed.depth;
    } else {
        const Wall& wall = map_[hit.wall];
        hit.along = along(wall, space);
        hit.depth = depth_on_wall(wall.a, wall.b, space, normal_);
    }
    if (map_[sector].panel_count != 0) add_panels(hit);
    return hit;
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
        if (!covers(edge, hit.space)) continue;
        const bool is_beyond = entry_.is_none() || are_on_one_line(edge, map_[entry_]) || is_beyond_entry(edge);
        if (!is_beyond || is_in_front(behind, edge)) continue;
        hit.panels.push_back({PanelId(i), along(DirectedEdge(panel.a, panel.b), hit.space),
                              depth_on_wall(edge.a, edge.b, hit.space, normal_)});
    }
    put_in_order(hit);
}

void RayPath::put_in_order(RayHit& hit) const {
    const auto is_before = [&](const PanelHit& p, const PanelHit& q) {
        const DirectedEdge e = turned_to(map_[p.panel], hit.space.eye), f = turned_to(map_[q.panel], hit.space.eye);
        return are_on_one_line(e, f) ? p.panel < q.panel : is_in_front(e, f);
    };
    std::sort(hit.panels.begin(), hit.panels.end(), is_before);
}

}  // namespace enfilade
