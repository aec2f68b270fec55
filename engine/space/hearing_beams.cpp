// How a listening goes on from tile to tile. As seen from a root outside a tile, looking in through an edge: the edge's
// end is on the left, its start on the right. Seen from inside, looking out, it is the other way round.
#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "space/hearing.h"
#include "space/reach.h"

namespace enfilade {
namespace {

double length_of(Vec2 v) { return std::sqrt(dot(v, v)); }

Vec2 unit_or_zero(Vec2 v) {
    const double length = length_of(v);
    return length > 0 ? v * (1 / length) : Vec2{};
}

/// Where the look from the root through `through` meets the edge; `end`, on that side, where the two are parallel.
Vec2 meeting(Vec2 root, Vec2 through, Vec2 a, Vec2 b, Vec2 end) {
    if (through == end) return end;
    const Vec2 ahead = through - root;
    const double approach = -cross(b - a, ahead);
    return approach > 0 ? root + ahead * (exact_cross(a, b, root) / approach) : end;
}

/// Orders what waits: the nearest first, of several equally near the first that was seen.
constexpr auto kIsLater = [](const auto& s, const auto& t) {
    return s.least != t.least ? s.least > t.least : s.beam > t.beam;
};

/// Who stands exactly in a corner has no directions to it. Far less than anybody hears [m].
constexpr double kOffTheCorner = 0x1p-16;

}  // namespace

/// How long a way through what waits still is at least.
double Hearing::follow_nearest() {
    std::pop_heap(waiting_.begin(), waiting_.end(), kIsLater);
    const auto [least, number] = waiting_.back();
    waiting_.pop_back();
    const Beam beam = field_.beams[number];
    if (!is_outdone(beam)) beam.fan == Fan::none ? go_on(beam) : fan_out(beam);
    return least;
}

void Hearing::look_around() {
    const std::uint32_t first = 3 * field_.own_tile;
    for (std::uint32_t edge = first; edge < first + 3; ++edge) {
        if (start_of(edge) != field_.listener.point) continue;
        const Vec2 inward = end_of(edge) + end_of(next_edge(edge)) - start_of(edge) * 2;
        field_.listener.point = snap_to_point_grid(field_.listener.point + unit_or_zero(inward) * kOffTheCorner);
    }
    Beam beam;
    beam.root = field_.listener.point;
    for (std::uint32_t edge = first; edge < first + 3; ++edge) look_through(beam, edge, start_of(edge), end_of(edge));
}

/// The corner opposite the edge parts what is seen through the two other edges. What the edge's own ends hide is
/// reached by turning there: also where that corner is just on the border of the shadow, and all of this tile is seen.
void Hearing::go_on(const Beam& beam) {
    const std::uint32_t left_edge = next_edge(beam.edge), right_edge = previous_edge(beam.edge);
    const Vec2 apex = start_of(right_edge);
    const double from_left = exact_cross(beam.root, beam.left, apex);
    const double from_right = exact_cross(beam.root, apex, beam.right);
    if (from_left > 0) look_through(beam, left_edge, beam.left, from_right >= 0 ? apex : beam.right);
    if (from_right > 0) look_through(beam, right_edge, from_left >= 0 ? apex : beam.left, beam.right);
    if (from_left <= 0 && beam.left == end_of(beam.edge)) turn_left(beam);
    if (from_right <= 0 && beam.right == start_of(beam.edge)) turn_right(beam);
}

void Hearing::turn_left(const Beam& beam) {
    const std::uint32_t left_edge = next_edge(beam.edge), right_edge = previous_edge(beam.edge);
    const Beam around = bent(beam, left_edge);
    if (!is_corner(around.corner, beam.passage) || !take_corner(around)) return;
    const Vec2 straight_on = around.root * 2 - beam.root, apex = start_of(right_edge);
    fan_through(around, left_edge, Fan::left, straight_on);
    if (exact_cross(around.root, apex, straight_on) > 0) look_through(around, right_edge, apex, straight_on);
}

void Hearing::turn_right(const Beam& beam) {
    const std::uint32_t left_edge = next_edge(beam.edge), right_edge = previous_edge(beam.edge);
    const Beam around = bent(beam, beam.edge);
    if (!is_corner(around.corner, beam.passage) || !take_corner(around)) return;
    const Vec2 straight_on = around.root * 2 - beam.root, apex = end_of(left_edge);
    fan_through(around, right_edge, Fan::right, straight_on);
    if (exact_cross(around.root, straight_on, apex) > 0) look_through(around, left_edge, straight_on, apex);
}

void Hearing::fan_out(const Beam& beam) {
    const std::uint32_t left_edge = next_edge(beam.edge), right_edge = previous_edge(beam.edge);
    const Vec2 apex = start_of(right_edge);
    if (beam.fan == Fan::left) {
        look_through(beam, right_edge, apex, start_of(beam.edge));
        if (exact_cross(beam.root, beam.right, apex) < 0) fan_through(beam, left_edge, Fan::left, beam.right);
    } else {
        look_through(beam, left_edge, end_of(beam.edge), apex);
        if (exact_cross(beam.root, beam.left, apex) > 0) fan_through(beam, right_edge, Fan::right, beam.left);
    }
}

void Hearing::look_through(Beam beam, std::uint32_t edge, Vec2 left, Vec2 right) {
    beam.fan = Fan::none;
    beam.left = left;
    beam.right = right;
    const Vec2 a = start_of(edge), b = end_of(edge);
    const Stretch seen{meeting(beam.root, left, a, b, a), meeting(beam.root, right, a, b, b)};
    pass(beam, edge, nearest_point(seen, beam.root));
}

void Hearing::fan_through(Beam beam, std::uint32_t edge, Fan fan, Vec2 straight_on) {
    beam.fan = fan;
    beam.left = beam.right = straight_on;
    pass(beam, edge, beam.root);
}

/// Through an edge of the tile into the next.
void Hearing::pass(Beam beam, std::uint32_t edge, Vec2 nearest) {
    const SoundWay way = way_over(field_, beam, nearest);
    if (way.length_m >= field_.reach_m || (is_seeking_ && !may_lead_to_sought(beam, edge, way.length_m))) return;
    const WallId id = tiling_.wall(edge);
    if (!id) {
        beam.edge = tiling_.across(edge);
        return keep(beam, way.length_m);
    }
    const Wall& wall = map_[id];
    const bool open = is_open(id, beam.passage);
    // Behind a door that is shut its mover may sound.
    if (wall.kind == WallKind::portal || open) touch(wall.behind, way);
    if (!open) return;
    beam.edge = tiling_.edge_of(wall.exit);
    if (wall.link != Wall::kNoLink) pass_link(beam, wall);
    keep(beam, way.length_m);
}

void Hearing::touch(SectorId sector, const SoundWay& way) {
    StampedNumber& touched = field_.touched[sector.index];
    const std::uint32_t number = field_.number(touched);
    if (number == kNone) {
        touched = {field_.listening, static_cast<std::uint32_t>(field_.ways.size())};
        field_.ways.push_back({sector, way});
    } else if (way.length_m < field_.ways[number].way.length_m) {
        field_.ways[number].way = way;
    }
    for (Sought& sought : sought_)
        if (!sought.source.point && map_[sought.source.sector].leader == map_[sector].leader)
            sought.nearest = std::min(sought.nearest, way.length_m);
}

void Hearing::pass_link(Beam& beam, const Wall& link) const {
    const Wall& exit = map_[link.exit];
    for (Vec2* point : {&beam.root, &beam.left, &beam.right})
        *point = *point == link.a ? exit.b : *point == link.b ? exit.a : map_.carried(link, *point);
    beam.passage = then(beam.passage, map_.passage(link));
}

void Hearing::keep(Beam beam, double least) {
    const auto number = static_cast<std::uint32_t>(field_.beams.size());
    StampedNumber& latest = field_.latest[beam.edge / 3];
    beam.earlier = field_.number(latest);
    latest = {field_.listening, number};
    field_.beams.push_back(beam);
    waiting_.push_back({least, number});
    std::push_heap(waiting_.begin(), waiting_.end(), kIsLater);
    for (Sought& sought : sought_)
        if (sought.tile == beam.edge / 3)
            if (const auto way = way_into(field_, beam, *sought.source.point))
                sought.nearest = std::min(sought.nearest, way->length_m);
}

bool Hearing::is_open(WallId wall, const Rigid& passage) const { return is_passable(map_, wall, passage, may_pass_); }

/// Whether some wall stops there: only there a way can bend. At the ends of links space may have any angle.
bool Hearing::is_corner(WallId corner, const Rigid& passage) const {
    const auto is_nothing = [&](WallId wall) { return map_[wall].link == Wall::kNoLink && is_open(wall, passage); };
    const auto walls = tiling_.around(corner);
    return std::any_of(walls.begin(), walls.end(),
                       [&](WallId wall) { return !is_nothing(wall) || !is_nothing(map_[wall].previous); });
}

/// Whether a shorter way to its root was found since.
bool Hearing::is_outdone(const Beam& beam) const {
    return beam.corner && roots_[beam.corner.index].length < beam.length;
}

/// False where there is a shorter way to the corner, or it is out of reach.
bool Hearing::take_corner(const Beam& bent) {
    Root& root = roots_[bent.corner.index];
    const bool is_known = root.listening == field_.listening;
    if (bent.length >= field_.reach_m || (is_known && root.length < bent.length)) return false;
    root = {field_.listening, bent.length};
    return true;
}

/// The beam from the start of an edge of the tile, reached by the beam.
Hearing::Beam Hearing::bent(const Beam& beam, std::uint32_t corner_edge) const {
    Beam around = beam;
    around.root = start_of(corner_edge);
    around.length = beam.length + length_of(around.root - beam.root);
    around.corner = tiling_.corner(corner_edge);
    if (!beam.corner) around.first_bend = inverse(beam.passage).apply(around.root);
    return around;
}

SoundWay Hearing::straight_way(Vec2 listener, Vec2 source) {
    return {length_of(source - listener), unit_or_zero(source - listener)};
}

SoundWay Hearing::way_over(const SoundField& field, const Beam& beam, Vec2 point) const {
    const Vec2 last = point - beam.root;
    const Vec2 toward = beam.corner ? beam.first_bend - field.listener.point : inverse(beam.passage).turn(last);
    return {beam.length + length_of(last), unit_or_zero(toward)};
}

/// To any point of the tile; around the edge's end where that hides the point. None where another beam shows it.
std::optional<SoundWay> Hearing::way_into(const SoundField& field, const Beam& beam, Vec2 point) const {
    if (beam.fan != Fan::none) return way_over(field, beam, point);
    if (exact_cross(beam.root, beam.left, point) < 0) {
        if (beam.left != end_of(beam.edge)) return {};
        return way_over(field, bent(beam, next_edge(beam.edge)), point);
    }
    if (exact_cross(beam.root, point, beam.right) < 0) {
        if (beam.right != start_of(beam.edge)) return {};
        return way_over(field, bent(beam, beam.edge), point);
    }
    return way_over(field, beam, point);
}

}  // namespace enfilade
