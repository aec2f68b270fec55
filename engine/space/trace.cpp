#include "space/trace.h"

#include <algorithm>
#include <optional>

#include "map/sector_finder.h"
#include "math/predicates.h"

namespace enfilade {

bool contains(const Map& map, SectorId sector, Vec2 p) { return is_inside(map, sector, p); }

SectorId locate(const Map& map, Vec2 p) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (contains(map, SectorId(i), p)) return SectorId(i);
    return {};
}

SectorId locate_near(const Map& map, SectorId near, Vec2 p) {
    if (contains(map, near, p)) return near;
    const Sector& sector = map[near];
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        const Wall& wall = map.walls[i];
        if (wall.kind == WallKind::portal && wall.link == Wall::kNoLink && contains(map, wall.behind, p))
            return wall.behind;
    }
    return locate(map, p);
}

namespace {

struct PanelOnPath {
    MetPanel met;
    PathFraction at;
};
using AllFound = ShortList<PanelOnPath, 8>;

/// The part of a segment's path that is in its sector.
class Inside {
public:
    Inside(const Map& map, const PathSegment& segment, WallId exit) : segment_(segment) {
        if (segment.entry) begin_ = fraction_at(segment, map[segment.entry].a, map[segment.entry].b);
        if (exit) end_ = fraction_at(segment, map[exit].a, map[exit].b);
    }

    void add(const Map& map, PanelId id, AllFound& found) const {
        const Panel& panel = map[id];
        if (!panel.is_active() || !boxes_touch(segment_, panel.a, panel.b)) return;
        const bool from_behind = side_of_line(panel.a, panel.b, segment_.from) < 0;
        const Vec2 a = from_behind ? panel.b : panel.a, b = from_behind ? panel.a : panel.b;
        if (!path_leaves_through(segment_.from, segment_.to, a, b)) return;
        const PathFraction at = fraction_at(segment_, a, b);
        if ((begin_ && compare(at, *begin_) < 0) || (end_ && compare(at, *end_) > 0)) return;
        found.push_back({{id, from_behind}, at});
        const auto is_before = [](const PanelOnPath& f, const PanelOnPath& g) { return compare(f.at, g.at) < 0; };
        std::rotate(std::upper_bound(found.begin(), found.end() - 1, found.back(), is_before), found.end() - 1,
                    found.end());
    }

private:
    const PathSegment& segment_;
    std::optional<PathFraction> begin_, end_;
};

void add_in_order(const Map& map, const PathSegment& segment, WallId exit, MetPanels& met) {
    if (segment.from == segment.to) return;
    const Sector& sector = map[segment.sector];
    const Inside inside(map, segment, exit);
    AllFound found;
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
        inside.add(map, PanelId(i), found);
    for (const PanelOnPath& f : found) met.push_back(f.met);
}

}  // namespace

void add_panels_met(const Map& map, const PathSegment& segment, WallId exit, MetPanels& met) {
    if (map[segment.sector].active_panels == 0) return;
    if (segment.hop)
        add_in_order(map, {segment.sector, segment.hop->from, segment.from, segment.hop->through}, {}, met);
    add_in_order(map, segment, exit, met);
}

MetPanel first_barrier(const Map& map, const PathSegment& segment, WallId exit, const MayCross& may_cross) {
    if (!may_cross || map[segment.sector].active_panels == 0) return {};
    MetPanels met;
    add_panels_met(map, segment, exit, met);
    for (const MetPanel& panel : met)
        if (!may_cross(panel)) return panel;
    return {};
}

namespace {

/// A path under way: its segments so far, each in the space of its own sector.
class Path {
public:
    Path(const Map& map, const Place& from, Vec2 to, const MayCross& may_cross) : map_(map), may_cross_(may_cross) {
        segments_.push_back({{from.sector, from.point, to, {}}, {}, 0});
    }

    /// The wall the newest segment leaves its sector by, or none.
    WallId way_out() const { return enfilade::way_out(map_, newest()); }
    const Rigid& passage() const { return segments_.back().passage; }

    /// The first panel that the newest segment may not cross before it leaves by a wall, or none.
    MetPanel barrier_before(WallId exit) const { return first_barrier(map_, newest(), exit, may_cross_); }

    /// Goes on behind the portal; false where that cannot be.
    bool pass(WallId portal) {
        const Wall& wall = map_[portal];
        if (wall.link != Wall::kNoLink && ++links_ > kMaxLinksOnPath) return false;
        const auto segment = segment_behind(map_, newest(), portal);
        if (!segment) return false;
        add_panels(newest(), portal);
        crossings_.push_back({portal, {}});
        segments_.push_back({*segment, then(passage(), map_.passage(wall)), crossings_.size()});
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
        PathSegment segment;
        Rigid passage;            ///< from the space of the start into that of the segment
        std::size_t crossed = 0;  ///< how many crossings there were before it
    };

    const PathSegment& newest() const { return segments_.back().segment; }

    void add_panels(const PathSegment& segment, WallId exit) {
        if (!may_cross_ || map_[segment.sector].active_panels == 0) return;
        MetPanels met;
        add_panels_met(map_, segment, exit, met);
        for (const MetPanel& panel : met) crossings_.push_back({{}, panel});
    }

    std::optional<Vec2> last_point_before(Vec2 a, Vec2 b) const {
        const auto is_free = [this](const PathSegment& segment) {
            return !first_barrier(map_, segment, {}, may_cross_).panel;
        };
        return enfilade::last_point_before(map_, newest(), a, b, is_free);
    }

    /// Steps back from the edge, over portals if need be. The first segment always has a point: where it starts.
    Trace stopped_at(Vec2 a, Vec2 b) {
        std::optional<Vec2> end = last_point_before(a, b);
        while (!end) {
            const Wall& portal = map_[crossings_[segments_.back().crossed - 1].portal];
            segments_.pop_back();
            end = last_point_before(portal.a, portal.b);
        }
        crossings_.erase_from(crossings_.begin() + segments_.back().crossed);
        PathSegment taken = newest();
        taken.to = *end;
        add_panels(taken, {});
        return result(*end);
    }

    Trace result(Vec2 end) {
        return {std::move(crossings_), {segments_.back().segment.sector, end}, {}, {}, passage()};
    }

    const Map& map_;
    const MayCross& may_cross_;
    ShortList<LegInSpace, 8> segments_;
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

namespace {

PassedPortal passed_portal(const Map& map, const PathSegment& segment, WallId id, double rise) {
    const Wall& wall = map[id];
    const double at = fraction_along_path(segment.from, segment.to, wall.a, wall.b).value();
    return {id, segment.from, std::clamp(at, 0.0, 1.0), rise};
}

}  // namespace

void look_along(const Map& map, const Place& from, Vec2 to, SightLine& line) {
    line.passed.clear();
    line.met = {};
    line.rise = 0;
    PathSegment segment{from.sector, from.point, to, {}};
    int links = 0;
    while (const WallId wall = way_out(map, segment)) {
        const bool is_link = map[wall].link != Wall::kNoLink;
        const bool passes = map[wall].kind == WallKind::portal && !(is_link && ++links > kMaxLinksOnPath);
        const std::optional<PathSegment> next = passes ? segment_behind(map, segment, wall) : std::nullopt;
        if (!next) {
            line.met = wall;
            break;
        }
        line.passed.push_back(passed_portal(map, segment, wall, line.rise));
        line.rise += map.passage(map[wall]).rise;
        segment = *next;
    }
    line.sector = segment.sector;
    line.from = segment.from;
}

}  // namespace enfilade
