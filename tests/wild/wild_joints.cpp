// What joins the sectors of a wild world: doorways, links by any turn, mirrors, and rooms beside walls.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "math/predicates.h"
#include "support/map_builder.h"
#include "wild/plans.h"

namespace enfilade::test {
namespace {

using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;

Ends ends_of(Vec2 a, Vec2 b) { return {{a.x, a.y}, {b.x, b.y}}; }

/// A name of its own.
void name(WorldPlan& plan, const WallPlace& place) {
    std::string& name = wall_at(plan, place).name;
    if (name.empty()) name = "w" + std::to_string(place.loop) + "_" + std::to_string(place.wall);
}

/// From one wall onto another of the same length.
void lead(WorldPlan& plan, const WallPlace& from, const WallPlace& onto) {
    name(plan, from);
    name(plan, onto);
    WallRecord& wall = wall_at(plan, from);
    wall.next = plan.file.sectors[onto.sector].name;
    wall.via = wall_at(plan, onto).name;
}

/// Open both ways, both closed, shut to walkers, or open one way only.
void join(WorldPlan& plan, const WallPlace& here, const WallPlace& there, Choices& choices) {
    const std::uint64_t kind = choices.below(16);
    if (kind == 15) return;
    if (kind == 14) {
        lead(plan, here, there);
        wall_at(plan, here).way_back = choices.one_in(2);
        return;
    }
    wall_at(plan, here).next = plan.file.sectors[there.sector].name;
    wall_at(plan, there).next = plan.file.sectors[here.sector].name;
    wall_at(plan, here).blocks = kind == 13;
    if (kind == 12) wall_at(plan, here).middle = spec("lattice");
}

/// Whether build_map takes them for equally long: not more than a grid step apart.
bool are_of_one_length(Vec2 d, Vec2 e) {
    return std::fabs(std::sqrt(dot(d, d)) - std::sqrt(dot(e, e))) < 0.99 * kVertexGrid;
}

/// There and back, or one way; floor on floor, or raised.
void link(WorldPlan& plan, const WallPlace& here, const WallPlace& there, Choices& choices) {
    lead(plan, here, there);
    const bool is_itself = here.sector == there.sector && here.loop == there.loop && here.wall == there.wall;
    WallRecord& wall = wall_at(plan, here);
    if (choices.one_in(3) && !is_itself) wall.rise = choices.between(-1, 1) * std::min(plan.size, 4.0);
    if (!is_itself && choices.one_in(4))
        wall.way_back = choices.one_in(2);
    else if (!is_itself)
        lead(plan, there, here);
}

/// Any turn: whole quarters, hair's breadths and everything between [radians].
double any_turn(Choices& choices) {
    constexpr double kDegree = std::numbers::pi / 180;
    switch (choices.below(4)) {
        case 0: return static_cast<double>(choices.below(4)) * 90 * kDegree;
        case 1: return choices.between(0.001, 0.01) * kDegree;
        case 2: return choices.between(179.99, 179.999) * kDegree;
        default: return choices.between(0.001, 179.999) * kDegree;
    }
}

/// A triangle of a room whose first wall is a -> b; none where the grid, or the world, has no room for it.
std::optional<WallPlace> add_room(WorldPlan& plan, Vec2 a, Vec2 b, Choices& choices) {
    const double depth = choices.between(0.05, 2);
    const Vec2 apex = snap_to_vertex_grid(a + (b - a) * choices.between(-0.5, 1.5) + right_of(b - a) * depth);
    for (const Vec2 p : {a, b, apex})
        if (std::max(std::fabs(p.x), std::fabs(p.y)) > kWorldLimit) return {};
    if (corner(a, b, apex) <= 0) return {};
    const std::size_t number = plan.file.sectors.size();
    plan.file.sectors.push_back(room("s" + std::to_string(number), {a, b, apex}));
    plan.ground.push_back({number, a, b, apex});
    return WallPlace{number, 0, 0};
}

/// A room on the other side of a wall, whatever else is there.
void add_porch(WorldPlan& plan, const WallPlace& here, Choices& choices) {
    if (const auto there = add_room(plan, end_of(plan, here), start_of(plan, here), choices))
        join(plan, here, *there, choices);
}

/// A room anywhere, turned by anything, and a link to it.
void add_annex(WorldPlan& plan, const WallPlace& here, Choices& choices) {
    const Vec2 d = end_of(plan, here) - start_of(plan, here);
    const double turn = any_turn(choices), c = std::cos(turn), s = std::sin(turn);
    const double reach = kWorldLimit / 2;
    const Vec2 a = snap_to_vertex_grid(Vec2{choices.between(-reach, reach), choices.between(-reach, reach)});
    const Vec2 b = snap_to_vertex_grid(a + Vec2{c * d.x - s * d.y, s * d.x + c * d.y});
    if (a == b || !are_of_one_length(d, b - a)) return;
    if (const auto there = add_room(plan, a, b, choices)) link(plan, here, *there, choices);
}

/// A link to whatever solid wall fits, this one included.
void link_somewhere(WorldPlan& plan, const WallPlace& here, const std::vector<WallPlace>& solid, Choices& choices) {
    std::vector<WallPlace> fitting;
    const Vec2 d = end_of(plan, here) - start_of(plan, here);
    for (const WallPlace& there : solid)
        if (are_of_one_length(d, end_of(plan, there) - start_of(plan, there))) fitting.push_back(there);
    link(plan, here, choices.any(fitting), choices);
}

}  // namespace

std::vector<WallPlace> solid_walls(const WorldPlan& plan) {
    std::vector<WallPlace> walls;
    for (std::size_t s = 0; s < plan.file.sectors.size(); ++s)
        for (std::size_t l = 0; l < plan.file.sectors[s].loops.size(); ++l)
            for (std::size_t w = 0; w < plan.file.sectors[s].loops[l].walls.size(); ++w) {
                const WallRecord& wall = plan.file.sectors[s].loops[l].walls[w];
                if (wall.next.empty() && !wall.mirror && wall.name.empty()) walls.push_back({s, l, w});
            }
    return walls;
}

WallRecord& wall_at(WorldPlan& plan, const WallPlace& place) {
    return plan.file.sectors[place.sector].loops[place.loop].walls[place.wall];
}

Vec2 start_of(const WorldPlan& plan, const WallPlace& place) {
    return plan.file.sectors[place.sector].loops[place.loop].vertices[place.wall];
}

Vec2 end_of(const WorldPlan& plan, const WallPlace& place) {
    const std::vector<Vec2>& vertices = plan.file.sectors[place.sector].loops[place.loop].vertices;
    return vertices[(place.wall + 1) % vertices.size()];
}

void join_neighbours(WorldPlan& plan, std::size_t first_sector, Choices& choices) {
    std::map<Ends, WallPlace> seen;
    for (const WallPlace& here : solid_walls(plan)) {
        if (here.sector < first_sector) continue;
        const Vec2 a = start_of(plan, here), b = end_of(plan, here);
        const auto twin = seen.find(ends_of(b, a));
        if (twin != seen.end() && twin->second.sector != here.sector)
            join(plan, here, twin->second, choices);
        else
            seen[ends_of(a, b)] = here;
    }
}

void add_joint(WorldPlan& plan, Choices& choices) {
    const std::vector<WallPlace> solid = solid_walls(plan);
    if (solid.empty()) return;
    const WallPlace here = choices.any(solid);
    switch (choices.below(4)) {
        case 0: return link_somewhere(plan, here, solid, choices);
        case 1: return add_annex(plan, here, choices);
        case 2: return add_porch(plan, here, choices);
        default: wall_at(plan, here).mirror = true;
    }
}

}  // namespace enfilade::test
