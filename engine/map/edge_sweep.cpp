#include "map/edge_sweep.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>

#include "formats/text_parts.h"
#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade {

namespace {

/// 1 where f, which starts no earlier than e, lies after e (towards +y), -1 where before, 0 where on one line.
int side_of_later(const SweptEdge& e, const SweptEdge& f) {
    const int at_left = corner(e.left, e.right, f.left);
    return at_left != 0 ? at_left : corner(e.left, e.right, f.right);
}

}  // namespace

bool is_left_of(Vec2 a, Vec2 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

SweptEdge swept(const Wall& wall) {
    const bool forward = is_left_of(wall.a, wall.b);
    return forward ? SweptEdge{wall.a, wall.b, true} : SweptEdge{wall.b, wall.a, false};
}

std::vector<SweptEdge> swept(std::span<const Wall> walls) {
    std::vector<SweptEdge> edges;
    edges.reserve(walls.size());
    for (const Wall& wall : walls) edges.push_back(swept(wall));
    return edges;
}

bool SweepOrder::operator()(std::uint32_t i, std::uint32_t j) const {
    const SweptEdge &e = (*edges)[i], &f = (*edges)[j];
    const int side = is_left_of(f.left, e.left) ? -side_of_later(f, e) : side_of_later(e, f);
    if (side != 0) return side > 0;
    return std::tie(e.forward, i) < std::tie(f.forward, j);
}

std::vector<SweepEvent> sweep_events(const std::vector<SweptEdge>& edges) {
    std::vector<SweepEvent> events;
    events.reserve(2 * edges.size());
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        if (edges[i].left == edges[i].right) continue;
        events.push_back({edges[i].left, true, i});
        events.push_back({edges[i].right, false, i});
    }
    std::sort(events.begin(), events.end(), [](const SweepEvent& a, const SweepEvent& b) {
        return std::tie(a.point.x, a.point.y, a.starts, a.edge) < std::tie(b.point.x, b.point.y, b.starts, b.edge);
    });
    return events;
}

namespace {

class Sweep {
public:
    explicit Sweep(std::span<const Wall> edges)
        : edges_(edges),
          swept_(swept(edges)),
          line_(SweepOrder{&swept_}),
          places_(edges.size(), line_.end()),
          is_odd_after_(edges.size()) {
        found_.is_paired.resize(edges.size());
    }

    SweepFindings run() && {
        const std::vector<SweepEvent> events = sweep_events(swept_);
        for (std::size_t i = 0; i < events.size();) i = pass(events, i);
        if (!found_.clashes.empty()) found_.wrong_sided.clear();
        return std::move(found_);
    }

private:
    using Line = std::set<std::uint32_t, SweepOrder>;
    using Place = Line::iterator;

    /// Everything that happens at one point; gives the index of the next event.
    std::size_t pass(const std::vector<SweepEvent>& events, std::size_t i) {
        const Vec2 point = events[i].point;
        for (; i < events.size() && events[i].point == point && !events[i].starts; ++i) end(events[i].edge);
        starting_.clear();
        for (; i < events.size() && events[i].point == point; ++i) starting_.push_back(events[i].edge);
        std::sort(starting_.begin(), starting_.end(), SweepOrder{&swept_});
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
        if (swept_[edge].forward == is_odd_before) found_.wrong_sided.push_back(edge);
    }

    std::span<const Wall> edges_;
    std::vector<SweptEdge> swept_;
    Line line_;                  ///< the edges under the sweep line, in its order
    std::vector<Place> places_;  ///< of each edge in line_, or its end
    std::vector<std::uint8_t> is_odd_after_;
    std::vector<std::uint32_t> starting_;
    SweepFindings found_;
};

/// Two edges on one line.
Meeting meeting_along(const Wall& e, const Wall& f) {
    if (e.a == f.b && e.b == f.a) return Meeting::back_to_back;
    const SweptEdge s = swept(e), t = swept(f);
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

namespace {

/// A fraction in lowest terms, denominator > 0.
struct Fraction {
    Int128 over;
    Int128 under;
};

Int128 size_of(Int128 x) { return x < 0 ? -x : x; }

Fraction lowest_terms(Int128 over, Int128 under) {
    Int128 a = size_of(over), b = size_of(under);
    while (b != 0) a = std::exchange(b, a % b);
    if (under < 0) a = -a;
    return {over / a, under / a};
}

std::string digits(Int128 x) {
    std::string text;
    for (Int128 rest = size_of(x); rest != 0 || text.empty(); rest /= 10)
        text += static_cast<char>('0' + static_cast<int>(rest % 10));
    if (x < 0) text += '-';
    std::reverse(text.begin(), text.end());
    return text;
}

double value(Fraction f) { return static_cast<double>(f.over) / static_cast<double>(f.under); }

/// True where a decimal with the digits of a double says it exactly: the denominator is a power of two, and both fit.
bool is_decimal(Fraction f) {
    constexpr Int128 kExact = Int128{1} << 53;
    return (f.under & (f.under - 1)) == 0 && size_of(f.over) <= kExact && f.under <= kExact;
}

std::string exact(Fraction f) { return is_decimal(f) ? number_text(value(f)) : digits(f.over) + "/" + digits(f.under); }

/// To a thousandth: where to look on the drawing.
std::string about(Fraction f) {
    const double thousandths = value(f) * 1000;
    const auto whole = static_cast<std::int64_t>(thousandths < 0 ? thousandths - 0.5 : thousandths + 0.5);
    return number_text(static_cast<double>(whole) / 1000);
}

/// A coordinate in whole steps of the vertex grid.
Int128 steps(double x) { return static_cast<Int128>(x / kVertexGrid); }

}  // namespace

std::string crossing_text(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    // p = a + (b - a) t with t = cross(c - a, d - c) / cross(b - a, d - c): below 2^26 * 2^54 in steps.
    const Int128 ex = steps(b.x - a.x), ey = steps(b.y - a.y), fx = steps(d.x - c.x), fy = steps(d.y - c.y);
    const Int128 over = steps(c.x - a.x) * fy - steps(c.y - a.y) * fx, under = ex * fy - ey * fx;
    constexpr Int128 kStepsPerMetre = 1024;
    const Fraction x = lowest_terms(steps(a.x) * under + ex * over, under * kStepsPerMetre);
    const Fraction y = lowest_terms(steps(a.y) * under + ey * over, under * kStepsPerMetre);
    const std::string point = "(" + exact(x) + ", " + exact(y) + ")";
    if (is_decimal(x) && is_decimal(y)) return point;
    return point + ", about (" + about(x) + ", " + about(y) + ")";
}

}  // namespace enfilade
