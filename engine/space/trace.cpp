#include "space/trace.h"

#include "math/predicates.h"
#include "space/leg.h"

namespace enfilade {
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
