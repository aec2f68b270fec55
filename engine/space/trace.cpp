#include "space/trace.h"

#include <algorithm>
#include <optional>

#include "math/predicates.h"
#include "space/leg.h"

namespace enfilade {

namespace {

struct Found {
    MetPanel met;
    PathFraction at;
};
using AllFound = ShortList<Found, 8>;

PathFraction fraction_at(const Leg& leg, Vec2 a, Vec2 b) { return fraction_along_path(leg.from, leg.to, a, b); }

/// The part of a leg's path that is in its sector.
class Inside {
public:
    Inside(const Map& map, const Leg& leg, WallId exit) : leg_(leg) {
        if (leg.entry) begin_ = fraction_at(leg, map[leg.entry].a, map[leg.entry].b);
        if (exit) end_ = fraction_at(leg, map[exit].a, map[exit].b);
    }

    void add(const Map& map, PanelId id, AllFound& found) const {
        const Panel& panel = map[id];
        if (!panel.is_active() || !boxes_touch(leg_, panel.a, panel.b)) return;
        const bool from_behind = side_of_line(panel.a, panel.b, leg_.from) < 0;
        const Vec2 a = from_behind ? panel.b : panel.a, b = from_behind ? panel.a : panel.b;
        if (!path_leaves_through(leg_.from, leg_.to, a, b)) return;
        const PathFraction at = fraction_at(leg_, a, b);
        if ((begin_ && compare(at, *begin_) < 0) || (end_ && compare(at, *end_) > 0)) return;
        found.push_back({{id, from_behind}, at});
        const auto is_before = [](const Found& f, const Found& g) { return compare(f.at, g.at) < 0; };
        std::rotate(std::upper_bound(found.begin(), found.end() - 1, found.back(), is_before), found.end() - 1,
                    found.end());
    }

private:
    const Leg& leg_;
    std::optional<PathFraction> begin_, end_;
};

void add_in_order(const Map& map, const Leg& leg, WallId exit, MetPanels& met) {
    if (leg.from == leg.to) return;
    const Sector& sector = map[leg.sector];
    const Inside inside(map, leg, exit);
    AllFound found;
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
        inside.add(map, PanelId(i), found);
    for (const Found& f : found) met.push_back(f.met);
}

}  // namespace

void add_panels_met(const Map& map, const Leg& leg, WallId exit, MetPanels& met) {
    if (map[leg.sector].active_panels == 0) return;
    if (leg.hop) add_in_order(map, {leg.sector, leg.hop->from, leg.from, leg.hop->through}, {}, met);
    add_in_order(map, leg, exit, met);
}

MetPanel first_barrier(const Map& map, const Leg& leg, WallId exit, const MayCross& may_cross) {
    if (!may_cross || map[leg.sector].active_panels == 0) return {};
    MetPanels met;
    add_panels_met(map, leg, exit, met);
    for (const MetPanel& panel : met)
        if (!may_cross(panel)) return panel;
    return {};
}

namespace {

/// A path under way: its legs so far, each in the space of its own sector.
class Path {
public:
    Path(const Map& map, const Place& from, Vec2 to, const MayCross& may_cross) : map_(map), may_cross_(may_cross) {
        legs_.push_back({{from.sector, from.point, to, {}}, {}, 0});
    }

    /// The wall the newest leg leaves its sector by, or none.
    WallId way_out() const { return enfilade::way_out(map_, newest()); }
    const Rigid& passage() const { return legs_.back().passage; }

    /// The first panel that the newest leg may not cross before it leaves by a wall, or none.
    MetPanel barrier_before(WallId exit) const { return first_barrier(map_, newest(), exit, may_cross_); }

    /// Goes on behind the portal; false where that cannot be.
    bool pass(WallId portal) {
        const Wall& wall = map_[portal];
        if (wall.link != Wall::kNoLink && ++links_ > kMaxLinksOnPath) return false;
        const auto leg = leg_behind(map_, newest(), portal);
        if (!leg) return false;
        add_panels(newest(), portal);
        crossings_.push_back({portal, {}});
        legs_.push_back({*leg, then(passage(), map_.passage(wall)), crossings_.size()});
        return true;
    }

    Trace ended() {
        add_panels(newest(), {});
        return result(newest().to);
    }

    Trace stopped_by(WallId wall) {
        Trace trace = stopped_at(map_[wall].a, map_[wall].b);
        trace.stopped = wall;
        return trace;
    }

    Trace stopped_by(const MetPanel& barrier) {
        Trace trace = stopped_at(map_[barrier.panel].a, map_[barrier.panel].b);
        trace.barrier = barrier;
        return trace;
    }

private:
    struct LegInSpace {
        Leg leg;
        Rigid passage;            ///< from the space of the start into that of the leg
        std::size_t crossed = 0;  ///< how many crossings there were before it
    };

    const Leg& newest() const { return legs_.back().leg; }

    void add_panels(const Leg& leg, WallId exit) {
        if (!may_cross_ || map_[leg.sector].active_panels == 0) return;
        MetPanels met;
        add_panels_met(map_, leg, exit, met);
        for (const MetPanel& panel : met) crossings_.push_back({{}, panel});
    }

    std::optional<Vec2> last_point_before(Vec2 a, Vec2 b) const {
        const auto is_free = [this](const Leg& leg) { return !first_barrier(map_, leg, {}, may_cross_).panel; };
        return enfilade::last_point_before(map_, newest(), a, b, is_free);
    }

    /// Steps back from the edge, over portals if need be. The first leg always has a point: where it starts.
    Trace stopped_at(Vec2 a, Vec2 b) {
        std::optional<Vec2> end = last_point_before(a, b);
        while (!end) {
            const Wall& portal = map_[crossings_[legs_.back().crossed - 1].portal];
            legs_.pop_back();
            end = last_point_before(portal.a, portal.b);
        }
        crossings_.erase_from(crossings_.begin() + legs_.back().crossed);
        Leg taken = newest();
        taken.to = *end;
        add_panels(taken, {});
        return result(*end);
    }

    Trace result(Vec2 end) { return {std::move(crossings_), {legs_.back().leg.sector, end}, {}, {}, passage()}; }

    const Map& map_;
    const MayCross& may_cross_;
    ShortList<LegInSpace, 8> legs_;
    Crossings crossings_;
    int links_ = 0;
};

}  // namespace

Trace trace(const Map& map, const Place& from, Vec2 to, const MayPass& may_pass, const MayCross& may_cross) {
    Path path(map, from, to, may_cross);
    while (true) {
        const WallId wall = path.way_out();
        if (const MetPanel barrier = path.barrier_before(wall); barrier.panel) return path.stopped_by(barrier);
        if (!wall) return path.ended();
        if (!is_passable(map, wall, path.passage(), may_pass) || !path.pass(wall)) return path.stopped_by(wall);
    }
}

}  // namespace enfilade
