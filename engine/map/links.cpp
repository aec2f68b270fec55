// What linked portals and mirrors do to whatever passes or looks through them: one rigid map each.
#include <cmath>
#include <utility>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/sector_finder.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

Vec2 middle(const Wall& w) { return (w.a + w.b) * 0.5; }

/// |b - a|^2 in squared steps of the vertex grid: a whole number below 2^53, exact.
Int128 square_in_steps(const Wall& w) {
    const Vec2 e = w.b - w.a;
    return static_cast<Int128>(dot(e, e) / (kVertexGrid * kVertexGrid));
}

/// True where the lengths differ by no more than one grid step. With squares l <= m: sqrt(m) - sqrt(l) <= 1, which
/// is m - l - 1 <= 2 sqrt(l).
bool lengths_agree(const Wall& a, const Wall& b) {
    Int128 l = square_in_steps(a), m = square_in_steps(b);
    if (l > m) std::swap(l, m);
    const Int128 excess = m - l - 1;
    return excess <= 0 || excess * excess <= 4 * l;
}

/// (cos, sin) of the turn that lays `from` along `onto`, whose lengths agree. Quarter turns come out exact; other
/// angles as the fractions of whole numbers that they are, each rounded once.
Vec2 turn_between(Vec2 from, Vec2 onto) {
    const double along = dot(from, onto), across = cross(from, onto);
    if (across == 0) return {along > 0 ? 1.0 : -1.0, 0};
    if (along == 0) return {0, across > 0 ? 1.0 : -1.0};
    const double from_2 = dot(from, from), onto_2 = dot(onto, onto);
    const double product = from_2 == onto_2 ? from_2 : std::sqrt(from_2 * onto_2);
    return {along / product, across / product};
}

/// Wall onto wall: midpoint onto midpoint, facing reversed.
Rigid passage_between(const Wall& from, const Wall& onto, double rise) {
    const Vec2 turn = turn_between(from.b - from.a, onto.a - onto.b);
    Rigid m{turn.x, turn.y, 1, {}, rise};
    m.shift = middle(onto) - m.turn(middle(from));
    return m;
}

/// The reflection about the wall's line: c and s are those of twice its angle.
Rigid reflect(const Wall& w) {
    const Vec2 e = w.b - w.a;
    const double square = dot(e, e);
    Rigid m{(e.x * e.x - e.y * e.y) / square, 2 * e.x * e.y / square, -1, {}, 0};
    m.shift = middle(w) - m.turn(middle(w));
    return m;
}

void add_link(Map& map, Wall& wall, const Rigid& m) {
    wall.link = static_cast<std::uint32_t>(map.links.size());
    map.links.push_back(m);
    settle_grid_link(map, wall);
}

/// True where the wall's exit leads back through the wall itself.
bool is_two_way(const Draft& draft, WallId id) {
    const Wall& exit = draft.map[draft.map[id].exit];
    return exit.exit == id && !draft.walls[draft.map[id].exit.index].record->via.empty();
}

/// What the author gave, here or as the way back's; else floor on floor.
double rise_of(const Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    if (const auto given = draft.walls[id.index].record->rise) return *given;
    const auto back = is_two_way(draft, id) ? draft.walls[wall.exit.index].record->rise : std::optional<double>();
    if (back) return -*back;
    return draft.map[wall.behind].floor.z - draft.map[wall.sector].floor.z;
}

void check_lengths(Draft& draft, WallId id) {
    const Wall &wall = draft.map[id], &exit = draft.map[wall.exit];
    if (lengths_agree(wall, exit)) return;
    draft.error(*draft.walls[id.index].record, "via", "link-lengths",
                "expected linked walls of one length, found " + number_text(wall.length) + " m here and " +
                    number_text(exit.length) + " m at " + in_quotes(draft.walls[id.index].record->via) + " of sector " +
                    in_quotes(draft.map[wall.behind].name) + "; a link cannot stretch what passes");
}

void check_rises(Draft& draft, WallId id) {
    const auto there = draft.walls[id.index].record->rise;
    const auto back = draft.walls[draft.map[id].exit.index].record->rise;
    const bool is_later = draft.map[id].exit <= id;  // one of the two is enough
    if (!is_later || !is_two_way(draft, id) || !there || !back || *there == -*back) return;
    draft.error(*draft.walls[id.index].record, "rise", "link-rise",
                "the way back is the way there reversed: this wall says rise = " + number_text(*there) +
                    " and its other side rise = " + number_text(*back) + ", expected " + number_text(-*there) +
                    "; give rise on one side only");
}

/// An opening nobody can pass or look through, though both rooms are open.
void check_opening(Draft& draft, WallId id, double rise) {
    const Wall& wall = draft.map[id];
    const Sector &here = draft.map[wall.sector], &there = draft.map[wall.behind];
    const double floor = there.floor.z - rise, ceiling = there.ceiling.z - rise;
    const bool both_open = here.floor.z < here.ceiling.z && floor < ceiling;
    if (!both_open || (floor < here.ceiling.z && ceiling > here.floor.z)) return;
    draft.warning(*draft.walls[id.index].record, draft.walls[id.index].record->rise ? "rise" : "via", "link-closed",
                  "nothing fits through this link: the room here is open from " + number_text(here.floor.z) + " to " +
                      number_text(here.ceiling.z) + " m, the one behind, seen from here, from " + number_text(floor) +
                      " to " + number_text(ceiling) + " m; check rise");
}

void link_portal(Draft& draft, WallId id) {
    Wall& wall = draft.map.walls[id.index];
    const Wall& exit = draft.map[wall.exit];
    if (wall.a == wall.b || exit.a == exit.b) return;
    check_lengths(draft, id);
    check_rises(draft, id);
    const double rise = rise_of(draft, id);
    check_opening(draft, id, rise);
    // The way back is the inverse of the way there, never derived again: going and coming must cancel.
    const bool is_way_back = is_two_way(draft, id) && exit.link != Wall::kNoLink;
    const Rigid m = is_way_back ? inverse(draft.map.links[exit.link]) : passage_between(wall, exit, rise);
    add_link(draft.map, wall, m);
}

/// A way back is the inverse of the way there.
void link_way_back(Map& map, WallId id) {
    Wall& wall = map.walls[id.index];
    const Wall& there = map[wall.exit];
    if (wall.kind != WallKind::way_back || there.link == Wall::kNoLink) return;
    add_link(map, wall, inverse(map.links[there.link]));
}

/// Who comes out of a wall that does not always lead back is in it for a while (world/body.h).
void mark_one_way_exit(Map& map, WallId id) {
    const Wall& wall = map[id];
    if (wall.kind != WallKind::portal || wall.blocks || !wall.exit) return;
    Wall& exit = map.walls[wall.exit.index];
    if (exit.exit != id || exit.kind == WallKind::way_back) exit.one_way_exit = true;
}

void mark_screens(Map& map) {
    for (std::size_t i = 0; i < map.walls.size(); ++i) mark_one_way_exit(map, WallId(i));
    for (const Wall& wall : map.walls)
        if (wall.is_screen()) map.sectors[wall.sector.index].has_screens = true;
}

}  // namespace

void link_walls(Draft& draft) {
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) {
        Wall& wall = draft.map.walls[i];
        if (wall.kind == WallKind::mirror && wall.a != wall.b) add_link(draft.map, wall, reflect(wall));
        if (wall.kind == WallKind::portal && wall.exit && !draft.walls[i].record->via.empty())
            link_portal(draft, WallId(i));
    }
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) link_way_back(draft.map, WallId(i));
    mark_screens(draft.map);
}

}  // namespace enfilade
