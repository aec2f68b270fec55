#include "render/stencil/tilted_stand_ins.h"

#include <algorithm>
#include <cmath>

#include "render/segment.h"

namespace enfilade::stencil {

namespace {

/// Length of a piece on a circle of radius 1.
constexpr double kPiece = 1.0 / 64;

/// Of what is missed a depth is known along one direction: the view's own, or for rays farther from it than this the
/// one of four that is nearest, as in the reference (render/reference/ray_path.cpp) [1].
constexpr double kMostSlope = 115;

/// A direction as seen from the left end of the doorway, and how far it is turned to the right from there: 0 to 4, a
/// quarter of a turn counting as 1, not evenly.
struct Turn {
    Vec2 way_v;
    double by;
};

struct Covered {
    Turn begin, end;
};

class Gaps {
public:
    Gaps(const Layer& layer, const Map& map) : layer_(layer), map_(map) {
        const Sector& room = map[map[layer.entry].sector];
        for (std::uint32_t i = room.first_wall; i < room.first_wall + room.wall_count; ++i) note(WallId(i));
        std::sort(covered_.begin(), covered_.end(),
                  [](const Covered& a, const Covered& b) { return a.begin.by < b.begin.by; });
    }

    std::vector<WallOnScreen> fill() {
        Turn reached{layer_.opened.shown_left_v, 0};
        const Turn end = turn_to(layer_.opened.shown_right_v);
        for (const Covered& wall : covered_) {
            if (wall.begin.by >= end.by) break;
            if (wall.begin.by > reached.by) fill(reached, wall.begin);
            if (wall.end.by > reached.by) reached = wall.end;
        }
        if (end.by > reached.by) fill(reached, end);
        return std::move(filled_);
    }

private:
    Turn turn_to(Vec2 way_v) const {
        const Vec2 from = layer_.opened.shown_left_v;
        const double right = -cross(from, way_v), ahead = dot(from, way_v);
        if (right >= 0) return {way_v, ahead > 0 ? right / (right + ahead) : 1 - ahead / (right - ahead)};
        return {way_v, ahead < 0 ? 2 + right / (right + ahead) : 3 + ahead / (ahead - right)};
    }

    void note(WallId id) {
        if (layer_.entry == id || !is_beyond(map_[id], map_[layer_.entry])) return;
        const auto wall = in_view(map_, id, layer_.pose);
        if (!wall) return;
        const Turn begin = turn_to(wall->left_v), end = turn_to(wall->right_v);
        if (end.by < begin.by) covered_.push_back({{layer_.opened.shown_left_v, 0}, end});
        covered_.push_back({begin, end.by < begin.by ? Turn{begin.way_v, 4} : end});
    }

    void fill(const Turn& begin, const Turn& end) {
        if (are_in_line(begin.way_v, end.way_v)) return;  // a wall reaches beyond its end there (extend_beyond)
        const Vec2 across = unit(end.way_v) - unit(begin.way_v), middle{-across.y, across.x};
        if (dot(across, across) > kPiece * kPiece) {
            fill(begin, turn_to(middle));
            return fill(turn_to(middle), end);
        }
        WallOnScreen wall = stand_in(middle);
        wall.shown_left_v = begin.way_v;
        wall.shown_right_v = end.way_v;
        wall.is_open_left = begin.by == 0;
        wall.is_open_right = end.way_v == layer_.opened.shown_right_v;
        filled_.push_back(wall);
    }

    static Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

    WallOnScreen stand_in(Vec2 way) const {
        std::size_t quarters = 0;
        if (!(way.y > 0 && std::fabs(way.x) <= kMostSlope * way.y))
            for (; std::fabs(way.x) > way.y; ++quarters) way = {-way.y, way.x};  // turned right, its right is behind
        const Pose face = face_of(layer_.pose, quarters);
        const SectorId room = map_[layer_.entry].sector;
        const WallId id = least_missed(map_, room, face, way.x / way.y, layer_.entry);
        WallOnScreen wall = *in_view(map_, id, layer_.pose);
        wall.missed = met(*in_view(map_, id, face), way.x / way.y);
        constexpr Vec2 kAheads[] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
        wall.missed->ahead_v = kAheads[quarters];
        return wall;
    }

    /// The end of the wall that is the nearer to the ray; nothing is met behind the eye.
    static Missed met(const WallOnScreen& wall, double slope) {
        const double left = edge(wall.left_v, slope), right = edge(wall.right_v, slope);
        const double along = left != right ? std::clamp(left / (left - right), 0.0, 1.0) : 0;
        const Vec2 place = wall.left_v + (wall.right_v - wall.left_v) * along;
        return {std::max(place.y, 0.0), wall.swapped ? 1 - along : along, {}};
    }

    const Layer& layer_;
    const Map& map_;
    std::vector<Covered> covered_;
    std::vector<WallOnScreen> filled_;
};

}  // namespace

std::vector<WallOnScreen> tilted_stand_ins(const Layer& layer, const Map& map) {
    if (!layer.entry || (map[layer.entry].link == Wall::kNoLink && !layer.opened.missed)) return {};
    return Gaps(layer, map).fill();
}

}  // namespace enfilade::stencil
