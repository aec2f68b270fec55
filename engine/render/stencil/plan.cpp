#include "render/stencil/plan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "render/openings.h"
#include "render/stencil/panorama.h"
#include "render/stencil/wall_on_screen.h"

namespace enfilade::stencil {
namespace {

/// Sectors looked into for one frame, whatever the looks' own budgets (render/openings.h). A view into a large map
/// takes a few hundred; only links that lead on for ever meet this.
constexpr std::size_t kMostVisits = 1u << 16;

/// Layers of one frame: each is drawn and masked on its own.
constexpr std::size_t kMostLayers = 1u << 13;

/// A doorway that leads out of the layer being filled, and what is open behind it.
struct OpenExit {
    Exit exit;
    bool is_spent;              ///< all looks that led here have spent their budget
    std::vector<Visit> visits;  ///< the looks through it, one for each face
};

class LayerPlanner {
public:
    LayerPlanner(const FrameInput& input, const Screen& screen, const RayField& rays)
        : input_(input), screen_(screen), rays_(rays), room_(input.map, screen), panes_(input, screen) {}

    Plan plan(const View& view) {
        start(view);
        for (std::size_t i = 0; i < plan_.layers.size(); ++i) {
            fill(plan_.layers[i], std::move(first_visits_[i]));
            follow_exits(i);
        }
        return std::move(plan_);
    }

private:
    const Map& map() const { return input_.map; }

    void start(const View& view) {
        panes_.start();
        Layer& first = plan_.layers.emplace_back();
        first.pose = pose_of(view);
        first.box = {0, rays_.width, 0, rays_.height};
        std::vector<Visit>& visits = first_visits_.emplace_back();
        const std::uint32_t spent = cost_of_look_into(map()[view.sector], 0);
        if (rays_.is_tilted) {
            for (std::size_t face = 0; face < kFaces; ++face)
                visits.push_back({view.sector, {}, {}, panorama_window(screen_, rays_, face), face, 0, spent});
        } else {
            const std::vector<OpenRows> rows(static_cast<std::size_t>(screen_.width), OpenRows{0, screen_.height});
            visits.push_back({view.sector, {}, {}, {0, rows}, 0, 0, spent});
        }
    }

    /// Finds the layer's sectors and, in exits_, its exits; upright, its walls and panes.
    void fill(Layer& layer, std::vector<Visit> visits) {
        exits_.clear();
        seen_through_.clear();
        visits_ = std::move(visits);
        const std::vector<Visit> looks = rays_.is_tilted && layer.entry ? visits_ : std::vector<Visit>();
        while (!visits_.empty()) {
            const Visit visit = take_visit();
            if (visit.window.is_empty() || (rays_.is_tilted && was_seen(visit))) continue;
            look_into(layer, visit);
            plan_.rooms.push_back({visit.sector, visit.depth, visit.window});
        }
        if (rays_.is_tilted) look_through_stand_ins(layer, looks);
    }

    /// Tilted: of the looks that are left the one that has spent least, so that of two ways to a doorway the cheaper is
    /// followed, and only it (was_seen).
    Visit take_visit() {
        if (rays_.is_tilted)
            std::iter_swap(visits_.end() - 1, std::min_element(visits_.begin(), visits_.end(), spent_less));
        Visit visit = std::move(visits_.back());
        visits_.pop_back();
        return visit;
    }

    static bool spent_less(const Visit& a, const Visit& b) { return a.spent < b.spent; }

    /// Whether a look through the same doorway saw all of it already. Columns that stand for ranges of rays know two
    /// doorways that are side by side from each other no better than two in a row: without this, chains lead from each
    /// of them into the other for ever.
    bool was_seen(const Visit& visit) {
        ClipWindow& seen = seen_through_[{visit.entry.index, visit.face}];
        if (seen.holds(visit.window)) return true;
        seen.open(visit.window);
        return false;
    }

    void look_into(Layer& layer, const Visit& visit) {
        note_sector(layer, visit.sector);
        room_.look(visit, face_of(layer.pose, visit.face));
        if (!rays_.is_tilted) {
            room_.add_met(layer.walls);
            panes_.note(layer, room_);
        }
        for (const WallOnScreen& wall : room_.walls())
            if (kind_now(map(), input_.snapshot, wall.wall) != WallKind::solid) look_through(layer, wall);
    }

    static void note_sector(Layer& layer, SectorId sector) {
        const auto found = std::find(layer.sectors.begin(), layer.sectors.end(), sector);
        if (found == layer.sectors.end()) layer.sectors.push_back(sector);
    }

    void look_through(Layer& layer, const WallOnScreen& wall) {
        const Wall& portal = map()[wall.wall];
        const RelativeHeights opening = parts_of(map(), input_.snapshot, wall.wall, layer.pose.eye_z).opening;
        if (opening.is_empty()) return;
        double nearest = 0;
        ClipWindow beyond = room_.open_behind(wall, opening, nearest);
        if (beyond.is_empty()) return;
        if (map()[portal.middle].texture && !rays_.is_tilted) note_hanging(layer, wall, beyond);
        look_behind(wall, std::move(beyond), nearest, room_.visit());
    }

    /// beyond: what is open; here: the look that got to the portal.
    void look_behind(const WallOnScreen& wall, ClipWindow beyond, double nearest, const Visit& here) {
        Visit visit = visit_behind(wall, std::move(beyond), here);
        if (leads_out(map()[wall.wall]) || is_spent(here))
            note_exit(wall.wall, nearest, is_spent(here), std::move(visit));
        else
            visits_.push_back(std::move(visit));
    }

    Visit visit_behind(const WallOnScreen& wall, ClipWindow beyond, const Visit& here) const {
        const Wall& portal = map()[wall.wall];
        return {portal.behind,
                portal.exit,
                wall,
                std::move(beyond),
                here.face,
                here.depth + 1,
                here.spent + cost_of_look_into(map()[portal.behind], input_.snapshot.things.in(portal.behind).size())};
    }

    /// Through those of a tilted layer that are portals, in all that the layer shows. What is behind is a layer of its
    /// own, where walls may have to stand in again. looks: the first ones.
    void look_through_stand_ins(Layer& layer, const std::vector<Visit>& looks) {
        layer.stand_ins = tilted_stand_ins(layer, map());
        for (const WallOnScreen& wall : layer.stand_ins)
            if (!parts_of(map(), input_.snapshot, wall.wall, layer.pose.eye_z).opening.is_empty())
                for (const Visit& look : looks)
                    note_exit(wall.wall, 1 / kNearestSprite, is_spent(look), visit_behind(wall, look.window, look));
    }

    /// Whether a look that got here goes no further.
    bool is_spent(const Visit& here) const {
        return here.spent >= kLookBudget || plan_.rooms.size() + visits_.size() >= kMostVisits;
    }

    /// The picture that hangs in a portal, in every run of columns in which one looks through.
    void note_hanging(Layer& layer, const WallOnScreen& portal, const ClipWindow& beyond) {
        for (int x = beyond.begin, begin = x; x <= beyond.end(); ++x) {
            if (x < beyond.end() && !beyond.at(x).is_closed() && panes_.pass(x)) continue;
            if (begin < x) {
                layer.panes.push_back(Hanging{portal});
                WallOnScreen& place = place_of(layer.panes.back());
                place.begin = begin;
                place.end = x;
                place.rank = room_.visit().depth;
                place.is_pane = true;
            }
            begin = x + 1;
        }
    }

    /// A portal behind which a new layer begins.
    bool leads_out(const Wall& portal) const {
        return portal.link != Wall::kNoLink || input_.facts.overlaps[portal.sector.index] ||
               input_.facts.overlaps[portal.behind.index];
    }

    /// One portal may be seen through several chains of doorways: they all show parts of the same picture.
    void note_exit(WallId wall, double nearest, bool is_spent, Visit visit) {
        const auto is_it = [&](const OpenExit& seen) { return seen.exit.wall == wall; };
        const auto found = std::find_if(exits_.begin(), exits_.end(), is_it);
        if (found == exits_.end()) {
            exits_.push_back({{wall, nearest, Exit::kCut}, is_spent, {std::move(visit)}});
            return;
        }
        found->is_spent &= is_spent;
        found->exit.nearest = std::max(found->exit.nearest, nearest);
        const auto is_face = [&](const Visit& other) { return other.face == visit.face; };
        const auto same = std::find_if(found->visits.begin(), found->visits.end(), is_face);
        if (same == found->visits.end())
            found->visits.push_back(std::move(visit));
        else
            same->window.open(visit.window);
    }

    void follow_exits(std::size_t layer) {
        std::stable_sort(exits_.begin(), exits_.end(),
                         [](const OpenExit& a, const OpenExit& b) { return a.exit.nearest > b.exit.nearest; });
        for (OpenExit& seen : exits_) {
            Layer child = layer_behind(plan_.layers[layer], seen);
            if (child.box.is_empty()) continue;
            const bool is_spent = seen.is_spent || plan_.layers.size() >= kMostLayers;
            if (!is_spent && may_follow(plan_.layers[layer], map()[seen.exit.wall])) {
                seen.exit.layer = plan_.layers.size();
                plan_.deepest = std::max(plan_.deepest, child.level);
                plan_.layers.push_back(std::move(child));
                first_visits_.push_back(std::move(seen.visits));
            } else {
                ++plan_.cut;
                plan_.is_cut_short |= is_spent;
            }
            plan_.layers[layer].exits.push_back(seen.exit);
        }
    }

    bool may_follow(const Layer& layer, const Wall& portal) const {
        return portal.link == Wall::kNoLink || layer.pose.links < map().render.max_depth;
    }

    Layer layer_behind(const Layer& parent, const OpenExit& seen) const {
        const Wall& portal = map()[seen.exit.wall];
        Layer child;
        child.pose = portal.link != Wall::kNoLink ? beyond(parent.pose, map().passage(portal)) : parent.pose;
        child.entry = portal.exit;
        child.opened = seen.visits[0].doorway;
        child.level = parent.level + 1;
        if (rays_.is_tilted) {
            child.opened = *in_view(map(), seen.exit.wall, parent.pose);
            const RelativeHeights opening = parts_of(map(), input_.snapshot, seen.exit.wall, parent.pose.eye_z).opening;
            child.box = common(parent.box, box_around(rays_, child.opened, opening));
            if (is_missed(parent, seen.exit.wall)) open_by_stand_ins(child, parent, seen.exit.wall);
        } else {
            child.box = box_around(seen.visits[0].window);
        }
        return child;
    }

    static bool is_missed(const Layer& layer, WallId portal) {
        return std::any_of(layer.stand_ins.begin(), layer.stand_ins.end(),
                           [&](const WallOnScreen& wall) { return wall.wall == portal && wall.missed; });
    }

    /// One looks in anywhere between the first and the last of those that are missed.
    static void open_by_stand_ins(Layer& child, const Layer& parent, WallId portal) {
        child.box = parent.box;
        bool is_first = true;
        for (const WallOnScreen& wall : parent.stand_ins) {
            if (wall.wall != portal || !wall.missed) continue;
            const Vec2 left = is_first ? wall.shown_left_v : child.opened.shown_left_v;
            child.opened = wall;
            child.opened.shown_left_v = left;
            is_first = false;
        }
    }

    const FrameInput& input_;
    const Screen& screen_;
    const RayField& rays_;
    RoomLook room_;
    RoomPanes panes_;
    Plan plan_;
    std::vector<std::vector<Visit>> first_visits_;  ///< by layer
    // Of the layer being filled.
    std::vector<Visit> visits_;
    std::map<std::pair<std::size_t, std::size_t>, ClipWindow> seen_through_;  ///< tilted: by entry and face
    std::vector<OpenExit> exits_;
};

}  // namespace

Plan make_plan(const FrameInput& input, const Screen& screen, const RayField& rays, const View& view) {
    return LayerPlanner(input, screen, rays).plan(view);
}

}  // namespace enfilade::stencil
