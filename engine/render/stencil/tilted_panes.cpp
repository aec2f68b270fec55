#include "render/stencil/tilted_panes.h"

#include <algorithm>
#include <cmath>

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

class PaneFinder {
public:
    PaneFinder(Layer& layer, const World& world) : layer_(layer), world_(world) {}

    void find(SectorId home) {
        const Heights room = heights_of(world_.snapshot, home, layer_.pose.eye_z);
        for (const Presence& presence : world_.snapshot.things.in(home))
            if (auto thing = in_view(world_.map, world_.textures, world_.snapshot, presence, layer_.pose, room))
                add_thing(home, *thing);
        const Sector& sector = world_.map[home];
        for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
            add_panel(PanelId(i));
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i)
            add_hanging(WallId(i));
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
            layer_.panes.push_back(thing);
        }
    }

    void add_panel(PanelId id) {
        const Panel& panel = world_.map[id];
        if (!panel.surface.texture) return;
        const Segment seen = facing(panel, layer_.pose.eye);
        if (panel.one_sided && seen.a != panel.a) return;
        if (layer_.entry && !is_panel_beyond(seen, world_.map[layer_.entry])) return;
        const PanelOnScreen shown = in_view(world_.map, world_.snapshot, id, layer_.pose);
        if (!shown.shown.is_empty()) layer_.panes.push_back(shown);
    }

    void add_hanging(WallId id) {
        const Wall& wall = world_.map[id];
        if (wall.kind != WallKind::portal || !wall.middle.texture) return;
        if (layer_.entry && (layer_.entry == id || !is_beyond(wall, world_.map[layer_.entry]))) return;
        if (const auto place = in_view(world_.map, id, layer_.pose)) layer_.panes.push_back(Hanging{*place});
    }

    Layer& layer_;
    const World& world_;
};

double distance(const Pane& pane) {
    const WallOnScreen& place = place_of(pane);
    const Vec2 middle = (place.shown_left_v + place.shown_right_v) * 0.5;
    return dot(middle, middle);
}

}  // namespace

void note_tilted_panes(Layer& layer, const World& world) {
    PaneFinder finder(layer, world);
    for (const SeenSector& seen : layer.sectors) finder.find(seen.sector);
    std::stable_sort(layer.panes.begin(), layer.panes.end(),
                     [](const Pane& a, const Pane& b) { return distance(a) < distance(b); });
}

}  // namespace enfilade::stencil
