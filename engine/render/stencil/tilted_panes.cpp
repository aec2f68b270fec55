#include "render/stencil/tilted_panes.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "render/stencil/pane_order.h"

namespace enfilade::stencil {
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
    PaneFinder(const Layer& layer, const World& world) : layer_(layer), world_(world) {}

    const std::vector<PaneInRoom>& found() const { return found_; }

    void find(SectorId home) {
        const Heights room = heights_of(world_.snapshot, home, layer_.pose.eye_z);
        for (const Presence& presence : world_.snapshot.things.in(home))
            if (auto thing = in_view(world_.map, world_.textures, world_.snapshot, presence, layer_.pose, room))
                add_thing(home, *thing);
        const Sector& sector = world_.map[home];
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
        for (Stretch s : inside(world_.map, home, layer_.pose, depth)) {
            s = {std::max(s.begin, left.x), std::min(s.end, right.x)};
            if (s.begin < s.end && layer_.entry) s = beyond_doorway(layer_.opened, depth, s);
            if (s.begin >= s.end) continue;
            place.shown_left_v = {turned ? s.end : s.begin, thing.depth};
            place.shown_right_v = {turned ? s.begin : s.end, thing.depth};
            found_.push_back({home, thing});
        }
    }

    void add_panel(SectorId home, PanelId id) {
        const Panel& panel = world_.map[id];
        if (!panel.surface.texture) return;
        const Segment seen = facing(panel, layer_.pose.eye);
        if (panel.one_sided && seen.a != panel.a) return;
        if (layer_.entry && !is_panel_beyond(seen, world_.map[layer_.entry])) return;
        PanelOnScreen shown = in_view(world_.map, world_.snapshot, id, layer_.pose);
        shown.is_in_doorway = is_in_doorway(world_.map, panel, layer_.pose.eye);
        if (!shown.shown.is_empty()) found_.push_back({home, shown});
    }

    void add_hanging(SectorId home, WallId id) {
        const Wall& wall = world_.map[id];
        if (wall.kind != WallKind::portal || !world_.map[wall.middle].texture) return;
        if (layer_.entry && (layer_.entry == id || !is_beyond(wall, world_.map[layer_.entry]))) return;
        if (const auto place = in_view(world_.map, id, layer_.pose)) found_.push_back({home, Hanging{*place}});
    }

    const Layer& layer_;
    const World& world_;
    std::vector<PaneInRoom> found_;
};

}  // namespace

void note_tilted_panes(Layer& layer, const World& world) {
    PaneFinder finder(layer, world);
    for (const SectorId sector : layer.sectors) finder.find(sector);
    layer.panes = in_order(finder.found());
}

}  // namespace enfilade::stencil
