// Where openings are: which walls they cut, and from where to where, decided on the grid of corners.
#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/expand.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// Walls that may be looked at for all openings of a map together: each may be moved by a cut, in a quarter of a
/// second.
constexpr std::size_t kMostLookedAt = 4'000'000;

/// Two rooms that are farther apart have another one between them, rather than a wall [m].
constexpr double kThickestWall = 2;

/// So many pairs of walls are compared in the time in which one is moved.
constexpr std::size_t kPairsPerWall = 16;

/// A corner in steps of the grid: up to 2^25 each, so that products of differences are exact in 64 bits.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    static GridPoint of(Vec2 v) {
        const Vec2 snapped = snap_to_vertex_grid(v);
        return {static_cast<std::int64_t>(snapped.x / kVertexGrid), static_cast<std::int64_t>(snapped.y / kVertexGrid)};
    }
    bool operator==(const GridPoint&) const = default;
};

GridPoint operator+(GridPoint a, GridPoint b) { return {a.x + b.x, a.y + b.y}; }
GridPoint operator-(GridPoint a, GridPoint b) { return {a.x - b.x, a.y - b.y}; }
std::int64_t dot(GridPoint a, GridPoint b) { return a.x * b.x + a.y * b.y; }
std::int64_t cross(GridPoint a, GridPoint b) { return a.x * b.y - a.y * b.x; }

/// A wall seen from its line: how far along it and how far beside it points are.
struct WallLine {
    GridPoint a, along;
    std::int64_t square = 0;  ///< of its length; 0: it has none

    static WallLine of(const LoopRecord& loop, std::size_t wall) {
        WallLine line{GridPoint::of(loop.vertices[wall]), {}};
        line.along = GridPoint::of(loop.vertices[(wall + 1) % loop.vertices.size()]) - line.a;
        line.square = dot(line.along, line.along);
        return line;
    }
    double length_steps() const { return std::sqrt(static_cast<double>(square)); }
    /// 0 at its beginning, `square` at its end.
    std::int64_t part(GridPoint p) const { return dot(along, p - a); }
    /// Positive to its right, where its sector is.
    std::int64_t side(GridPoint p) const { return cross(along, p - a); }
    double distance_steps(GridPoint p) const {
        const auto nearest = std::clamp<std::int64_t>(part(p), 0, square);
        const double beyond = static_cast<double>(part(p) - nearest) / length_steps();
        const double beside = static_cast<double>(side(p)) / length_steps();
        return std::sqrt(beside * beside + beyond * beyond);
    }
    /// The point so many steps along it, on the grid. Exact where the wall is parallel to an axis.
    Vec2 at(double steps) const {
        const double length = length_steps();
        const Vec2 unit{static_cast<double>(along.x) / length, static_cast<double>(along.y) / length};
        const Vec2 begin{static_cast<double>(a.x), static_cast<double>(a.y)};
        return snap_to_vertex_grid((begin + unit * steps) * kVertexGrid);
    }
    double steps_to(GridPoint p) const { return static_cast<double>(part(p)) / length_steps(); }
    bool holds(GridPoint p) const { return part(p) >= 0 && part(p) <= square; }
    bool faces(const WallLine& other) const {
        return square > 0 && other.square > 0 && cross(along, other.along) == 0 && dot(along, other.along) < 0;
    }
};

std::string metres(double steps) { return number_text(std::round(steps * kVertexGrid * 1000) / 1000) + " m"; }

std::string wall_text(const WallLine& line) {
    return "the wall from " + point_text(line.at(0)) + " to " + point_text(line.at(line.length_steps()));
}

template <class Visit>
void for_walls(const SectorRecord& sector, std::size_t index, Visit visit) {
    for (std::size_t i = 0; i < sector.loops.size(); ++i)
        for (std::size_t k = 0; sector.loops[i].is_whole && k < sector.loops[i].walls.size(); ++k)
            visit(WallIndex{index, i, k}, WallLine::of(sector.loops[i], k));
}

bool is_whole(const SectorRecord& sector) {
    return !sector.loops.empty() && std::ranges::all_of(sector.loops, &LoopRecord::is_whole);
}

std::size_t walls_of(const SectorRecord& sector) {
    std::size_t count = 0;
    for (const LoopRecord& loop : sector.loops) count += loop.walls.size();
    return count;
}

/// Whether a point lies inside a sector and on none of its walls: rays to the right of it cross an odd number of them.
bool is_inside(const SectorRecord& sector, GridPoint p) {
    bool inside = false, on_wall = false;
    for_walls(sector, 0, [&](WallIndex, const WallLine& wall) {
        const GridPoint b = wall.a + wall.along;
        on_wall = on_wall || (wall.side(p) == 0 && dot(p - wall.a, p - b) <= 0);
        if ((wall.a.y <= p.y) != (b.y <= p.y)) inside ^= (wall.side(p) > 0) == (b.y < wall.a.y);
    });
    return inside && !on_wall;
}

/// A corner, or the middle of a wall, of one of the sectors that lies inside the other.
std::optional<Vec2> point_in_both(const SectorRecord& a, const SectorRecord& b) {
    std::optional<Vec2> found;
    const auto look = [&](const SectorRecord& in, Vec2 point) {
        if (!found && is_inside(in, GridPoint::of(point))) found = point;
    };
    for (const auto& [of, in] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (const LoopRecord& loop : of->loops)
            for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
                look(*in, loop.vertices[i]);
                look(*in, (loop.vertices[i] + loop.vertices[(i + 1) % loop.vertices.size()]) * 0.5);
            }
    return found;
}

/// The stretch of a wall before another one that faces it, in its own steps.
struct FacingStretch {
    WallIndex near, far;
    WallLine line;
    double begin = 0, end = 0;
    double distance = 0;  ///< from wall to wall [steps]
};

}  // namespace

const WallRecord& GapFinder::record(WallIndex wall) const {
    return map_.sectors[wall.sector].loops[wall.loop].walls[wall.wall];
}

/// Open already, or a place that a link leads to.
bool GapFinder::is_taken(WallIndex wall) const { return !record(wall).next.empty() || !record(wall).name.empty(); }

/// Whether as many walls may still be looked at, which then count, for the sake of a hint: it is left out where not.
bool GapFinder::can_afford(std::size_t walls) {
    if (walls > kMostLookedAt || looked_at_ > kMostLookedAt - walls) return false;
    looked_at_ += walls;
    return true;
}

bool GapFinder::is_too_much(const OpeningRecord& opening, std::size_t walls) {
    const bool was_noted = looked_at_ > kMostLookedAt;
    looked_at_ += walls;
    if (looked_at_ <= kMostLookedAt) return false;
    if (!was_noted)
        reading_.error(opening.place, "too-large",
                       "there are too many openings between sectors of too many walls; write the portals of the rest "
                       "out");
    return true;
}

/// The place nearest to a point where a wall of the sector that is not taken has room for the width, and a wall of the
/// sector that it is to face, if any, lies before all of it.
std::optional<Vec2> GapFinder::fitting_place(std::size_t sector, Vec2 point, double width,
                                             std::optional<std::size_t> facing) const {
    const GridPoint p = GridPoint::of(point);
    const double half = width / kVertexGrid / 2;
    std::optional<Vec2> best;
    double least = std::numeric_limits<double>::max();
    const auto offer = [&](const WallLine& line, double begin, double end) {
        if (end - begin < 2 * half) return;
        const Vec2 place = line.at(std::min(std::max(line.steps_to(p), begin + half), end - half));
        const GridPoint to_it = GridPoint::of(place) - p;
        const auto distance = static_cast<double>(dot(to_it, to_it));
        if (distance >= least) return;
        least = distance;
        best = place;
    };
    for_walls(map_.sectors[sector], sector, [&](WallIndex index, const WallLine& line) {
        if (is_taken(index) || line.square == 0) return;
        if (!facing) return offer(line, 0, line.length_steps());
        for_walls(map_.sectors[*facing], *facing, [&](WallIndex other, const WallLine& wall) {
            if (is_taken(other) || !line.faces(wall)) return;
            const double between = -static_cast<double>(line.side(wall.a)) / line.length_steps();
            if (between >= 0 && between <= kThickestWall / kVertexGrid)
                offer(line, std::max(0.0, line.steps_to(wall.a) - wall.length_steps()),
                      std::min(line.length_steps(), line.steps_to(wall.a)));
        });
    });
    return best;
}

std::optional<WallIndex> GapFinder::wall_at(std::size_t sector, Vec2 point, double width,
                                            std::optional<std::size_t> facing, TextPlace place) {
    const GridPoint p = GridPoint::of(point);
    std::optional<WallIndex> nearest;
    WallLine line;
    double least = std::numeric_limits<double>::max(), most_inside = 0;
    for_walls(map_.sectors[sector], sector, [&](WallIndex wall, const WallLine& candidate) {
        if (candidate.square == 0) return;
        const double distance = candidate.distance_steps(p);
        const double inside = std::min(candidate.steps_to(p), candidate.length_steps() - candidate.steps_to(p));
        if (distance > least || (distance == least && inside <= most_inside)) return;
        least = distance;
        most_inside = inside;
        nearest = wall;
        line = candidate;
    });
    if (nearest && least < 1) return nearest;
    std::string sentence =
        "expected a point on a wall of sector " + in_quotes(map_.sectors[sector].name) + ", found " + point_text(point);
    if (nearest) sentence += ", " + metres(least) + " from the nearest, " + wall_text(line);
    const std::size_t walls = walls_of(map_.sectors[sector]);
    const bool may_look = can_afford(facing ? walls * walls_of(map_.sectors[*facing]) / kPairsPerWall : walls);
    const auto fitting = may_look ? fitting_place(sector, point, width, facing) : std::nullopt;
    if (fitting)
        sentence += "; move it to " + point_text(*fitting);
    else if (may_look && facing)
        sentence += "; no free wall of it is close to one of sector " + in_quotes(map_.sectors[*facing].name) +
                    " over that width, so give 'to' for a doorway that leads elsewhere, or move a room";
    reading_.error(place, "opening-off-wall", sentence);
    return {};
}

/// A wall is opened within its ends, and once.
bool GapFinder::may_open(const Gap& gap, TextPlace place) {
    const SectorRecord& sector = map_.sectors[gap.wall.sector];
    const WallLine line = WallLine::of(sector.loops[gap.wall.loop], gap.wall.wall);
    const GridPoint begin = GridPoint::of(gap.begin), end = GridPoint::of(gap.end);
    const WallRecord& wall = record(gap.wall);
    if (is_taken(gap.wall)) {
        reading_.error(place, "opening-taken",
                       wall_text(line) + " of sector " + in_quotes(sector.name) +
                           (wall.next.empty() ? " is called " + in_quotes(wall.name) + ", and a link may lead to it"
                                              : " is open already, to sector " + in_quotes(wall.next)) +
                           "; put the opening elsewhere");
        return false;
    }
    if (!line.holds(begin) || !line.holds(end) || line.part(begin) >= line.part(end)) {
        const bool is_too_wide = line.part(end) - line.part(begin) > line.square;
        reading_.error(place, "opening-beyond-wall",
                       "expected an opening within " + wall_text(line) + " of sector " + in_quotes(sector.name) +
                           ", which is " + metres(line.length_steps()) + " long, found one from " +
                           point_text(gap.begin) + " to " + point_text(gap.end) +
                           (is_too_wide ? "; make it narrower" : "; move it, or make it narrower"));
        return false;
    }
    const bool was_noted = !reading_.findings.empty() && reading_.findings.back().place == place;  // at the other wall
    if ((line.side(begin) != 0 || line.side(end) != 0) && !was_noted && !reading_.is_full())
        reading_.findings.push_back(
            {place, Severity::warning, "opening-bends-wall",
             "the ends of the opening, " + point_text(gap.begin) + " and " + point_text(gap.end) + ", do not lie on " +
                 wall_text(line) + ", but on the nearest corners of the grid, up to " +
                 number_text(kVertexGrid / 2 * 1000) + " mm beside it: the wall is bent there"});
    return true;
}

std::optional<Gap> GapFinder::around(const OpeningRecord& opening, std::size_t sector, Vec2 middle,
                                     std::optional<std::size_t> facing, TextPlace place) {
    if (is_too_much(opening, walls_of(map_.sectors[sector]))) return {};
    const auto wall = wall_at(sector, middle, *opening.width, facing, place);
    if (!wall) return {};
    const WallLine line = WallLine::of(map_.sectors[sector].loops[wall->loop], wall->wall);
    const double at = line.steps_to(GridPoint::of(middle)), half = *opening.width / kVertexGrid / 2;
    const Gap gap{*wall, line.at(at - half), line.at(at + half)};
    if (!may_open(gap, place)) return {};
    return gap;
}

/// The part of the other sector's walls that lies before a gap over its whole width, the nearest of them.
std::optional<Gap> GapFinder::opposite(const OpeningRecord& opening, const Gap& near, std::size_t far_sector) {
    const SectorRecord& far = map_.sectors[far_sector];
    if (is_too_much(opening, walls_of(far))) return {};
    const WallLine line = WallLine::of(map_.sectors[near.wall.sector].loops[near.wall.loop], near.wall.wall);
    std::optional<Gap> nearest;
    double least = std::numeric_limits<double>::max();
    for_walls(far, far_sector, [&](WallIndex index, const WallLine& wall) {
        if (!line.faces(wall)) return;
        const double beyond = -static_cast<double>(line.side(wall.a)) / line.length_steps();
        const GridPoint begin = GridPoint::of(near.end), end = GridPoint::of(near.begin);
        if (beyond < 0 || beyond >= least || !wall.holds(begin) || !wall.holds(end)) return;
        least = beyond;
        const bool touches = line.side(wall.a) == 0;
        nearest = Gap{index, touches ? near.end : wall.at(wall.steps_to(begin)),
                      touches ? near.begin : wall.at(wall.steps_to(end))};
    });
    if (nearest && !may_open(*nearest, key_place(opening, "at"))) return {};
    const std::string where = "the opening from " + point_text(near.begin) + " to " + point_text(near.end);
    if (!nearest && is_inside(far, GridPoint::of((near.begin + near.end) * 0.5)))
        reading_.error(key_place(opening, "at"), "opening-faces-nothing",
                       where + " lies inside sector " + in_quotes(far.name) + ": it and sector " +
                           in_quotes(map_.sectors[near.wall.sector].name) +
                           " overlap; move one of them, or move the opening");
    else if (!nearest)
        reading_.error(key_place(opening, "at"), "opening-faces-nothing",
                       "no wall of sector " + in_quotes(far.name) + " lies parallel before " + where +
                           " over its whole width; move it, make it narrower, or give 'to' for a doorway that leads "
                           "elsewhere");
    return nearest;
}

/// Where the two rooms face each other: the only stretch where they touch, or else the one where they are nearest.
std::optional<TwoGaps> GapFinder::facing(const OpeningRecord& opening, std::size_t near_sector,
                                         std::size_t far_sector) {
    const SectorRecord &near = map_.sectors[near_sector], &far = map_.sectors[far_sector];
    const std::size_t near_walls = walls_of(near), far_walls = walls_of(far);
    if (is_too_much(opening, near_walls + far_walls + near_walls * far_walls / kPairsPerWall)) return {};
    const double width = opening.width.value_or(0) / kVertexGrid;
    std::vector<FacingStretch> best;
    for_walls(near, near_sector, [&](WallIndex near_wall, const WallLine& line) {
        if (!record(near_wall).next.empty()) return;
        for_walls(far, far_sector, [&](WallIndex far_wall, const WallLine& wall) {
            if (!line.faces(wall) || !record(far_wall).next.empty()) return;
            const double distance = -static_cast<double>(line.side(wall.a)) / line.length_steps();
            const double begin = std::max(0.0, line.steps_to(wall.a) - wall.length_steps());
            const double end = std::min(line.length_steps(), line.steps_to(wall.a));
            if (distance < 0 || begin >= end || end - begin < width) return;
            if (!best.empty() && distance > best.front().distance) return;
            if (!best.empty() && distance < best.front().distance) best.clear();
            if (best.size() < 2) best.push_back({near_wall, far_wall, line, begin, end, distance});
        });
    });
    const std::string rooms = "sectors " + in_quotes(near.name) + " and " + in_quotes(far.name);
    if (best.empty()) {
        constexpr std::size_t kPointsPerWall = 4;  // its corner and its middle, of either sector
        const bool may_look = can_afford(kPointsPerWall * near_walls * far_walls / kPairsPerWall);
        const auto common = may_look ? point_in_both(near, far) : std::nullopt;
        reading_.error(opening.place, "opening-faces-nothing",
                       "no walls of " + rooms + " face each other" + (opening.width ? " over " + metres(width) : "") +
                           (common ? ": the two overlap, as at " + point_text(*common) + "; move one of them"
                                   : "; give 'at' and 'to' for a doorway that leads elsewhere"));
        return {};
    }
    if (best.size() > 1) {
        reading_.error(opening.place, "opening-unclear",
                       "walls of " + rooms + " face each other in several places, as at " +
                           point_text(best[0].line.at((best[0].begin + best[0].end) / 2)) + " and " +
                           point_text(best[1].line.at((best[1].begin + best[1].end) / 2)) + "; say which by 'at'");
        return {};
    }
    const FacingStretch& stretch = best.front();
    const double middle = (stretch.begin + stretch.end) / 2,
                 half = (opening.width ? width : stretch.end - stretch.begin) / 2;
    const Gap gap{stretch.near, stretch.line.at(middle - half), stretch.line.at(middle + half)};
    if (!may_open(gap, opening.place)) return {};
    const auto other = opposite(opening, gap, far_sector);
    if (!other) return {};
    return TwoGaps{gap, *other};
}

std::optional<TwoGaps> GapFinder::find(const OpeningRecord& opening, std::size_t near_sector, std::size_t far_sector) {
    std::optional<TwoGaps> gaps;
    if (!is_whole(map_.sectors[near_sector]) || !is_whole(map_.sectors[far_sector])) return {};  // it was noted why
    if (!opening.at) {
        gaps = facing(opening, near_sector, far_sector);
    } else {
        const auto facing = opening.to ? std::optional<std::size_t>() : far_sector;
        const auto near = around(opening, near_sector, *opening.at, facing, key_place(opening, "at"));
        if (!near) return {};
        const auto far = opening.to ? around(opening, far_sector, *opening.to, {}, key_place(opening, "to"))
                                    : opposite(opening, *near, far_sector);
        if (far) gaps = TwoGaps{*near, *far};
    }
    if (gaps) gaps->touch = gaps->near.begin == gaps->far.end && gaps->near.end == gaps->far.begin;
    return gaps;
}

}  // namespace enfilade
