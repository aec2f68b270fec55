// Sectors, loops and walls out of their records: coordinates go onto the vertex grid and are checked there.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "base/result.h"
#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/edge_sweep.h"
#include "map/sector_finder.h"
#include "math/predicates.h"
#include "math/vec.h"

namespace enfilade {
namespace {

TextPlace place_of_vertex(const SectorRecord& sector, const LoopRecord& loop, std::size_t i) {
    if (i < loop.vertex_places.size() && loop.vertex_places[i].line != 0) return loop.vertex_places[i];
    if (i < loop.walls.size() && loop.walls[i].place.line != 0) return loop.walls[i].place;
    return loop.place.line != 0 ? loop.place : sector.place;
}

bool check_count(Draft& draft, const SectorRecord& sector, const LoopRecord& loop) {
    ENFILADE_CHECK(loop.vertices.size() == loop.walls.size());
    const std::size_t count = loop.vertices.size();
    if (count >= 3) return true;
    if (!loop.is_whole || (count == 0 && !draft.was_sound)) return false;  // the reader could not make it out
    draft.error(known(key_place(loop, "v"), sector.place), "too-few-vertices",
                "expected at least 3 vertices in a loop, found " + std::to_string(count) + " in sector " +
                    in_quotes(sector.name) + "; use a panel for a wall without thickness");
    return false;
}

/// On the grid. Rounding comes before the check: what rounds to the limit is in range.
Vec2 placed(Vec2 vertex) {
    const Vec2 v = snap_to_vertex_grid(vertex);
    ENFILADE_CHECK(std::abs(v.x) <= kWorldLimit && std::abs(v.y) <= kWorldLimit);
    return v;
}

bool check_length(Draft& draft, const SectorRecord& sector, const LoopRecord& loop, std::size_t i, const Wall& wall) {
    if (wall.a != draft.map[wall.next].a) return true;
    const std::size_t next = (i + 1) % loop.vertices.size();
    const bool was_rounded = loop.vertices[i] != loop.vertices[next];
    draft.error(place_of_vertex(sector, loop, i), "zero-length",
                "two neighbouring vertices of sector " + in_quotes(sector.name) + " are both at " + point_text(wall.a) +
                    (was_rounded ? " after rounding to the grid of 1/1024 m; drop one or move them apart"
                                 : "; drop one of them (the last wall closes the loop by itself)"));
    return false;
}

/// The loop's walls, closed into a ring.
void add_loop(Draft& draft, const SectorRecord& sector, const LoopRecord& record) {
    const auto first = static_cast<std::uint32_t>(draft.map.walls.size());
    const auto count = static_cast<std::uint32_t>(record.vertices.size());
    draft.loops.push_back({&record, first, count});
    for (std::uint32_t i = 0; i < count; ++i) {
        Wall wall;
        wall.a = placed(record.vertices[i]);
        wall.next = WallId(first + (i + 1) % count);
        draft.walls.push_back({&record.walls[i], place_of_vertex(sector, record, i)});
        draft.map.walls.push_back(wall);
    }
}

/// True where nothing is wrong with any of its loops so far.
bool add_loops(Draft& draft, const SectorRecord& record) {
    bool all = !record.loops.empty();
    if (!all && draft.was_sound)
        draft.error(record.place, "missing-key", "sector " + in_quotes(record.name) + " needs 'loops', found none");
    for (const LoopRecord& loop : record.loops) {
        if (!check_count(draft, record, loop)) {
            all = false;
            continue;
        }
        add_loop(draft, record, loop);
        const DraftLoop& added = draft.loops.back();
        for (std::uint32_t i = 0; i < added.wall_count; ++i)
            all = check_length(draft, record, loop, i, draft.map.walls[added.first_wall + i]) && all;
        all = all && loop.is_whole;
    }
    return all;
}

void add_sector(Draft& draft, const SectorRecord& record) {
    const SectorId id(draft.map.sectors.size());
    SectorDraft parts{&record};
    Sector sector;
    sector.name = record.name;
    sector.light = record.light;
    sector.unlit = record.unlit;
    if (record.light_effect) sector.light_effect = *record.light_effect;
    sector.damage = record.damage;
    sector.secret = record.secret;
    sector.leader = sector.next_of_group = id;
    sector.floor.z = record.floor.z;
    sector.ceiling.z = record.ceiling.z;
    sector.first_wall = static_cast<std::uint32_t>(draft.map.walls.size());
    parts.first_loop = static_cast<std::uint32_t>(draft.loops.size());
    parts.measurable = add_loops(draft, record);
    parts.loop_count = static_cast<std::uint32_t>(draft.loops.size()) - parts.first_loop;
    sector.wall_count = static_cast<std::uint32_t>(draft.map.walls.size()) - sector.first_wall;
    draft.has_nameless_sectors |= record.name.empty();
    draft.map.sectors.push_back(std::move(sector));
    settle_shape(draft.map, id);
    draft.sectors.push_back(parts);
}

/// Room for all walls at once: moving them while the vector grows would cost more than making them.
void reserve(Draft& draft) {
    std::size_t walls = 0, loops = 0;
    for (const SectorRecord& sector : draft.file.sectors) {
        loops += sector.loops.size();
        for (const LoopRecord& loop : sector.loops) walls += loop.walls.size();
    }
    draft.map.walls.reserve(walls);
    draft.walls.reserve(walls);
    draft.loops.reserve(loops);
    draft.map.sectors.reserve(draft.file.sectors.size());
    draft.sectors.reserve(draft.file.sectors.size());
}

// Panels out of their records: on the vertex grid, with a length and a height, inside their sectors, crossing nothing.

/// Every panel is held against every edge and every other panel of its sector. Rooms people make need some thousand
/// comparisons; a file made to keep the reader busy must not [1].
constexpr std::size_t kMostComparisons = std::size_t{1} << 27;

bool boxes_touch(const Wall& e, const Wall& f) {
    const auto apart = [](double a, double b, double c, double d) {
        return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
    };
    return !apart(e.a.x, e.b.x, f.a.x, f.b.x) && !apart(e.a.y, e.b.y, f.a.y, f.b.y);
}

bool is_on(const Wall& edge, Vec2 p) {
    return exact_cross(edge.a, edge.b, p) == 0 && p.x >= std::min(edge.a.x, edge.b.x) &&
           p.x <= std::max(edge.a.x, edge.b.x) && p.y >= std::min(edge.a.y, edge.b.y) &&
           p.y <= std::max(edge.a.y, edge.b.y);
}

/// The panels of one sector against its edges and each other.
class PanelShapes {
public:
    PanelShapes(Draft& draft, SectorId id)
        : draft_(draft),
          sector_(draft.map[id]),
          records_(draft.sectors[id.index].record->panels),
          edges_(std::span(draft.map.walls).subspan(sector_.first_wall, sector_.wall_count)) {
        for (const Panel& panel : std::span(draft.map.panels).subspan(sector_.first_panel, sector_.panel_count)) {
            panels_.emplace_back();
            panels_.back().a = panel.a;
            panels_.back().b = panel.b;
        }
    }

    std::size_t comparisons() const { return panels_.size() * (edges_.size() + panels_.size()); }

    void check() {
        for (std::size_t i = 0; i < panels_.size(); ++i)
            if (panels_[i].a != panels_[i].b && records_[i].places.is_sound("v")) check(i);
    }

private:
    void check(std::size_t i) {
        if (const Wall* edge = crossed_by(panels_[i], edges_)) return report_crossing(i, "the edge", *edge);
        const std::span<const Wall> before = std::span<const Wall>(panels_).first(i);
        if (const Wall* other = crossed_by(panels_[i], before)) return report_crossing(i, "the panel", *other);
        if (!is_within(panels_[i]))
            draft_.error(records_[i], "v", "panel-outside",
                         "the panel " + edge_text(panels_[i].a, panels_[i].b) + " is not inside sector " +
                             in_quotes(sector_.name) + "; move it, or list it under the sector it stands in");
    }

    static const Wall* crossed_by(const Wall& panel, std::span<const Wall> others) {
        for (const Wall& other : others)
            if (other.a != other.b && boxes_touch(panel, other) && meeting_of(panel, other) == Meeting::crossing)
                return &other;
        return nullptr;
    }

    void report_crossing(std::size_t i, const char* what, const Wall& other) {
        draft_.error(records_[i], "v", "panel-crosses",
                     "the panel " + edge_text(panels_[i].a, panels_[i].b) + " of sector " + in_quotes(sector_.name) +
                         " crosses " + what + " " + edge_text(other.a, other.b) +
                         "; a panel may touch walls and panels, but not pass through them: cut it in two there");
    }

    /// Of a panel that crosses no edge. It may still leave the sector at a vertex, so every piece between two vertices
    /// is asked.
    bool is_within(const Wall& panel) const {
        std::vector<Vec2> cuts{panel.a, panel.b};
        for (const Wall& edge : edges_)
            if (is_on(panel, edge.a)) cuts.push_back(edge.a);
        std::sort(cuts.begin(), cuts.end(), [](Vec2 p, Vec2 q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); });
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (cuts[i] != cuts[i + 1] && !is_around((cuts[i] + cuts[i + 1]) * 0.5)) return false;
        return true;
    }

    /// p is inside, or on an edge.
    bool is_around(Vec2 p) const {
        return is_inside(edges_, p) || std::ranges::any_of(edges_, [&](const Wall& edge) { return is_on(edge, p); });
    }

    Draft& draft_;
    const Sector& sector_;
    const std::vector<PanelRecord>& records_;
    std::span<const Wall> edges_;
    std::vector<Wall> panels_;  ///< as edges; only their ends are set
};

void check_record(Draft& draft, const SectorRecord& sector, const PanelRecord& record, const Panel& panel) {
    if (panel.a == panel.b)
        draft.error(record, "v", "zero-length",
                    "both ends of this panel of sector " + in_quotes(sector.name) + " are at " + point_text(panel.a) +
                        " on the grid of 1/1024 m; move them apart");
    if (panel.top < panel.bottom && record.places.is_sound("bottom"))
        draft.error(record, "top", "panel-upside-down",
                    "the top of this panel of sector " + in_quotes(sector.name) + " at " + number_text(panel.top) +
                        " m is below its bottom at " + number_text(panel.bottom) + " m; swap them");
}

void add_panels(Draft& draft, SectorId id) {
    const SectorRecord& record = *draft.sectors[id.index].record;
    Sector& sector = draft.map.sectors[id.index];
    sector.first_panel = static_cast<std::uint32_t>(draft.map.panels.size());
    sector.panel_count = static_cast<std::uint32_t>(record.panels.size());
    for (const PanelRecord& written : record.panels) {
        Panel panel;
        panel.a = snap_to_vertex_grid(written.a);
        panel.b = snap_to_vertex_grid(written.b);
        settle_length(panel);
        panel.sector = id;
        panel.bottom = written.bottom;
        panel.top = written.top;
        panel.blocks = written.blocks;
        if (written.blocks || !written.triggers.empty()) ++sector.active_panels;
        check_record(draft, record, written, panel);
        draft.map.panels.push_back(panel);
    }
}

}  // namespace

void place_walls(Draft& draft) {
    if (draft.file.sectors.empty() && draft.was_sound)
        draft.error(kTopOfFile, "no-sectors",
                    "expected at least one [[sectors]], found none; a map needs a room to stand in");
    reserve(draft);
    for (const SectorRecord& record : draft.file.sectors) add_sector(draft, record);
}

void place_panels(Draft& draft) {
    std::size_t comparisons = 0;
    for (std::size_t i = 0; i < draft.sectors.size(); ++i) {
        add_panels(draft, SectorId(i));
        if (!draft.sectors[i].measurable || draft.map.sectors[i].panel_count == 0) continue;
        PanelShapes shapes(draft, SectorId(i));
        comparisons += shapes.comparisons();
        if (comparisons > kMostComparisons)
            return draft.error(*draft.sectors[i].record, "panels", "too-many-panels",
                               "the panels of sector " + in_quotes(draft.map.sectors[i].name) +
                                   " are too many for a room of so many walls; divide the room");
        shapes.check();
    }
}

}  // namespace enfilade
