// The shape of a sector: edges that meet where they must not, and loops that run the wrong way round.
//
// Names of loops decide nothing. A loop that lies in no other is an outline, a loop inside an outline is a hole, a loop
// inside a hole an outline again; every edge must have the sector on its right.
#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/edge_sweep.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

std::string edge_text(const Wall& w) { return enfilade::edge_text(w.a, w.b); }

/// The end of e that lies on f.
Vec2 touching_end(const Wall& e, const Wall& f) { return corner(f.a, f.b, e.a) == 0 ? e.a : e.b; }

/// Twice the area, positive for a loop that runs clockwise on the drawing [squared grid steps]. Exact.
Int128 doubled_area(const Draft& draft, const DraftLoop& loop) {
    Int128 sum = 0;
    const Vec2 origin = draft.map.walls[loop.first_wall].a;
    for (std::uint32_t i = loop.first_wall; i < loop.first_wall + loop.wall_count; ++i) {
        const Vec2 a = draft.map.walls[i].a - origin, b = draft.map.walls[i].b - origin;
        sum += static_cast<Int128>(a.x * b.y / (kVertexGrid * kVertexGrid)) -
               static_cast<Int128>(a.y * b.x / (kVertexGrid * kVertexGrid));
    }
    return sum;
}

struct Winding {
    bool is_clockwise;          ///< by its area
    std::uint32_t wrong_edges;  ///< with the sector on their left
};

/// The checks of one sector.
class Shape {
public:
    Shape(Draft& draft, SectorId id)
        : draft_(draft),
          sector_(draft.map[id]),
          parts_(draft.sectors[id.index]),
          edges_(std::span(draft.map.walls).subspan(sector_.first_wall, sector_.wall_count)) {}

    void check() {
        const SweepFindings found = sweep_edges(edges_);
        parts_.measurable = found.clashes.empty() && found.wrong_sided.empty();
        for (const Clash& clash : found.clashes) report(as_overlap(clash));
        if (found.wrong_sided.empty()) return;
        std::vector<std::uint8_t> is_wrong(edges_.size());
        for (std::uint32_t edge : found.wrong_sided) {
            if (found.is_paired[edge])
                report_no_width(edge);
            else
                is_wrong[edge] = 1;
        }
        check_windings(is_wrong);
    }

private:
    const DraftLoop& loop(std::uint32_t i) const { return draft_.loops[parts_.first_loop + i]; }
    TextPlace place_of(std::uint32_t edge) const { return draft_.walls[sector_.first_wall + edge].place; }

    /// An edge that leans on another touches it, too, and which of the two the sweep meets first is chance.
    Clash as_overlap(const Clash& clash) const {
        const Wall &first = edges_[clash.first], &second = edges_[clash.second];
        if (clash.kind != Meeting::touching) return clash;
        const bool at_start = touching_end(first, second) == first.a;
        const std::uint32_t neighbour = (at_start ? first.previous : first.next).index - sector_.first_wall;
        if (meeting_of(edges_[neighbour], second) != Meeting::overlapping) return clash;
        return {Meeting::overlapping, neighbour, clash.second};
    }

    void report(const Clash& clash) {
        const Wall &first = edges_[clash.first], &second = edges_[clash.second];
        const std::string edges =
            "edges " + edge_text(first) + " and " + edge_text(second) + " of sector " + in_quotes(sector_.name);
        const TextPlace place = std::max(place_of(clash.first), place_of(clash.second));
        if (clash.kind == Meeting::crossing)
            draft_.error(place, "edges-cross",
                         edges + " cross at " + crossing_text(first.a, first.b, second.a, second.b) +
                             "; the edges of one sector may only share vertices");
        else if (clash.kind == Meeting::touching)
            draft_.error(place, "edges-touch",
                         "vertex " + point_text(touching_end(first, second)) + " of sector " + in_quotes(sector_.name) +
                             " lies inside its edge " + edge_text(second) + "; give that edge a vertex there");
        else
            draft_.error(place, "edges-overlap",
                         edges + " lie on each other; the edges of one sector may only share vertices");
    }

    /// Both edges of the pair come here; one of them is enough.
    void report_no_width(std::uint32_t edge) {
        const Wall& w = edges_[edge];
        if (std::tie(w.b.x, w.b.y) < std::tie(w.a.x, w.a.y)) return;
        draft_.error(place_of(edge), "edges-overlap",
                     "edge " + edge_text(w) + " of sector " + in_quotes(sector_.name) +
                         " belongs to an outline and to a hole, with nothing between them; move the hole inside");
    }

    void check_windings(const std::vector<std::uint8_t>& is_wrong) {
        std::vector<Winding> windings;
        for (std::uint32_t i = 0; i < parts_.loop_count; ++i) windings.push_back(winding_of(loop(i), is_wrong));
        const bool has_outline = std::any_of(windings.begin(), windings.end(),
                                             [](const Winding& w) { return w.is_clockwise && w.wrong_edges == 0; });
        for (std::uint32_t i = 0; i < parts_.loop_count; ++i) report(loop(i), windings[i], has_outline);
    }

    Winding winding_of(const DraftLoop& of, const std::vector<std::uint8_t>& is_wrong) const {
        const auto begin = is_wrong.begin() + (of.first_wall - sector_.first_wall);
        return {doubled_area(draft_, of) > 0, static_cast<std::uint32_t>(std::count(begin, begin + of.wall_count, 1))};
    }

    void report(const DraftLoop& of, const Winding& winding, bool has_outline) {
        if (winding.wrong_edges == 0) return;
        const TextPlace place = known(key_place(*of.record, "v"), place_of(of.first_wall - sector_.first_wall));
        if (winding.wrong_edges < of.wall_count)
            draft_.error(place, "wrong-winding",
                         "this loop of sector " + in_quotes(sector_.name) +
                             " touches itself and winds both ways; make two loops of it");
        else if (winding.is_clockwise)
            draft_.error(place, "wrong-winding",
                         "this loop of sector " + in_quotes(sector_.name) +
                             " lies inside an outline, so it is a hole and must run counter-clockwise on the drawing "
                             "(y down), but it runs clockwise; list its vertices and walls the other way round");
        else if (has_outline)
            draft_.error(place, "hole-outside",
                         "this loop of sector " + in_quotes(sector_.name) +
                             " runs counter-clockwise, as a hole does, but lies inside no outline of the sector; move "
                             "it inside, or turn it round if it is an outline");
        else
            draft_.error(place, "wrong-winding",
                         "the outline of sector " + in_quotes(sector_.name) +
                             " must run clockwise on the drawing (y down), with the sector on the right of its walls, "
                             "but it runs counter-clockwise; list its vertices and walls the other way round");
    }

    Draft& draft_;
    const Sector& sector_;
    SectorDraft& parts_;
    std::span<const Wall> edges_;
};

}  // namespace

void check_loops(Draft& draft) {
    for (std::size_t i = 0; i < draft.sectors.size(); ++i)
        if (draft.sectors[i].measurable) Shape(draft, SectorId(i)).check();
}

}  // namespace enfilade
