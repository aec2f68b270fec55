#include "render/stencil/tilted_panes.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade::stencil {

namespace {

/// Directions nearer to each other than this are one [1]: panes that share an end have no ray in common.
constexpr double kSameDirection = 0x1p-40;

Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

/// Whether v is to the right of u; both are ahead of the eye, or both behind it.
bool is_right_of(Vec2 v, Vec2 u) { return cross(v, u) > kSameDirection * std::sqrt(dot(u, u) * dot(v, v)); }

/// The shown part of a pane that is all ahead of the eye, or all behind it. Those of one side never go round the eye in
/// a ring, so they can be put in order.
class Piece {
public:
    Piece(const PaneInRoom& whole, std::size_t number) : room_(whole.room), number_(number), pane_(whole.pane) {}

    const Pane& pane() const { return pane_; }
    SectorId room() const { return room_; }
    std::size_t number() const { return number_; }  ///< of the pane it is a part of
    Vec2 left() const { return place_of(pane_).shown_left_v; }
    Vec2 right() const { return place_of(pane_).shown_right_v; }
    bool is_thing() const { return std::holds_alternative<ThingOnScreen>(pane_); }
    bool is_panel() const { return std::holds_alternative<PanelOnScreen>(pane_); }
    bool is_ahead() const { return left().y + right().y >= 0; }

    /// What of it is to the right of a point that is on it becomes a piece of its own.
    Piece cut_at(Vec2 point) {
        Piece rest = *this;
        place_of(pane_).shown_right_v = place_of(rest.pane_).shown_left_v = point;
        return rest;
    }

    /// Whether it is behind a doorway on whose line it is, rather than before it.
    bool is_behind_doorway() const {
        const auto* panel = std::get_if<PanelOnScreen>(&pane_);
        return is_thing() || (panel != nullptr && panel->is_in_doorway);
    }

    /// How far away its line is in a direction [lengths of it].
    double distance(Vec2 way) const { return cross(left(), right()) / cross(way, right() - left()); }

private:
    SectorId room_;
    std::size_t number_;
    Pane pane_;
};

/// Where a line from p to q, which is on both sides of that depth, goes through it.
Vec2 point_at(double depth, Vec2 p, Vec2 q) { return {p.x + (q.x - p.x) * ((depth - p.y) / (q.y - p.y)), depth}; }

void cut_at_eye(std::vector<Piece>& pieces) {
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
        const Vec2 left = pieces[i].left(), right = pieces[i].right();
        if (left.y * right.y < 0) pieces.push_back(pieces[i].cut_at(point_at(0, left, right)));
    }
}

/// Only things go through anything: through panels.
void cut_by_panel(std::vector<Piece>& pieces, const Piece& panel) {
    const Vec2 a = panel.left(), b = panel.right();
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
        const Vec2 left = pieces[i].left(), right = pieces[i].right();
        if (!pieces[i].is_thing() || pieces[i].room() != panel.room() || (a.y < left.y) == (b.y < left.y)) continue;
        const Vec2 point = point_at(left.y, a, b);
        if ((point.x - left.x) * (point.x - right.x) < 0) pieces.push_back(pieces[i].cut_at(point));
    }
}

std::vector<Piece> pieces_of(const std::vector<PaneInRoom>& panes) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < panes.size(); ++i) pieces.emplace_back(panes[i], i);
    for (std::size_t i = 0; i < panes.size(); ++i)
        if (const Piece whole = pieces[i]; whole.is_panel()) cut_by_panel(pieces, whole);
    cut_at_eye(pieces);
    return pieces;
}

enum class Order { none, first_is_nearer, second_is_nearer };

Order order_of(const Piece& p, const Piece& q) {
    if (p.is_ahead() != q.is_ahead()) return Order::none;
    const Vec2 left = cross(q.left(), p.left()) > 0 ? q.left() : p.left();
    const Vec2 right = cross(q.right(), p.right()) > 0 ? p.right() : q.right();
    if (!is_right_of(right, left)) return Order::none;  // no ray meets both
    const Vec2 way = unit(unit(left) + unit(right));
    const double to_p = p.distance(way), to_q = q.distance(way);
    bool p_is_nearer = to_p < to_q;
    if (std::fabs(to_p - to_q) < kDepthStep) {
        const bool is_between_rooms = p.room() != q.room() && p.is_behind_doorway() != q.is_behind_doorway();
        p_is_nearer = is_between_rooms ? q.is_behind_doorway() : p.number() < q.number();
    }
    return p_is_nearer ? Order::first_is_nearer : Order::second_is_nearer;
}

/// Takes panes away, always one that no other hides (Kahn: "Topological sorting of large networks", 1962).
class Sorter {
public:
    explicit Sorter(const std::vector<Piece>& pieces)
        : pieces_(pieces), behind_(pieces.size()), hiding_(pieces.size()) {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (std::size_t j = i + 1; j < pieces.size(); ++j) relate(i, j);
    }

    std::vector<Pane> sort() {
        std::vector<Pane> sorted;
        while (sorted.size() < pieces_.size()) {
            // Rounding might leave none that is hidden by no other; then one that is hidden least.
            const auto next = std::min_element(hiding_.begin(), hiding_.end());
            const auto i = static_cast<std::size_t>(next - hiding_.begin());
            sorted.push_back(pieces_[i].pane());
            *next = kTaken;
            for (const std::size_t hidden : behind_[i])
                if (hiding_[hidden] != kTaken) --hiding_[hidden];
        }
        return sorted;
    }

private:
    static constexpr std::size_t kTaken = static_cast<std::size_t>(-1);

    void relate(std::size_t i, std::size_t j) {
        const Order order = order_of(pieces_[i], pieces_[j]);
        if (order == Order::none) return;
        const bool i_is_nearer = order == Order::first_is_nearer;
        behind_[i_is_nearer ? i : j].push_back(i_is_nearer ? j : i);
        ++hiding_[i_is_nearer ? j : i];
    }

    const std::vector<Piece>& pieces_;
    std::vector<std::vector<std::size_t>> behind_;  ///< those that each one hides
    std::vector<std::size_t> hiding_;               ///< how many, not yet taken, hide each one
};

}  // namespace

std::vector<Pane> in_order(const std::vector<PaneInRoom>& panes) {
    const std::vector<Piece> pieces = pieces_of(panes);
    return Sorter(pieces).sort();
}

namespace {

/// What stands in the very plane of a doorway is in the room behind it, whatever rounding did [m] (render/sprite.h).
constexpr double kBehind = 4 * kDepthStep;

/// A stretch of a line across the view, from left to right [m].
struct Stretch {
    double begin, end;
};

/// Those stretches of the line `depth` ahead of the eye that are inside a sector.
std::vector<Stretch> inside(const Map& map, SectorId home, const Pose& pose, double depth) {
    std::vector<double> crossings;
    const Sector& sector = map[home];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Vec2 a = to_view(map.walls[i].a, pose), b = to_view(map.walls[i].b, pose);
        if ((a.y < depth) != (b.y < depth)) crossings.push_back(a.x + (b.x - a.x) * ((depth - a.y) / (b.y - a.y)));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) stretches.push_back({crossings[i], crossings[i + 1]});
    return stretches;
}

/// What of the stretch is beyond the line of the doorway that one looks in through.
Stretch beyond_doorway(const WallOnScreen& doorway, double depth, Stretch s) {
    const Vec2 l = doorway.left_v, r = doorway.right_v;
    // Positive at points on the eye's side of the line, for which it is doorway.cross.
    const auto before = [&](double x) { return (r.x - x) * (l.y - depth) - (l.x - x) * (r.y - depth); };
    const double at_begin = before(s.begin), at_end = before(s.end);
    if (at_begin > 0 && at_end > 0) return {s.begin, s.begin};
    if (at_begin <= 0 && at_end <= 0) return s;
    const double edge = s.begin + (s.end - s.begin) * (at_begin / (at_begin - at_end));
    return at_begin > 0 ? Stretch{edge, s.end} : Stretch{s.begin, edge};
}

/// Whether two segments on one line have more than a point in common. Exact.
bool overlap(const Segment& s, const Segment& t) {
    const Vec2 way = t.b - t.a;
    const double p = dot(way, s.a - t.a), q = dot(way, s.b - t.a);
    return std::max(std::min(p, q), 0.0) < std::min(std::max(p, q), dot(way, way));
}

/// Whether one looks into the panel's sector through a doorway that the panel stands in.
bool is_in_doorway(const Map& map, const Panel& panel, Vec2 eye) {
    const Segment place(panel.a, panel.b);
    const Sector& sector = map[panel.sector];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (wall.kind == WallKind::portal && are_on_one_line(place, wall) && overlap(place, wall) &&
            side_of_line(wall.a, wall.b, eye) < 0)
            return true;
    }
    return false;
}

class PaneFinder {
public:
    PaneFinder(const Layer& layer, const FrameInput& input) : layer_(layer), input_(input) {}

    const std::vector<PaneInRoom>& found() const { return found_; }

    void find(SectorId home) {
        const RelativeHeights room = heights_of(input_.snapshot, home, layer_.pose.eye_z);
        for (const Presence& presence : input_.snapshot.things.in(home))
            if (auto thing = in_view(input_.map, input_.textures, input_.snapshot, presence, layer_.pose, room))
                add_thing(home, *thing);
        const Sector& sector = input_.map[home];
        for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
            add_panel(home, PanelId(i));
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i)
            add_hanging(home, WallId(i));
    }

private:
    void add_thing(SectorId home, ThingOnScreen& thing) {
        const double depth = thing.depth + std::copysign(kBehind, thing.depth);
        WallOnScreen& place = thing.place;
        const bool turned = place.left_v.x > place.right_v.x;
        const Vec2 left = turned ? place.right_v : place.left_v, right = turned ? place.left_v : place.right_v;
        for (Stretch s : inside(input_.map, home, layer_.pose, depth)) {
            s = {std::max(s.begin, left.x), std::min(s.end, right.x)};
            if (s.begin < s.end && layer_.entry) s = beyond_doorway(layer_.opened, depth, s);
            if (s.begin >= s.end) continue;
            place.shown_left_v = {turned ? s.end : s.begin, thing.depth};
            place.shown_right_v = {turned ? s.begin : s.end, thing.depth};
            found_.push_back({home, thing});
        }
    }

    void add_panel(SectorId home, PanelId id) {
        const Panel& panel = input_.map[id];
        if (!panel.surface.texture) return;
        const Segment seen = facing(panel, layer_.pose.eye);
        if (panel.one_sided && seen.a != panel.a) return;
        if (layer_.entry && !is_panel_beyond(seen, input_.map[layer_.entry])) return;
        PanelOnScreen shown = in_view(input_.map, input_.snapshot, id, layer_.pose);
        shown.is_in_doorway = is_in_doorway(input_.map, panel, layer_.pose.eye);
        if (!shown.shown.is_empty()) found_.push_back({home, shown});
    }

    void add_hanging(SectorId home, WallId id) {
        const Wall& wall = input_.map[id];
        if (wall.kind != WallKind::portal || !input_.map[wall.middle].texture) return;
        if (layer_.entry && (layer_.entry == id || !is_beyond(wall, input_.map[layer_.entry]))) return;
        if (const auto place = in_view(input_.map, id, layer_.pose)) found_.push_back({home, Hanging{*place}});
    }

    const Layer& layer_;
    const FrameInput& input_;
    std::vector<PaneInRoom> found_;
};

}  // namespace

void note_tilted_panes(Layer& layer, const FrameInput& input) {
    PaneFinder finder(layer, input);
    for (const SectorId sector : layer.sectors) finder.find(sector);
    layer.panes = in_order(finder.found());
}

}  // namespace enfilade::stencil
