#include "render/stencil/plan.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "render/segment.h"

namespace enfilade::stencil {

namespace {

/// Length of a piece on a circle of radius 1.
constexpr double kPiece = 1.0 / 64;

/// A direction as seen from the left end of the doorway, and how far it is turned to the right from there: 0 to 4, a
/// quarter of a turn counting as 1, not evenly.
struct Turn {
    Vec2 way_v;
    double by;
};

/// What is between two directions; if it is where a wall is seen, that one.
struct Arc {
    Turn begin, end;
    WallId wall;
};

/// What the rays see that come past the doorway.
class Strays {
public:
    Strays(const Layer& layer, const Map& map) : layer_(layer), map_(map) {}

    std::vector<WallOnScreen> fill() {
        const std::vector<Arc> strays = outside(way_in());
        if (!strays.empty()) note_walls();
        for (const Arc& stray : strays) fill_stray(stray);
        return std::move(filled_);
    }

private:
    Turn turn_to(Vec2 way_v) const {
        const Vec2 from = layer_.opened.shown_left_v;
        const double right = -cross(from, way_v), ahead = dot(from, way_v);
        if (right >= 0) return {way_v, ahead > 0 ? right / (right + ahead) : 1 - ahead / (right - ahead)};
        return {way_v, ahead < 0 ? 2 + right / (right + ahead) : 3 + ahead / (ahead - right)};
    }

    /// In two where the doorway's left end is between its ends.
    void add_arcs(std::vector<Arc>& arcs, const WallOnScreen& wall) const {
        const Turn begin = turn_to(wall.left_v), end = turn_to(wall.right_v);
        if (end.by < begin.by) arcs.push_back({{layer_.opened.shown_left_v, 0}, end, wall.wall});
        arcs.push_back({begin, end.by < begin.by ? Turn{begin.way_v, 4} : end, wall.wall});
    }

    /// Where rays do not stray: between the doorway's ends as the eye behind it has them.
    std::vector<Arc> way_in() const {
        const Wall& entry = map_[layer_.entry];
        std::vector<Arc> arcs;
        if (side_of_line(entry.a, entry.b, layer_.pose.eye) < 0)
            add_arcs(arcs, in_view(Segment(entry.b, entry.a), layer_.pose));
        return arcs;
    }

    /// What of the doorway's picture is left by arcs, which are given from left to right.
    std::vector<Arc> outside(const std::vector<Arc>& arcs) const {
        std::vector<Arc> left;
        const auto add = [&](const Turn& begin, const Turn& end) {
            if (end.by > begin.by && !is_hair(begin, end)) left.push_back({begin, end, {}});
        };
        Turn reached{layer_.opened.shown_left_v, 0};
        const Turn end = turn_to(layer_.opened.shown_right_v);
        for (const Arc& arc : arcs) {
            add(reached, arc.begin.by < end.by ? arc.begin : end);
            if (arc.end.by > reached.by) reached = arc.end;
        }
        add(reached, end);
        return left;
    }

    /// A wall reaches beyond its end there (extend_beyond).
    static bool is_hair(const Turn& begin, const Turn& end) { return are_in_line(begin.way_v, end.way_v); }

    void note_walls() {
        const SectorId room = map_[layer_.entry].sector;
        note_walls(room, room_);
        for (const SectorId seen : layer_.sectors)
            if (seen != room) note_walls(seen, others_);
    }

    void note_walls(SectorId seen, std::vector<Arc>& arcs) const {
        const Sector& sector = map_[seen];
        for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) note(WallId(i), arcs);
    }

    void note(WallId id, std::vector<Arc>& arcs) const {
        if (layer_.entry == id || !is_beyond(map_[id], map_[layer_.entry])) return;
        if (const auto wall = in_view(map_, id, layer_.pose)) add_arcs(arcs, *wall);
    }

    /// From each end of a wall of the room to the next the same walls are met.
    void fill_stray(const Arc& stray) {
        const std::vector<Turn> ends = ends_in(stray);
        for (std::size_t i = 1; i < ends.size(); ++i) fill_piece(ends[i - 1], ends[i]);
    }

    std::vector<Turn> ends_in(const Arc& stray) const {
        std::vector<Turn> ends{stray.begin, stray.end};
        for (const Arc& wall : room_)
            for (const Turn& end : {wall.begin, wall.end})
                if (end.by > stray.begin.by && end.by < stray.end.by) ends.push_back(end);
        std::sort(ends.begin(), ends.end(), [](const Turn& a, const Turn& b) { return a.by < b.by; });
        return ends;
    }

    void fill_piece(const Turn& begin, const Turn& end) {
        const WallId nearest = nearest_in(begin, end);
        if (!nearest)
            fill_gap(begin, end);
        else if (is_hidden(nearest, begin, end))
            add(*in_view(map_, nearest, layer_.pose), begin, end);
    }

    WallId nearest_in(const Turn& begin, const Turn& end) const {
        WallId nearest;
        for (const Arc& arc : room_)
            if (arc.begin.by <= begin.by && arc.end.by >= end.by &&
                (!nearest || is_nearer(map_[arc.wall], map_[nearest])))
                nearest = arc.wall;
        return nearest;
    }

    bool is_hidden(WallId wall, const Turn& begin, const Turn& end) const {
        return std::any_of(others_.begin(), others_.end(), [&](const Arc& arc) {
            return arc.begin.by < end.by && arc.end.by > begin.by && is_nearer(map_[arc.wall], map_[wall]);
        });
    }

    void fill_gap(const Turn& begin, const Turn& end) {
        const Vec2 across = unit(end.way_v) - unit(begin.way_v), middle{-across.y, across.x};
        if (dot(across, across) <= kPiece * kPiece) return add(stand_in(middle), begin, end);
        fill_gap(begin, turn_to(middle));
        fill_gap(turn_to(middle), end);
    }

    void add(WallOnScreen wall, const Turn& begin, const Turn& end) {
        if (is_hair(begin, end)) return;
        wall.shown_left_v = begin.way_v;
        wall.shown_right_v = end.way_v;
        wall.is_open_left = begin.by == 0;
        wall.is_open_right = end.way_v == layer_.opened.shown_right_v;
        filled_.push_back(wall);
    }

    static Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

    /// Of what is missed a depth is known along one direction: the view's own, or the one of four that is nearest to
    /// the ray, as in the reference (kMostSlope).
    WallOnScreen stand_in(Vec2 way) const {
        std::size_t quarters = 0;
        if (!(way.y > 0 && std::fabs(way.x) <= kMostSlope * way.y))
            for (; std::fabs(way.x) > way.y; ++quarters) way = {-way.y, way.x};  // turned right, its right is behind
        const Pose face = face_of(layer_.pose, quarters);
        const SectorId room = map_[layer_.entry].sector;
        const StandIn missed = enfilade::stand_in(map_, room, face, way.x / way.y, layer_.entry);
        WallOnScreen wall = *in_view(map_, missed.wall, layer_.pose);
        constexpr Vec2 kAheads[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
        wall.missed = {missed.depth, missed.along, kAheads[quarters]};
        return wall;
    }

    const Layer& layer_;
    const Map& map_;
    std::vector<Arc> room_, others_;  ///< walls beyond the doorway: of the room behind it, of all others of the layer
    std::vector<WallOnScreen> filled_;
};

}  // namespace

std::vector<WallOnScreen> tilted_stand_ins(const Layer& layer, const Map& map) {
    if (!layer.entry || (map[layer.entry].link == Wall::kNoLink && !layer.opened.missed)) return {};
    return Strays(layer, map).fill();
}

}  // namespace enfilade::stencil
