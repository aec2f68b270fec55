#include "hard_cases/cut_apart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/angle.h"

namespace enfilade::test {
namespace {

constexpr std::size_t kPieces = 4;
constexpr double kTurnableGrid = 5 * kVertexGrid;

double rounded(double x) { return std::round(x / kTurnableGrid) * kTurnableGrid; }

/// Far from the others, and not by a whole number of tiles of any texture.
Rigid any_move(Move move, std::size_t piece, Random& random) {
    constexpr std::array<Vec2, 4> kQuarters{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    constexpr std::array<Vec2, 4> kTriangles{Vec2{0.6, 0.8}, Vec2{0.8, -0.6}, Vec2{-0.6, 0.8}, Vec2{1, 0}};
    Rigid m;
    const Vec2 turn = move == Move::quarter_turns  ? kQuarters[random.below(4)]
                      : move == Move::other_angles ? kTriangles[random.below(4)]
                                                   : Vec2{1, 0};
    m.c = turn.x;
    m.s = turn.y;
    m.shift = snap_to_vertex_grid(Vec2{1000.0 * static_cast<double>(piece), random.uniform(-500, 500)});
    m.rise = snap_to_vertex_grid(random.uniform(-20, 20));
    return m;
}

Vec2 on_grid(const Rigid& m, Vec2 vertex) { return snap_to_vertex_grid(m.apply(vertex)); }

void bound(Sector& sector, const Map& map) {
    sector.min = sector.max = map.walls[sector.first_wall].a;
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Vec2 v = map.walls[i].a;
        sector.min = {std::min(sector.min.x, v.x), std::min(sector.min.y, v.y)};
        sector.max = {std::max(sector.max.x, v.x), std::max(sector.max.y, v.y)};
    }
}

void move_flat(Flat& flat, const Rigid& m) {
    flat.origin = flat.origin + m.shift;
    flat.z = m.apply_height(flat.z);
}

void move_rooms(Map& map, const std::vector<Rigid>& moves) {
    for (Wall& wall : map.walls) {
        wall.a = on_grid(moves[wall.sector.index], wall.a);
        wall.b = on_grid(moves[wall.sector.index], wall.b);
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        bound(map.sectors[i], map);
        move_flat(map.sectors[i].floor, moves[i]);
        move_flat(map.sectors[i].ceiling, moves[i]);
    }
    for (Panel& panel : map.panels) {
        const Rigid& m = moves[panel.sector.index];
        panel.a = on_grid(m, panel.a);
        panel.b = on_grid(m, panel.b);
        panel.bottom = m.apply_height(panel.bottom);
        panel.top = m.apply_height(panel.top);
    }
    for (Thing& thing : map.things) {
        const Rigid& m = moves[thing.sector.index];
        thing.position = snap_to_point_grid(m.apply(thing.position));
        thing.yaw = thing.yaw + angle_of({m.c, m.s});
        thing.z = m.apply_height(thing.z);
    }
}

void link_pieces(Map& map, const std::vector<Rigid>& moves) {
    for (Wall& wall : map.walls) {
        if (wall.kind != WallKind::portal) continue;
        const Rigid &here = moves[wall.sector.index], &there = moves[wall.behind.index];
        if (here == there) continue;
        const Rigid old = map.passage(wall);
        const Rigid m = then(then(inverse(here), old), there);
        const Wall& exit = map[wall.exit];
        wall.link = static_cast<std::uint32_t>(map.links.size());
        map.links.push_back(m);
        map.grid_links.push_back(GridMap(m, (wall.a + wall.b) * 0.5, (exit.a + exit.b) * 0.5));
    }
}

}  // namespace

CutMap cut_apart(const Map& map, Move move, Random& random) {
    std::vector<Rigid> pieces;
    for (std::size_t i = 0; i < kPieces; ++i) pieces.push_back(any_move(move, i, random));
    CutMap cut{map, {}};
    for (std::size_t i = 0; i < map.sectors.size(); ++i) cut.moves.push_back(pieces[random.below(kPieces)]);
    cut.map.render.max_depth = 1024;  // portals that were plain count now
    move_rooms(cut.map, cut.moves);
    link_pieces(cut.map, cut.moves);
    return cut;
}

Map on_turnable_grid(const Map& map) {
    Map rough = map;
    rough.things.clear();
    rough.solid_things.clear();
    rough.near_things.clear();
    rough.first_near.clear();
    const auto make_rough = [](auto& upright) {
        upright.a = {rounded(upright.a.x), rounded(upright.a.y)};
        upright.b = {rounded(upright.b.x), rounded(upright.b.y)};
        upright.length = std::sqrt(dot(upright.b - upright.a, upright.b - upright.a));
    };
    std::ranges::for_each(rough.walls, make_rough);
    std::ranges::for_each(rough.panels, make_rough);
    for (Sector& sector : rough.sectors) bound(sector, rough);
    return rough;
}

View moved(const View& view, const CutMap& cut) {
    const Rigid& m = cut.moves[view.sector.index];
    View there = view;
    there.eye = snap_to_point_grid(m.apply(view.eye));
    there.eye_z = m.apply_height(view.eye_z);
    there.forward = m.turn(view.forward);
    return there;
}

}  // namespace enfilade::test
