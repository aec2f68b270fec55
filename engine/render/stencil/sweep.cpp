#include "render/stencil/sweep.h"

#include <algorithm>
#include <utility>

#include "base/result.h"
#include "math/predicates.h"

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

}  // namespace enfilade::stencil
