#include "space/trace.h"

#include "math/predicates.h"
#include "space/leg.h"

namespace enfilade {
namespace {

/// A path under way: its legs so far, each in the space of its own sector.
class Path {
public:
    Path(const Map& map, const Place& from, Vec2 to) : map_(map) {
        legs_.push_back({{from.sector, from.point, to, {}}, {}});
    }

    /// The wall the newest leg leaves its sector by, or none.
    WallId way_out() const { return enfilade::way_out(map_, legs_.back().leg); }
    const Rigid& passage() const { return legs_.back().passage; }

    /// Goes on behind the portal; false where that cannot be.
    bool pass(WallId portal) {
        const Wall& wall = map_[portal];
        if (wall.link != Wall::kNoLink && ++links_ > kMaxLinksOnPath) return false;
        const auto leg = leg_behind(map_, legs_.back().leg, portal);
        if (!leg) return false;
        crossings_.push_back({portal});
        legs_.push_back({*leg, then(passage(), map_.passage(wall))});
        return true;
    }

    Trace ended() { return result(legs_.back().leg.to, {}); }

    /// Steps back from the wall, over portals if need be. The first leg always has a point: where it starts.
    Trace stopped_by(WallId wall) {
        std::optional<Vec2> end = last_point_before(map_, legs_.back().leg, wall);
        while (!end) {
            const WallId portal = crossings_.back().portal;
            crossings_.pop_back();
            legs_.pop_back();
            end = last_point_before(map_, legs_.back().leg, portal);
        }
        return result(*end, wall);
    }

private:
    struct LegInSpace {
        Leg leg;
        Rigid passage;  ///< from the space of the start into that of the leg
    };

    Trace result(Vec2 end, WallId stopped) {
        return {std::move(crossings_), {legs_.back().leg.sector, end}, stopped, passage()};
    }

    const Map& map_;
    ShortList<LegInSpace, 8> legs_;
    Crossings crossings_;
    int links_ = 0;
};

}  // namespace

Trace trace(const Map& map, const Place& from, Vec2 to, const MayPass& may_pass) {
    Path path(map, from, to);
    while (const WallId wall = path.way_out()) {
        const bool open = map[wall].kind == WallKind::portal && (!may_pass || may_pass(wall, path.passage()));
        if (!open || !path.pass(wall)) return path.stopped_by(wall);
    }
    return path.ended();
}

}  // namespace enfilade
