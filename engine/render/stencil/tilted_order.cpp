#include "render/stencil/plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/result.h"
#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade::stencil {
namespace {

/// Where a part begins or ends.
struct Event {
    Vec2 point;
    std::size_t part;
    bool is_begin;
};

/// Under the tie rule the eye is a hair further down the drawing than all points of its own height: none is in the
/// direction of the cut itself. A look turns to the right, from the lower half to the upper one.
bool is_in_upper_half(Vec2 point, Vec2 eye) { return point.y <= eye.y; }

/// Both edges of a corner touch its ray in a point: no ray meets both, so ends come before beginnings.
bool comes_before(const Event& e, const Event& other, Vec2 eye) {
    if (e.point == other.point) return !e.is_begin && other.is_begin;
    const bool is_upper = is_in_upper_half(e.point, eye), other_is_upper = is_in_upper_half(other.point, eye);
    if (is_upper != other_is_upper) return other_is_upper;
    return side_of_line(e.point, other.point, eye) > 0;
}

/// Turns a ray once round the eye. Those parts that it meets are always in their order along it, so of each two that
/// ever share a ray one gets before the other, maybe by way of others between them.
class AngularSweep {
public:
    AngularSweep(const std::vector<Segment>& edges, Vec2 eye, const IsMetBefore& is_met_before,
                 const IsRounded& is_rounded)
        : edges_(edges), eye_(eye), is_met_before_(is_met_before), is_rounded_(is_rounded) {
        for (std::size_t i = 0; i < edges.size(); ++i) add(i);
        before_.resize(parts_.size());
        std::sort(events_.begin(), events_.end(),
                  [&](const Event& a, const Event& b) { return comes_before(a, b, eye_); });
    }

    void turn() {
        for (std::size_t part = 0; part < parts_.size(); ++part)
            if (parts_[part].begins_at_cut) begin(part);
        for (const Event& event : events_) event.is_begin ? begin(event.part) : end(event.part);
    }

    const std::vector<SweptPart>& parts() const { return parts_; }
    /// By part: those that it is met before.
    const std::vector<std::vector<std::size_t>>& before() const { return before_; }

private:
    void add(std::size_t edge) {
        const Segment& line = edges_[edge];
        const bool is_cut = is_in_upper_half(line.a, eye_) && !is_in_upper_half(line.b, eye_);
        events_.push_back({line.a, parts_.size(), true});
        if (is_cut) {
            parts_.push_back({edge, false, true});
            parts_.push_back({edge, true, false});
        } else {
            parts_.push_back({edge, false, false});
        }
        events_.push_back({line.b, parts_.size() - 1, false});
    }

    void begin(std::size_t part) {
        const auto place = met_.insert(met_.begin() + static_cast<std::ptrdiff_t>(place_for(part)), part);
        if (place != met_.begin()) before_[*(place - 1)].push_back(part);
        if (place + 1 != met_.end()) before_[part].push_back(*(place + 1));
    }

    /// An edge that is not rounded gets between the two others of its kind that it is between.
    std::size_t place_for(std::size_t part) const {
        std::size_t first = 0, last = met_.size();
        if (!is_rounded(part)) {
            while (last > 0 && (is_rounded(met_[last - 1]) || !is_before(met_[last - 1], part))) --last;
            first = last;
            while (last < met_.size() && is_rounded(met_[last])) ++last;
        }
        // From behind, one by one: where pictures' rounded ends overlap by a hair, which tells nothing, all others
        // count.
        while (last > first && !is_before(met_[last - 1], part)) --last;
        return last;
    }

    bool is_rounded(std::size_t part) const { return is_rounded_(parts_[part].edge); }
    bool is_before(std::size_t part, std::size_t other) const {
        return is_met_before_(parts_[part].edge, parts_[other].edge);
    }

    void end(std::size_t part) {
        const auto met = std::find(met_.begin(), met_.end(), part);
        ENFILADE_CHECK(met != met_.end());  // it faces the eye, so it began before
        const auto place = met_.erase(met);
        if (place != met_.begin() && place != met_.end()) before_[*(place - 1)].push_back(*place);
    }

    const std::vector<Segment>& edges_;
    Vec2 eye_;
    const IsMetBefore& is_met_before_;
    const IsRounded& is_rounded_;
    std::vector<SweptPart> parts_;
    std::vector<Event> events_;
    std::vector<std::vector<std::size_t>> before_;
    std::vector<std::size_t> met_;  ///< by the ray, nearest first
};

/// Takes parts away, always one that no other hides (Kahn: "Topological sorting of large networks", 1962).
class Sorter {
public:
    explicit Sorter(const AngularSweep& sweep) : sweep_(sweep), hiding_(sweep.parts().size()) {
        for (const auto& hidden : sweep.before())
            for (const std::size_t part : hidden) ++hiding_[part];
        for (std::size_t part = hiding_.size(); part-- > 0;)
            if (hiding_[part] == 0) free_.push_back(part);
    }

    std::vector<SweptPart> sort() {
        std::vector<SweptPart> sorted;
        while (sorted.size() < hiding_.size()) {
            const std::size_t part = take();
            sorted.push_back(sweep_.parts()[part]);
            for (const std::size_t hidden : sweep_.before()[part])
                if (hiding_[hidden] != kTaken && --hiding_[hidden] == 0) free_.push_back(hidden);
        }
        return sorted;
    }

private:
    static constexpr std::size_t kTaken = static_cast<std::size_t>(-1);

    std::size_t take() {
        // Pictures' ends are rounded, which might leave none that is hidden by no other; then one that is hidden least.
        if (free_.empty())
            free_.push_back(
                static_cast<std::size_t>(std::min_element(hiding_.begin(), hiding_.end()) - hiding_.begin()));
        const std::size_t part = free_.back();
        free_.pop_back();
        hiding_[part] = kTaken;
        return part;
    }

    const AngularSweep& sweep_;
    std::vector<std::size_t> hiding_;  ///< how many, not yet taken, hide each one
    std::vector<std::size_t> free_;    ///< hidden by none
};

}  // namespace

std::vector<SweptPart> in_order_of_rays(const std::vector<Segment>& edges, Vec2 eye, const IsMetBefore& is_met_before,
                                        const IsRounded& is_rounded) {
    AngularSweep sweep(edges, eye, is_met_before, is_rounded);
    sweep.turn();
    return Sorter(sweep).sort();
}

// All that stands in a layer, in that order.

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
