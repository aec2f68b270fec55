#include "render/stencil/tilted.h"

#include <cmath>

#include "math/predicates.h"
#include "math/vec.h"
#include "render/stencil/sweep.h"

namespace enfilade::stencil {

namespace {

Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

/// Whether it is behind a doorway on whose line it is, rather than before it.
bool is_behind_doorway(const Pane& pane) {
    const auto* panel = std::get_if<PanelOnScreen>(&pane);
    return is_thing(pane) || (panel != nullptr && panel->is_in_doorway);
}

/// Of panes that are equally near.
bool counts_as_nearer(const PaneInRoom& p, const PaneInRoom& q) {
    const bool is_between_rooms = p.room != q.room && is_behind_doorway(p.pane) != is_behind_doorway(q.pane);
    return is_between_rooms ? is_behind_doorway(q.pane) : p.number < q.number;
}

class Orderer {
public:
    Orderer(const Layer& layer, const FrameInput& input)
        : layer_(layer), input_(input), panes_(tilted_panes(layer, input)) {
        gather_walls();
        for (const PaneInRoom& pane : panes_) add_pane(pane);
    }

    TiltedLayer order() const {
        const auto is_met_before = [this](std::size_t i, std::size_t j) { return this->is_met_before(i, j); };
        const auto is_rounded = [this](std::size_t i) { return uprights_[i].is_thing(); };
        TiltedLayer ordered{layer_.stand_ins, {}};
        int rank = 1;
        for (const SweptPart& part : in_order_of_rays(lines_, layer_.pose.eye, is_met_before, is_rounded))
            add_part(ordered, part, rank++);
        return ordered;
    }

private:
    /// What stands on a line of lines_: a wall, or where it is not null a pane.
    struct Upright {
        WallOnScreen wall;
        const PaneInRoom* pane = nullptr;

        bool is_thing() const { return pane != nullptr && stencil::is_thing(pane->pane); }
        const WallOnScreen& place() const { return pane != nullptr ? place_of(pane->pane) : wall; }
    };

    void gather_walls() {
        for (const SectorId seen : layer_.sectors) {
            const Sector& sector = input_.map[seen];
            for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i)
                add_wall(WallId(i));
        }
    }

    void add_wall(WallId id) {
        const Map& map = input_.map;
        if (layer_.entry && (layer_.entry == id || !is_beyond(map[id], map[layer_.entry]))) return;
        auto place = in_view(map, id, layer_.pose);
        if (!place) return;
        if (layer_.entry) extend_beyond(*place, layer_.opened);
        lines_.emplace_back(map[id]);
        uprights_.push_back({*place, nullptr});
    }

    void add_pane(const PaneInRoom& pane) {
        const Segment line = line_of(pane.pane);
        if (line.a == line.b || side_of_line(line.a, line.b, layer_.pose.eye) < 0) return;  // thinner than the grid
        lines_.push_back(line);
        uprights_.push_back({{}, &pane});
    }

    Segment line_of(const Pane& pane) const {
        if (const auto* panel = std::get_if<PanelOnScreen>(&pane))
            return facing(input_.map[panel->panel], layer_.pose.eye);
        const WallOnScreen& place = place_of(pane);
        const auto* thing = std::get_if<ThingOnScreen>(&pane);
        if (thing == nullptr) return input_.map[place.wall];
        const double depth = depth_in_room(*thing);
        const Vec2 left = on_grid({place.shown_left_v.x, depth}), right = on_grid({place.shown_right_v.x, depth});
        return layer_.pose.flip < 0 ? Segment(right, left) : Segment(left, right);
    }

    Vec2 on_grid(Vec2 point_v) const {
        const Pose& pose = layer_.pose;
        return snap_to_point_grid(pose.eye + pose.right * point_v.x + pose.forward * point_v.y);
    }

    bool is_met_before(std::size_t i, std::size_t j) const {
        const Upright &p = uprights_[i], &q = uprights_[j];
        if (p.is_thing() || q.is_thing()) return is_met_before(p, q);
        if (!are_on_one_line(lines_[i], lines_[j])) return is_nearer(lines_[i], lines_[j]);
        if (p.pane != nullptr && q.pane != nullptr) return counts_as_nearer(*p.pane, *q.pane);
        return p.pane != nullptr ? !is_behind_doorway(p.pane->pane)
                                 : q.pane != nullptr && is_behind_doorway(q.pane->pane);
    }

    /// At least one is a thing. Among the panes of a room it is where its picture is, else where it is in its room: its
    /// ends are on the walls there.
    bool is_met_before(const Upright& p, const Upright& q) const {
        const Vec2 way = middle_way(p.place(), q.place());
        const bool are_panes = p.pane != nullptr && q.pane != nullptr;
        const bool are_in_one_room = are_panes && p.pane->room == q.pane->room;
        const double to_p = are_in_one_room ? distance(p.place(), way) : distance_in_room(p, way);
        const double to_q = are_in_one_room ? distance(q.place(), way) : distance_in_room(q, way);
        if (are_panes && std::fabs(to_p - to_q) < kDepthStep) return counts_as_nearer(*p.pane, *q.pane);
        return to_p < to_q;
    }

    /// In the middle of the rays that meet both.
    static Vec2 middle_way(const WallOnScreen& p, const WallOnScreen& q) {
        const bool p_begins_later = cross(q.shown_left_v, p.shown_left_v) < 0;
        const bool p_ends_sooner = cross(p.shown_right_v, q.shown_right_v) < 0;
        return unit(unit(p_begins_later ? p.shown_left_v : q.shown_left_v) +
                    unit(p_ends_sooner ? p.shown_right_v : q.shown_right_v));
    }

    /// How far away a line is in a direction [m].
    static double distance(const WallOnScreen& place, Vec2 way) {
        return place.cross / std::fabs(cross(way, place.right_v - place.left_v));
    }

    static double distance_in_room(const Upright& upright, Vec2 way) {
        if (!upright.is_thing()) return distance(upright.place(), way);
        return std::fabs(depth_in_room(std::get<ThingOnScreen>(upright.pane->pane)) / way.y);
    }

    void add_part(TiltedLayer& ordered, const SweptPart& part, int rank) const {
        const Upright& upright = uprights_[part.edge];
        if (upright.pane == nullptr) {
            ordered.walls.push_back(upright.wall);
            return cut(ordered.walls.back(), part, rank);
        }
        ordered.panes.push_back(upright.pane->pane);
        cut(place_of(ordered.panes.back()), part, rank);
    }

    /// In a mirror the cut's left is the right.
    void cut(WallOnScreen& place, const SweptPart& part, int rank) const {
        place.rank = rank;
        const bool is_mirrored = layer_.pose.flip < 0;
        const Vec2 way{dot(layer_.pose.right, kCut), dot(layer_.pose.forward, kCut)};
        if (is_mirrored ? part.ends_at_cut : part.begins_at_cut) {
            place.shown_left_v = way;
            place.is_open_left = false;
        }
        if (is_mirrored ? part.begins_at_cut : part.ends_at_cut) {
            place.shown_right_v = way;
            place.is_open_right = false;
        }
    }

    const Layer& layer_;
    const FrameInput& input_;
    std::vector<PaneInRoom> panes_;
    std::vector<Segment> lines_;     ///< as they face the eye; things' ends on the points' grid
    std::vector<Upright> uprights_;  ///< by line
};

}  // namespace

TiltedLayer tilted_order(const Layer& layer, const FrameInput& input) { return Orderer(layer, input).order(); }

}  // namespace enfilade::stencil
