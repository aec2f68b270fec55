#include "render/stencil/plan.h"

#include <algorithm>
#include <cmath>

namespace enfilade::stencil {
namespace {

/// Sectors looked into for one frame. A view into a large map takes a few hundred; only links that lead on for ever
/// meet this.
constexpr std::size_t kMostVisits = 1u << 16;

/// Layers of one frame: each is drawn and masked on its own.
constexpr std::size_t kMostLayers = 1u << 13;

/// The graphics card puts edges, which we shift by kTieShift, on a grid of 1/256 px or finer. So what comes nearer to a
/// pixel's centre than this may turn out to cover it, or not to [px].
constexpr double kSlack = 4 * kTieShift;

/// Of two portals whose depths differ by less than this part, rounding could say either is nearer: both are followed.
constexpr double kTie = 1e-9;

/// Past a plain doorway nothing is transformed; a sector seen through one chain of them.
struct Visit {
    SectorId sector;
    WallId entry;          ///< none for the eye's own sector
    WallOnScreen doorway;  ///< the portal looked through, from its other side; where there is an entry
    Window window;
};

/// The first column or row, not before `least`, whose centre is at or after `px`; `most` if there is none.
int first_at(double px, int least, int most) {
    const double first = std::ceil(px - 0.5);
    return first >= most ? most : first > least ? static_cast<int>(first) : least;
}

class Planner {
public:
    Planner(const Map& map, const MapFacts& facts, const TextureSet& textures, const Snapshot& snapshot,
            const Screen& screen)
        : map_(map), facts_(facts), textures_(textures), snapshot_(snapshot), screen_(screen) {}

    Plan plan(const View& view) {
        start(view);
        for (std::size_t i = 0; i < plan_.layers.size(); ++i) {
            fill(plan_.layers[i], first_visits_[i]);
            follow_exits(i);
            first_visits_[i] = {};
        }
        return std::move(plan_);
    }

private:
    void start(const View& view) {
        Window all{0, std::vector<OpenRows>(static_cast<std::size_t>(screen_.width), OpenRows{0, screen_.height})};
        plan_.layers.push_back({eye_of(view), {}, 0, 0, 0, box_around(all), {}, {}, {}});
        first_visits_.push_back({view.sector, {}, {}, std::move(all)});
    }

    /// Finds the layer's sectors and, in exit_windows_, its exits.
    void fill(Layer& layer, const Visit& first) {
        exit_windows_.clear();
        visits_.assign(1, first);
        while (!visits_.empty()) {
            const Visit visit = std::move(visits_.back());
            visits_.pop_back();
            look_into(layer, visit);
        }
    }

    void look_into(Layer& layer, const Visit& visit) {
        ++plan_.visits;
        note_sector(layer, visit);
        find_walls(layer, visit);
        find_nearest(visit);
        note_things(layer, visit);
        for (const WallOnScreen& wall : walls_)
            if (map_[wall.wall].kind != WallKind::solid) look_through(layer, visit, wall);
    }

    static void note_sector(Layer& layer, const Visit& visit) {
        const auto is_it = [&](const SeenSector& seen) { return seen.sector == visit.sector; };
        const auto found = std::find_if(layer.sectors.begin(), layer.sectors.end(), is_it);
        if (found == layer.sectors.end()) {
            layer.sectors.push_back({visit.sector, visit.window.begin, visit.window.end()});
            return;
        }
        found->begin = std::min(found->begin, visit.window.begin);
        found->end = std::max(found->end, visit.window.end());
    }

    /// Those walls of the sector that face the eye beyond the visit's entry in its columns.
    void find_walls(const Layer& layer, const Visit& visit) {
        walls_.clear();
        const Sector& sector = map_[visit.sector];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
            const WallId id(i);
            const auto wall = on_screen(map_, id, layer.eye, screen_);
            if (!wall || wall->end_px < visit.window.begin || wall->begin_px > visit.window.end()) continue;
            if (visit.entry && (visit.entry == id || !is_beyond(map_[id], map_[visit.entry]))) continue;
            walls_.push_back(*wall);
        }
    }

    /// For each column of the visit the largest inverse depth of a wall that surely covers its centre.
    void find_nearest(const Visit& visit) {
        nearest_.assign(visit.window.rows.size(), 0);
        const int begin = visit.window.begin, end = visit.window.end();
        for (const WallOnScreen& wall : walls_) {
            const int last = first_at(wall.end_px - kSlack, begin, end);
            for (int x = first_at(wall.begin_px + kSlack, begin, end); x < last; ++x) {
                double& nearest = nearest_[static_cast<std::size_t>(x - begin)];
                nearest = std::max(nearest, wall.inverse_depth(screen_.slope_at(x + 0.5)));
            }
        }
    }

    /// The things of the visit's sector, the nearest first; of those equally deep the first of them.
    void note_things(Layer& layer, const Visit& visit) {
        const auto presences = snapshot_.things.in(visit.sector);
        if (presences.empty()) return;
        const SectorSnapshot& room = snapshot_[visit.sector];
        things_.clear();
        for (const Presence& presence : presences)
            if (const auto thing = on_screen(map_, textures_, snapshot_, presence, layer.eye, screen_,
                                             room.floor_z - layer.eye.z, room.ceiling_z - layer.eye.z))
                things_.push_back(*thing);
        std::stable_sort(things_.begin(), things_.end(), [](const ThingOnScreen& a, const ThingOnScreen& b) {
            return depth_steps(a.depth) < depth_steps(b.depth);
        });
        for (ThingOnScreen& thing : things_)
            note_runs(
                thing.place, visit.window, [&](int x) { return is_met(visit, x, thing.depth); },
                [&] { layer.panes.push_back(thing); });
    }

    /// Narrows `place` to one run of the window's columns that are shown after another, and notes each.
    template <class IsShown, class Note>
    static void note_runs(WallOnScreen& place, const Window& window, IsShown is_shown, Note note) {
        const double begin_px = place.begin_px, end_px = place.end_px;
        const int first = std::max(static_cast<int>(std::floor(begin_px)), window.begin);
        const int last = std::min(static_cast<int>(std::ceil(end_px)), window.end());
        for (int x = first, begin = first; x <= last; ++x) {
            if (x < last && is_shown(x)) continue;
            place.begin_px = std::max(static_cast<double>(begin), begin_px);
            place.end_px = std::min(static_cast<double>(x), end_px);
            if (begin < x) note();
            begin = x + 1;
        }
    }

    /// The picture that hangs in a portal, where one looks through.
    static void note_pane(Layer& layer, WallOnScreen portal, const Window& beyond) {
        note_runs(
            portal, beyond, [&](int x) { return !beyond.at(x).is_closed(); }, [&] { layer.panes.push_back(portal); });
    }

    bool is_met(const Visit& visit, int x, double depth) const {
        const double slope = screen_.slope_at(x + 0.5);
        const double entry = visit.entry ? 1 / visit.doorway.inverse_depth(slope) : 0;
        return !visit.window.at(x).is_closed() &&
               is_met_between(depth, entry, 1 / nearest_[static_cast<std::size_t>(x - visit.window.begin)]);
    }

    void look_through(Layer& layer, const Visit& visit, const WallOnScreen& wall) {
        const Wall& portal = map_[wall.wall];
        const Heights opening = parts_of(map_, snapshot_, portal, layer.eye.z).opening;
        if (opening.floor >= opening.ceiling) return;
        Window beyond;
        const double nearest = open_columns(visit, wall, opening, beyond);
        if (beyond.rows.empty()) return;
        if (portal.middle.texture) note_pane(layer, wall, beyond);
        if (leads_out(portal)) return note_exit(wall, nearest, beyond);
        if (plan_.visits + visits_.size() < kMostVisits)
            visits_.push_back({portal.behind, portal.exit, wall, std::move(beyond)});
    }

    /// A portal behind which a new layer begins.
    bool leads_out(const Wall& portal) const {
        return portal.link != Wall::kNoLink || facts_.overlaps[portal.sector.index] ||
               facts_.overlaps[portal.behind.index];
    }

    /// What of the visit's window is open through the portal, and the portal's largest inverse depth there.
    double open_columns(const Visit& visit, const WallOnScreen& wall, const Heights& opening, Window& beyond) const {
        double largest = 0;
        const int begin = visit.window.begin, end = visit.window.end();
        const int last = first_at(wall.end_px + kSlack, begin, end);
        for (int x = first_at(wall.begin_px - kSlack, begin, end); x < last; ++x) {
            const double px = std::clamp(x + 0.5, wall.begin_px, wall.end_px);
            const double inverse = wall.inverse_depth(screen_.slope_at(px));
            if (inverse < nearest_[static_cast<std::size_t>(x - begin)] * (1 - kTie)) continue;
            const OpenRows parent = visit.window.at(x);
            const double top = row_of(screen_, wall, opening.ceiling, px) - kSlack;
            const double bottom = row_of(screen_, wall, opening.floor, px) + kSlack;
            const OpenRows rows{first_at(top, parent.top, parent.bottom), first_at(bottom, parent.top, parent.bottom)};
            if (rows.is_closed()) continue;
            beyond.open(x, rows);
            largest = std::max(largest, inverse);
        }
        return largest;
    }

    struct ExitWindow {
        Exit exit;
        Window window;
    };

    /// One portal may be seen through several chains of doorways: they all show parts of the same picture.
    void note_exit(const WallOnScreen& wall, double nearest, const Window& window) {
        const auto is_it = [&](const ExitWindow& seen) { return seen.exit.wall.wall == wall.wall; };
        const auto found = std::find_if(exit_windows_.begin(), exit_windows_.end(), is_it);
        if (found == exit_windows_.end()) {
            exit_windows_.push_back({{wall, nearest, Exit::kCut}, window});
            return;
        }
        found->exit.nearest = std::max(found->exit.nearest, nearest);
        for (int x = window.begin; x < window.end(); ++x)
            if (!window.at(x).is_closed()) found->window.open(x, window.at(x));
    }

    void follow_exits(std::size_t layer) {
        std::stable_sort(exit_windows_.begin(), exit_windows_.end(),
                         [](const ExitWindow& a, const ExitWindow& b) { return a.exit.nearest > b.exit.nearest; });
        for (ExitWindow& seen : exit_windows_) {
            if (may_follow(plan_.layers[layer], map_[seen.exit.wall.wall])) {
                seen.exit.layer = plan_.layers.size();
                add_layer(layer, seen);
            } else {
                ++plan_.cut;
            }
            plan_.layers[layer].exits.push_back(seen.exit);
        }
    }

    bool may_follow(const Layer& layer, const Wall& portal) const {
        if (layer.level >= kDeepestLevel || plan_.layers.size() >= kMostLayers || plan_.visits >= kMostVisits)
            return false;
        return portal.link == Wall::kNoLink || layer.eye.links < map_.render.max_depth;
    }

    void add_layer(std::size_t parent_index, ExitWindow& seen) {
        const Layer& parent = plan_.layers[parent_index];
        const Wall& portal = map_[seen.exit.wall.wall];
        const bool is_link = portal.link != Wall::kNoLink;
        Layer child{is_link ? beyond(parent.eye, map_.passage(portal)) : parent.eye,
                    portal.exit,
                    seen.exit.wall.begin_px,
                    seen.exit.wall.end_px,
                    parent.level + 1,
                    box_around(seen.window),
                    {},
                    {},
                    {}};
        plan_.deepest = std::max(plan_.deepest, child.level);
        plan_.layers.push_back(std::move(child));
        first_visits_.push_back({portal.behind, portal.exit, seen.exit.wall, std::move(seen.window)});
    }

    const Map& map_;
    const MapFacts& facts_;
    const TextureSet& textures_;
    const Snapshot& snapshot_;
    const Screen& screen_;
    Plan plan_;
    std::vector<Visit> first_visits_;  ///< by layer
    // The layer and the visit being looked into.
    std::vector<Visit> visits_;
    std::vector<WallOnScreen> walls_;
    std::vector<ThingOnScreen> things_;
    std::vector<double> nearest_;
    std::vector<ExitWindow> exit_windows_;
};

Heights heights_above(const SectorSnapshot& sector, double eye_z) {
    return {sector.floor_z - eye_z, sector.ceiling_z - eye_z};
}

}  // namespace

void Window::open(int x, OpenRows more) {
    if (rows.empty()) begin = x;
    if (x < begin) {
        rows.insert(rows.begin(), static_cast<std::size_t>(begin - x), OpenRows{});
        begin = x;
    }
    if (x >= end()) rows.resize(static_cast<std::size_t>(x - begin) + 1);
    OpenRows& now = at(x);
    now = now.is_closed() ? more : OpenRows{std::min(now.top, more.top), std::max(now.bottom, more.bottom)};
}

Box box_around(const Window& window) {
    Box box{window.begin, window.end(), 0, 0};
    for (const OpenRows& rows : window.rows) {
        if (rows.is_closed()) continue;
        const bool is_first = box.begin_y >= box.end_y;
        box.begin_y = is_first ? rows.top : std::min(box.begin_y, rows.top);
        box.end_y = is_first ? rows.bottom : std::max(box.end_y, rows.bottom);
    }
    return box;
}

WallParts parts_of(const Map& map, const Snapshot& snapshot, const Wall& wall, double eye_z) {
    WallParts parts;
    parts.room = parts.behind = heights_above(snapshot[wall.sector], eye_z);
    if (wall.kind == WallKind::solid) return parts;
    parts.opening = parts.room;
    if (wall.kind == WallKind::mirror) return parts;
    parts.behind = heights_above(snapshot[wall.behind], map.passage(wall).apply_height(eye_z));
    const bool both_sky = map[wall.sector].ceiling.sky && map[wall.behind].ceiling.sky;
    parts.upper = wall.upper.texture && !both_sky;
    parts.lower = static_cast<bool>(wall.lower.texture);
    const double top = std::clamp(parts.behind.ceiling, parts.room.floor, parts.room.ceiling);
    if (parts.upper) parts.opening.ceiling = top;
    if (parts.lower) parts.opening.floor = std::clamp(parts.behind.floor, parts.room.floor, top);
    return parts;
}

Plan make_plan(const Map& map, const MapFacts& facts, const TextureSet& textures, const Snapshot& snapshot,
               const Screen& screen, const View& view) {
    return Planner(map, facts, textures, snapshot, screen).plan(view);
}

}  // namespace enfilade::stencil
