#include "map/edge_sweep.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "math/predicates.h"

namespace enfilade {
namespace {

/// The order in which the sweep meets points.
bool is_left_of(Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

/// An edge as the sweep sees it.
struct Span {
    Vec2 left, right;  ///< its ends in the order of the sweep
    bool forward;      ///< the wall runs from left to right: its sector lies after it
};

Span span_of(const Wall& w) {
    const bool forward = is_left_of(w.a, w.b);
    return forward ? Span{w.a, w.b, true} : Span{w.b, w.a, false};
}

/// 1 where f, which starts no earlier than e, lies after e (towards +y), -1 where before, 0 where on one line.
int side_of_later(const Span& e, const Span& f) {
    const int at_left = corner(e.left, e.right, f.left);
    return at_left != 0 ? at_left : corner(e.left, e.right, f.right);
}

/// The order of the edges along the sweep line. Of two on one line, the one whose sector lies before it is first, so
/// that edges back to back have nothing between them.
struct Before {
    const std::vector<Span>* spans;

    bool operator()(std::uint32_t i, std::uint32_t j) const {
        const Span &e = (*spans)[i], &f = (*spans)[j];
        const int side = is_left_of(f.left, e.left) ? -side_of_later(f, e) : side_of_later(e, f);
        if (side != 0) return side > 0;
        return std::tie(e.forward, i) < std::tie(f.forward, j);
    }
};

struct Event {
    Vec2 point;
    bool starts;  ///< the edge starts here; ends come first, so that edges in a row never see each other
    std::uint32_t edge;
};

std::vector<Event> events_of(std::span<const Wall> edges, const std::vector<Span>& spans) {
    std::vector<Event> events;
    events.reserve(2 * edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (edges[i].a == edges[i].b) continue;
        events.push_back({spans[i].left, true, i});
        events.push_back({spans[i].right, false, i});
    }
    std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
        return std::tie(a.point.x, a.point.y, a.starts, a.edge) < std::tie(b.point.x, b.point.y, b.starts, b.edge);
    });
    return events;
}

class Sweep {
public:
    explicit Sweep(std::span<const Wall> edges)
        : edges_(edges), line_(Before{&spans_}), places_(edges.size(), line_.end()), is_odd_after_(edges.size()) {
        spans_.reserve(edges.size());
        for (const Wall& w : edges) spans_.push_back(span_of(w));
        found_.is_paired.resize(edges.size());
    }

    SweepFindings run() && {
        const std::vector<Event> events = events_of(edges_, spans_);
        for (std::size_t i = 0; i < events.size();) i = pass(events, i);
        if (!found_.clashes.empty()) found_.wrong_sided.clear();
        return std::move(found_);
    }

private:
    using Line = std::set<std::uint32_t, Before>;
    using Place = Line::iterator;

    /// Everything that happens at one point; gives the index of the next event.
    std::size_t pass(const std::vector<Event>& events, std::size_t i) {
        const Vec2 point = events[i].point;
        for (; i < events.size() && events[i].point == point && !events[i].starts; ++i) end(events[i].edge);
        starting_.clear();
        for (; i < events.size() && events[i].point == point; ++i) starting_.push_back(events[i].edge);
        std::sort(starting_.begin(), starting_.end(), Before{&spans_});
        for (std::uint32_t edge : starting_) start(edge);
        for (std::uint32_t edge : starting_) look_at_sides(edge);
        return i;
    }

    void end(std::uint32_t edge) {
        if (places_[edge] == line_.end()) return;
        const Place after = take_out(edge);
        if (after != line_.begin() && after != line_.end()) settle(std::prev(after), after);
    }

    void start(std::uint32_t edge) {
        const Place place = places_[edge] = line_.insert(edge).first;
        if (place != line_.begin()) settle(std::prev(place), place);
        if (places_[edge] == line_.end()) return;
        if (std::next(place) != line_.end()) settle(place, std::next(place));
    }

    /// Takes edges out until the two neighbours that are left do not clash.
    void settle(Place low, Place high) {
        for (;;) {
            ++found_.pairs_looked_at;
            const Meeting meeting = meeting_of(edges_[*low], edges_[*high]);
            if (meeting == Meeting::back_to_back) found_.is_paired[*low] = found_.is_paired[*high] = 1;
            if (meeting == Meeting::none || meeting == Meeting::back_to_back) return;
            const bool drop_low = is_dropped(meeting, *low, *high);
            found_.clashes.push_back({meeting, drop_low ? *high : *low, drop_low ? *low : *high});
            if (drop_low) {
                high = take_out(*low);
                if (high == line_.begin()) return;
                low = std::prev(high);
            } else {
                high = take_out(*high);
                if (high == line_.end()) return;
                low = std::prev(high);
            }
        }
    }

    /// Which of two clashing edges to leave out: the one that is touched, else the later one in the file.
    bool is_dropped(Meeting meeting, std::uint32_t edge, std::uint32_t other) const {
        if (meeting != Meeting::touching) return edge > other;
        const Wall &e = edges_[edge], &f = edges_[other];
        const bool e_ends_on_f = corner(f.a, f.b, e.a) == 0 || corner(f.a, f.b, e.b) == 0;
        return !e_ends_on_f;
    }

    Place take_out(std::uint32_t edge) {
        const Place after = line_.erase(places_[edge]);
        places_[edge] = line_.end();
        return after;
    }

    /// Counting edges from the outside, the inside begins after every odd one.
    void look_at_sides(std::uint32_t edge) {
        const Place place = places_[edge];
        if (place == line_.end() || !found_.clashes.empty()) return;
        const bool is_odd_before = place != line_.begin() && is_odd_after_[*std::prev(place)];
        is_odd_after_[edge] = !is_odd_before;
        if (spans_[edge].forward == is_odd_before) found_.wrong_sided.push_back(edge);
    }

    std::span<const Wall> edges_;
    std::vector<Span> spans_;
    Line line_;                  ///< the edges under the sweep line, in its order
    std::vector<Place> places_;  ///< of each edge in line_, or its end
    std::vector<std::uint8_t> is_odd_after_;
    std::vector<std::uint32_t> starting_;
    SweepFindings found_;
};

/// Two edges on one line.
Meeting meeting_along(const Wall& e, const Wall& f) {
    if (e.a == f.b && e.b == f.a) return Meeting::back_to_back;
    const Span s = span_of(e), t = span_of(f);
    const bool apart = !is_left_of(s.left, t.right) || !is_left_of(t.left, s.right);
    return apart ? Meeting::none : Meeting::overlapping;
}

}  // namespace

Meeting meeting_of(const Wall& e, const Wall& f) {
    const int f_a = corner(e.a, e.b, f.a), f_b = corner(e.a, e.b, f.b);
    if (f_a == 0 && f_b == 0) return meeting_along(e, f);
    const int e_a = corner(f.a, f.b, e.a), e_b = corner(f.a, f.b, e.b);
    if (f_a * f_b < 0 && e_a * e_b < 0) return Meeting::crossing;
    const bool f_ends_on_e = (f_a == 0 || f_b == 0) && e_a * e_b < 0;
    const bool e_ends_on_f = (e_a == 0 || e_b == 0) && f_a * f_b < 0;
    return f_ends_on_e || e_ends_on_f ? Meeting::touching : Meeting::none;
}

SweepFindings sweep_edges(std::span<const Wall> edges) { return Sweep(edges).run(); }

}  // namespace enfilade
