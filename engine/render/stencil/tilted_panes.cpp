#include "render/stencil/plan.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"

namespace enfilade::stencil {

namespace {

/// A stretch of a line across the view, from left to right [m].
struct LineInterval {
    double begin, end;
};

/// Those stretches of the line `depth` ahead of the eye that are inside a sector.
std::vector<LineInterval> inside(const Map& map, SectorId home, const Pose& pose, double depth) {
    std::vector<double> crossings;
    const Sector& sector = map[home];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Vec2 a = to_view(map.walls[i].a, pose), b = to_view(map.walls[i].b, pose);
        if ((a.y < depth) != (b.y < depth)) crossings.push_back(a.x + (b.x - a.x) * ((depth - a.y) / (b.y - a.y)));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<LineInterval> stretches;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) stretches.push_back({crossings[i], crossings[i + 1]});
    return stretches;
}

/// What of the stretch is beyond the line of the doorway that one looks in through.
LineInterval beyond_doorway(const WallOnScreen& doorway, double depth, LineInterval s) {
    const Vec2 l = doorway.left_v, r = doorway.right_v;
    // Positive at points on the eye's side of the line, for which it is doorway.cross.
    const auto before = [&](double x) { return (r.x - x) * (l.y - depth) - (l.x - x) * (r.y - depth); };
    const double at_begin = before(s.begin), at_end = before(s.end);
    if (at_begin > 0 && at_end > 0) return {s.begin, s.begin};
    if (at_begin <= 0 && at_end <= 0) return s;
    const double edge = s.begin + (s.end - s.begin) * (at_begin / (at_begin - at_end));
    return at_begin > 0 ? LineInterval{edge, s.end} : LineInterval{s.begin, edge};
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

    std::vector<PaneInRoom> take() { return std::move(found_); }

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
        const double depth = depth_in_room(thing);
        WallOnScreen& place = thing.place;
        const bool turned = place.left_v.x > place.right_v.x;
        const Vec2 left = turned ? place.right_v : place.left_v, right = turned ? place.left_v : place.right_v;
        for (LineInterval s : inside(input_.map, home, layer_.pose, depth)) {
            s = {std::max(s.begin, left.x), std::min(s.end, right.x)};
            if (s.begin < s.end && layer_.entry) s = beyond_doorway(layer_.opened, depth, s);
            if (s.begin >= s.end) continue;
            place.shown_left_v = {turned ? s.end : s.begin, thing.depth};
            place.shown_right_v = {turned ? s.begin : s.end, thing.depth};
            add(home, thing);
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
        if (!shown.shown.is_empty()) add(home, shown);
    }

    void add_hanging(SectorId home, WallId id) {
        const Wall& wall = input_.map[id];
        if (wall.kind != WallKind::portal || !input_.map[wall.middle].texture) return;
        if (layer_.entry && (layer_.entry == id || !is_beyond(wall, input_.map[layer_.entry]))) return;
        if (const auto place = in_view(input_.map, id, layer_.pose)) add(home, Hanging{*place});
    }

    void add(SectorId home, const Pane& pane) { found_.push_back({home, found_.size(), pane}); }

    const Layer& layer_;
    const FrameInput& input_;
    std::vector<PaneInRoom> found_;
};

/// What of the thing is to the right of a point that is on it becomes a pane of its own.
PaneInRoom cut_at(PaneInRoom& thing, Vec2 point) {
    PaneInRoom rest = thing;
    place_of(thing.pane).shown_right_v = place_of(rest.pane).shown_left_v = point;
    return rest;
}

/// Only things go through anything: through panels.
void cut_by_panel(std::vector<PaneInRoom>& panes, const PaneInRoom& panel) {
    const Vec2 a = place_of(panel.pane).shown_left_v, b = place_of(panel.pane).shown_right_v;
    for (std::size_t i = 0, count = panes.size(); i < count; ++i) {
        if (!is_thing(panes[i].pane) || panes[i].room != panel.room) continue;
        const WallOnScreen& thing = place_of(panes[i].pane);
        const Vec2 left = thing.shown_left_v, right = thing.shown_right_v;
        if ((a.y < left.y) == (b.y < left.y)) continue;
        const Vec2 point{a.x + (b.x - a.x) * ((left.y - a.y) / (b.y - a.y)), left.y};
        if ((point.x - left.x) * (point.x - right.x) < 0) panes.push_back(cut_at(panes[i], point));
    }
}

}  // namespace

double depth_in_room(const ThingOnScreen& thing) {
    constexpr double kBehind = 4 * kDepthStep;
    return thing.depth + std::copysign(kBehind, thing.depth);
}

std::vector<PaneInRoom> tilted_panes(const Layer& layer, const FrameInput& input) {
    PaneFinder finder(layer, input);
    for (const SectorId sector : layer.sectors) finder.find(sector);
    std::vector<PaneInRoom> panes = finder.take();
    for (std::size_t i = 0, count = panes.size(); i < count; ++i)
        if (const PaneInRoom pane = panes[i]; std::holds_alternative<PanelOnScreen>(pane.pane))
            cut_by_panel(panes, pane);
    return panes;
}

}  // namespace enfilade::stencil
