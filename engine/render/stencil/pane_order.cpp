#include "render/stencil/pane_order.h"

#include <algorithm>
#include <cmath>

namespace enfilade::stencil {
namespace {

/// Directions nearer to each other than this are one [1]: panes that share an end have no ray in common.
constexpr double kSameDirection = 0x1p-40;

Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

/// Whether v is to the right of u; both are ahead of the eye, or both behind it.
bool is_right_of(Vec2 v, Vec2 u) { return cross(v, u) > kSameDirection * std::sqrt(dot(u, u) * dot(v, v)); }

/// The shown part of a pane that is all ahead of the eye, or all behind it. Those of one side never go round the eye in
/// a ring, so they can be put in order.
class Piece {
public:
    Piece(const PaneInRoom& whole, std::size_t number) : room_(whole.room), number_(number), pane_(whole.pane) {}

    const Pane& pane() const { return pane_; }
    SectorId room() const { return room_; }
    std::size_t number() const { return number_; }  ///< of the pane it is a part of
    Vec2 left() const { return place_of(pane_).shown_left_v; }
    Vec2 right() const { return place_of(pane_).shown_right_v; }
    bool is_thing() const { return std::holds_alternative<ThingOnScreen>(pane_); }
    bool is_panel() const { return std::holds_alternative<PanelOnScreen>(pane_); }
    bool is_ahead() const { return left().y + right().y >= 0; }

    /// What of it is to the right of a point that is on it becomes a piece of its own.
    Piece cut_at(Vec2 point) {
        Piece rest = *this;
        place_of(pane_).shown_right_v = place_of(rest.pane_).shown_left_v = point;
        return rest;
    }

    /// Whether it is behind a doorway on whose line it is, rather than before it.
    bool is_behind_doorway() const {
        const auto* panel = std::get_if<PanelOnScreen>(&pane_);
        return is_thing() || (panel != nullptr && panel->is_in_doorway);
    }

    /// How far away its line is in a direction [lengths of it].
    double distance(Vec2 way) const { return cross(left(), right()) / cross(way, right() - left()); }

private:
    SectorId room_;
    std::size_t number_;
    Pane pane_;
};

/// Where a line from p to q, which is on both sides of that depth, goes through it.
Vec2 point_at(double depth, Vec2 p, Vec2 q) { return {p.x + (q.x - p.x) * ((depth - p.y) / (q.y - p.y)), depth}; }

void cut_at_eye(std::vector<Piece>& pieces) {
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
        const Vec2 left = pieces[i].left(), right = pieces[i].right();
        if (left.y * right.y < 0) pieces.push_back(pieces[i].cut_at(point_at(0, left, right)));
    }
}

/// Only things go through anything: through panels.
void cut_by_panel(std::vector<Piece>& pieces, const Piece& panel) {
    const Vec2 a = panel.left(), b = panel.right();
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
        const Vec2 left = pieces[i].left(), right = pieces[i].right();
        if (!pieces[i].is_thing() || pieces[i].room() != panel.room() || (a.y < left.y) == (b.y < left.y)) continue;
        const Vec2 point = point_at(left.y, a, b);
        if ((point.x - left.x) * (point.x - right.x) < 0) pieces.push_back(pieces[i].cut_at(point));
    }
}

std::vector<Piece> pieces_of(const std::vector<PaneInRoom>& panes) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < panes.size(); ++i) pieces.emplace_back(panes[i], i);
    for (std::size_t i = 0; i < panes.size(); ++i)
        if (const Piece whole = pieces[i]; whole.is_panel()) cut_by_panel(pieces, whole);
    cut_at_eye(pieces);
    return pieces;
}

enum class Order { none, first_is_nearer, second_is_nearer };

Order order_of(const Piece& p, const Piece& q) {
    if (p.is_ahead() != q.is_ahead()) return Order::none;
    const Vec2 left = cross(q.left(), p.left()) > 0 ? q.left() : p.left();
    const Vec2 right = cross(q.right(), p.right()) > 0 ? p.right() : q.right();
    if (!is_right_of(right, left)) return Order::none;  // no ray meets both
    const Vec2 way = unit(unit(left) + unit(right));
    const double to_p = p.distance(way), to_q = q.distance(way);
    bool p_is_nearer = to_p < to_q;
    if (std::fabs(to_p - to_q) < kDepthStep) {
        const bool is_between_rooms = p.room() != q.room() && p.is_behind_doorway() != q.is_behind_doorway();
        p_is_nearer = is_between_rooms ? q.is_behind_doorway() : p.number() < q.number();
    }
    return p_is_nearer ? Order::first_is_nearer : Order::second_is_nearer;
}

/// Takes panes away, always one that no other hides (Kahn: "Topological sorting of large networks", 1962).
class Sorter {
public:
    explicit Sorter(const std::vector<Piece>& pieces)
        : pieces_(pieces), behind_(pieces.size()), hiding_(pieces.size()) {
        for (std::size_t i = 0; i < pieces.size(); ++i)
            for (std::size_t j = i + 1; j < pieces.size(); ++j) relate(i, j);
    }

    std::vector<Pane> sort() {
        std::vector<Pane> sorted;
        while (sorted.size() < pieces_.size()) {
            // Rounding might leave none that is hidden by no other; then one that is hidden least.
            const auto next = std::min_element(hiding_.begin(), hiding_.end());
            const auto i = static_cast<std::size_t>(next - hiding_.begin());
            sorted.push_back(pieces_[i].pane());
            *next = kTaken;
            for (const std::size_t hidden : behind_[i])
                if (hiding_[hidden] != kTaken) --hiding_[hidden];
        }
        return sorted;
    }

private:
    static constexpr std::size_t kTaken = static_cast<std::size_t>(-1);

    void relate(std::size_t i, std::size_t j) {
        const Order order = order_of(pieces_[i], pieces_[j]);
        if (order == Order::none) return;
        const bool i_is_nearer = order == Order::first_is_nearer;
        behind_[i_is_nearer ? i : j].push_back(i_is_nearer ? j : i);
        ++hiding_[i_is_nearer ? j : i];
    }

    const std::vector<Piece>& pieces_;
    std::vector<std::vector<std::size_t>> behind_;  ///< those that each one hides
    std::vector<std::size_t> hiding_;               ///< how many, not yet taken, hide each one
};

}  // namespace

std::vector<Pane> in_order(const std::vector<PaneInRoom>& panes) {
    const std::vector<Piece> pieces = pieces_of(panes);
    return Sorter(pieces).sort();
}

}  // namespace enfilade::stencil
