// As seen from a root outside a tile, looking in through an edge: the edge's end is on the left, its start on the
// right. Seen from inside, looking out, it is the other way round.
#include "space/hearing.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "space/reach.h"

namespace enfilade {
namespace {

double length_of(Vec2 v) { return std::sqrt(dot(v, v)); }

Vec2 unit(Vec2 v) {
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
    return s.least != t.least ? s.least > t.least : s.glance > t.glance;
};

/// Who stands exactly in a corner has no directions to it. Far less than anybody hears [m].
constexpr double kOffTheCorner = 0x1p-16;

}  // namespace

void Hearing::listen(const Place& listener, double reach_m, const MayPass& may_pass) {
    ++listening_;
    listener_ = listener;
    reach_m_ = reach_m;
    may_pass_ = may_pass;
    glances_.clear();
    waiting_.clear();
    touched_.clear();
    own_tile_ = tiling_.find(map_, listener.sector, listener.point);
    if (own_tile_ != Tiling::kNone) look_around();
    while (!waiting_.empty() && glances_.size() < kMostGlances) {
        std::pop_heap(waiting_.begin(), waiting_.end(), kIsLater);
        const Glance glance = glances_[waiting_.back().glance];
        waiting_.pop_back();
        if (!is_outdone(glance)) glance.fan == Fan::none ? go_on(glance) : fan_out(glance);
    }
    sort_out();
}

void Hearing::look_around() {
    const std::uint32_t first = 3 * own_tile_;
    for (std::uint32_t edge = first; edge < first + 3; ++edge) {
        if (start_of(edge) != listener_.point) continue;
        const Vec2 inward = end_of(edge) + end_of(next_edge(edge)) - start_of(edge) * 2;
        listener_.point = snap_to_point_grid(listener_.point + unit(inward) * kOffTheCorner);
    }
    Glance glance;
    glance.root = listener_.point;
    for (std::uint32_t edge = first; edge < first + 3; ++edge) look_through(glance, edge, start_of(edge), end_of(edge));
}

/// The corner opposite the edge parts what is seen through the two other edges. What the edge's own ends hide is
/// reached by turning there: also where that corner is just on the border of the shadow, and all of this tile is seen.
void Hearing::go_on(const Glance& glance) {
    const std::uint32_t left_edge = next_edge(glance.edge), right_edge = previous_edge(glance.edge);
    const Vec2 apex = start_of(right_edge);
    const double from_left = exact_cross(glance.root, glance.left, apex);
    const double from_right = exact_cross(glance.root, apex, glance.right);
    if (from_left > 0) look_through(glance, left_edge, glance.left, from_right >= 0 ? apex : glance.right);
    if (from_right > 0) look_through(glance, right_edge, from_left >= 0 ? apex : glance.left, glance.right);
    if (from_left <= 0 && glance.left == end_of(glance.edge)) turn_left(glance);
    if (from_right <= 0 && glance.right == start_of(glance.edge)) turn_right(glance);
}

void Hearing::turn_left(const Glance& glance) {
    const std::uint32_t left_edge = next_edge(glance.edge), right_edge = previous_edge(glance.edge);
    const Glance around = bent(glance, left_edge);
    if (!is_corner(around.corner, glance.passage) || !take_corner(around)) return;
    const Vec2 straight_on = around.root * 2 - glance.root, apex = start_of(right_edge);
    fan_through(around, left_edge, Fan::left, straight_on);
    if (exact_cross(around.root, apex, straight_on) > 0) look_through(around, right_edge, apex, straight_on);
}

void Hearing::turn_right(const Glance& glance) {
    const std::uint32_t left_edge = next_edge(glance.edge), right_edge = previous_edge(glance.edge);
    const Glance around = bent(glance, glance.edge);
    if (!is_corner(around.corner, glance.passage) || !take_corner(around)) return;
    const Vec2 straight_on = around.root * 2 - glance.root, apex = end_of(left_edge);
    fan_through(around, right_edge, Fan::right, straight_on);
    if (exact_cross(around.root, straight_on, apex) > 0) look_through(around, left_edge, straight_on, apex);
}

void Hearing::fan_out(const Glance& glance) {
    const std::uint32_t left_edge = next_edge(glance.edge), right_edge = previous_edge(glance.edge);
    const Vec2 apex = start_of(right_edge);
    if (glance.fan == Fan::left) {
        look_through(glance, right_edge, apex, start_of(glance.edge));
        if (exact_cross(glance.root, glance.right, apex) < 0) fan_through(glance, left_edge, Fan::left, glance.right);
    } else {
        look_through(glance, left_edge, end_of(glance.edge), apex);
        if (exact_cross(glance.root, glance.left, apex) > 0) fan_through(glance, right_edge, Fan::right, glance.left);
    }
}

void Hearing::look_through(Glance glance, std::uint32_t edge, Vec2 left, Vec2 right) {
    glance.fan = Fan::none;
    glance.left = left;
    glance.right = right;
    const Vec2 a = start_of(edge), b = end_of(edge);
    const Stretch seen{meeting(glance.root, left, a, b, a), meeting(glance.root, right, a, b, b)};
    pass(glance, edge, nearest_point(seen, glance.root));
}

void Hearing::fan_through(Glance glance, std::uint32_t edge, Fan fan, Vec2 straight_on) {
    glance.fan = fan;
    glance.left = glance.right = straight_on;
    pass(glance, edge, glance.root);
}

/// Through an edge of the tile into the next.
void Hearing::pass(Glance glance, std::uint32_t edge, Vec2 nearest) {
    const SoundWay way = way_over(glance, nearest);
    if (way.length_m >= reach_m_) return;
    const WallId id = tiling_.wall(edge);
    if (!id) {
        glance.edge = tiling_.across(edge);
        return keep(glance, way.length_m);
    }
    const Wall& wall = map_[id];
    const bool open = is_open(id, glance.passage);
    // Behind a door that is shut its mover may sound.
    if (wall.kind == WallKind::portal || open) touched_.push_back({wall.behind, way});
    if (!open) return;
    glance.edge = tiling_.edge_of(wall.exit);
    if (wall.link != Wall::kNoLink) carry(glance, wall);
    keep(glance, way.length_m);
}

void Hearing::carry(Glance& glance, const Wall& link) const {
    const Wall& exit = map_[link.exit];
    for (Vec2* point : {&glance.root, &glance.left, &glance.right})
        *point = *point == link.a ? exit.b : *point == link.b ? exit.a : map_.carried(link, *point);
    glance.passage = then(glance.passage, map_.passage(link));
}

void Hearing::keep(Glance glance, double least) {
    const auto number = static_cast<std::uint32_t>(glances_.size());
    Latest& latest = latest_[glance.edge / 3];
    glance.earlier = latest.listening == listening_ ? latest.glance : kNone;
    latest = {listening_, number};
    glances_.push_back(glance);
    waiting_.push_back({least, number});
    std::push_heap(waiting_.begin(), waiting_.end(), kIsLater);
}

void Hearing::sort_out() {
    std::stable_sort(touched_.begin(), touched_.end(), [](const Touched& s, const Touched& t) {
        return s.sector != t.sector ? s.sector < t.sector : s.way.length_m < t.way.length_m;
    });
    const auto again = std::unique(touched_.begin(), touched_.end(),
                                   [](const Touched& s, const Touched& t) { return s.sector == t.sector; });
    touched_.erase(again, touched_.end());
    sectors_.assign(1, listener_.sector);
    for (const Touched& touched : touched_)
        if (touched.sector != listener_.sector) sectors_.push_back(touched.sector);
    std::sort(sectors_.begin(), sectors_.end());
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
bool Hearing::is_outdone(const Glance& glance) const {
    return glance.corner && roots_[glance.corner.index].length < glance.length;
}

/// False where there is a shorter way to the corner, or it is out of reach.
bool Hearing::take_corner(const Glance& bent) {
    Root& root = roots_[bent.corner.index];
    const bool is_known = root.listening == listening_;
    if (bent.length >= reach_m_ || (is_known && root.length < bent.length)) return false;
    root = {listening_, bent.length};
    return true;
}

/// The look from the start of an edge of the tile, reached by the glance.
Hearing::Glance Hearing::bent(const Glance& glance, std::uint32_t corner_edge) const {
    Glance around = glance;
    around.root = start_of(corner_edge);
    around.length = glance.length + length_of(around.root - glance.root);
    around.corner = tiling_.corner(corner_edge);
    if (!glance.corner) around.first_bend = inverse(glance.passage).apply(around.root);
    return around;
}

SoundWay Hearing::way_over(const Glance& glance, Vec2 point) const {
    const Vec2 last = point - glance.root;
    const Vec2 toward = glance.corner ? glance.first_bend - listener_.point : inverse(glance.passage).turn(last);
    return {glance.length + length_of(last), unit(toward)};
}

/// To any point of the tile; around the edge's end where that hides the point. None where another glance shows it.
std::optional<SoundWay> Hearing::way_into(const Glance& glance, Vec2 point) const {
    if (glance.fan != Fan::none) return way_over(glance, point);
    if (exact_cross(glance.root, glance.left, point) < 0) {
        if (glance.left != end_of(glance.edge)) return {};
        return way_over(bent(glance, next_edge(glance.edge)), point);
    }
    if (exact_cross(glance.root, point, glance.right) < 0) {
        if (glance.right != start_of(glance.edge)) return {};
        return way_over(bent(glance, glance.edge), point);
    }
    return way_over(glance, point);
}

std::optional<SoundWay> Hearing::from(const Place& source) const {
    std::optional<SoundWay> best;
    const auto take = [&](const SoundWay& way) {
        if (way.length_m < reach_m_ && (!best || way.length_m < best->length_m)) best = way;
    };
    for (std::uint32_t tile = 0; (tile = tiling_.find(map_, source.sector, source.point, tile)) != Tiling::kNone;
         ++tile) {
        const Vec2 straight = source.point - listener_.point;
        if (tile == own_tile_) take({length_of(straight), unit(straight)});
        if (latest_[tile].listening != listening_) continue;
        for (std::uint32_t i = latest_[tile].glance; i != kNone; i = glances_[i].earlier)
            if (const auto way = way_into(glances_[i], source.point)) take(*way);
    }
    return best;
}

std::optional<SoundWay> Hearing::from(SectorId sector) const {
    if (own_tile_ != kNone && sector == listener_.sector) return SoundWay{};
    const auto it = std::lower_bound(touched_.begin(), touched_.end(), sector,
                                     [](const Touched& t, SectorId id) { return t.sector < id; });
    if (it == touched_.end() || it->sector != sector) return {};
    return it->way;
}

}  // namespace enfilade
