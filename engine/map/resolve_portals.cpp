// Portals: which sector each leads into, and which of its walls one comes out of.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/map.h"
#include "math/predicates.h"

namespace enfilade {
namespace {

// Finding the wall of a sector that lies on a given edge, the other way round.

/// Looks up walls by their ends. The map's walls must not change while it is used.
class TwinIndex {
public:
    explicit TwinIndex(const Map& map);

    /// The wall b -> a of `sector`, or none. Exact. Cost: log of the sector's walls.
    WallId find(SectorId sector, Vec2 a, Vec2 b) const;

    /// The wall of `sector` that runs the other way along the same line and covers all of a -> b, or none.
    /// Cost: the sector's walls, up to a budget in the index's life.
    WallId covering(SectorId sector, Vec2 a, Vec2 b) const;

    /// The wall of `sector` whose ends are nearest to b -> a, for telling the author; none where the budget is spent.
    WallId nearest(SectorId sector, Vec2 a, Vec2 b) const;

private:
    /// Takes `count` from what linear searches may still cost.
    bool may_search(std::size_t count) const;

    const Map& map_;
    std::vector<std::uint32_t> order_;  ///< each sector's walls, sorted by their ends
    mutable std::size_t steps_left_;
};

/// Linear searches are for findings only; a hostile file must not make them quadratic [walls looked at, about 0.1 s].
constexpr std::size_t kSearchBudget = 20'000'000;

auto key(const Wall& w) { return std::tuple(w.a.x, w.a.y, w.b.x, w.b.y); }

/// The square of how far the ends of w are from b -> a, the larger of the two.
double distance(const Wall& w, Vec2 a, Vec2 b) {
    const Vec2 from_b = w.a - b, from_a = w.b - a;
    return std::max(dot(from_b, from_b), dot(from_a, from_a));
}

/// True where v lies between the ends of w, which is on a line with it.
bool spans(const Wall& w, Vec2 v) {
    return std::min(w.a.x, w.b.x) <= v.x && v.x <= std::max(w.a.x, w.b.x) && std::min(w.a.y, w.b.y) <= v.y &&
           v.y <= std::max(w.a.y, w.b.y);
}

TwinIndex::TwinIndex(const Map& map) : map_(map), order_(map.walls.size()), steps_left_(kSearchBudget) {
    std::iota(order_.begin(), order_.end(), 0u);
    for (const Sector& s : map.sectors)
        std::sort(order_.begin() + s.first_wall, order_.begin() + s.first_wall + s.wall_count,
                  [&](std::uint32_t i, std::uint32_t j) {
                      return std::tuple(key(map.walls[i]), i) < std::tuple(key(map.walls[j]), j);
                  });
}

WallId TwinIndex::find(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    const auto begin = order_.begin() + s.first_wall, end = begin + s.wall_count;
    const auto wanted = std::tuple(b.x, b.y, a.x, a.y);
    const auto it = std::lower_bound(begin, end, wanted,
                                     [&](std::uint32_t i, const auto& ends) { return key(map_.walls[i]) < ends; });
    return it != end && key(map_.walls[*it]) == wanted ? WallId(*it) : WallId();
}

bool TwinIndex::may_search(std::size_t count) const {
    if (count > steps_left_) return false;
    steps_left_ -= count;
    return true;
}

WallId TwinIndex::covering(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    if (!may_search(s.wall_count)) return {};
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i) {
        const Wall& w = map_.walls[i];
        const bool is_on_line = w.a != w.b && corner(w.a, w.b, a) == 0 && corner(w.a, w.b, b) == 0;
        if (is_on_line && dot(w.b - w.a, b - a) < 0 && spans(w, a) && spans(w, b)) return WallId(i);
    }
    return {};
}

WallId TwinIndex::nearest(SectorId sector, Vec2 a, Vec2 b) const {
    const Sector& s = map_[sector];
    if (s.wall_count == 0 || !may_search(s.wall_count)) return {};
    std::uint32_t best = s.first_wall;
    for (std::uint32_t i = s.first_wall; i < s.first_wall + s.wall_count; ++i)
        if (distance(map_.walls[i], a, b) < distance(map_.walls[best], a, b)) best = i;
    return WallId(best);
}

}  // namespace

NameIndex sector_names(const Draft& draft) {
    std::vector<ScopedName> names;
    names.reserve(draft.map.sectors.size());
    for (std::uint32_t i = 0; i < draft.map.sectors.size(); ++i) names.push_back({0, draft.map.sectors[i].name, i});
    return NameIndex(std::move(names));
}

namespace {

NameIndex wall_names(const Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.walls.size(); ++i)
        if (!draft.walls[i].record->name.empty())
            names.push_back({draft.map.walls[i].sector.index, draft.walls[i].record->name, i});
    return NameIndex(std::move(names));
}

/// One pass over all portals with the indexes it needs.
class Resolver {
public:
    explicit Resolver(Draft& draft)
        : draft_(draft), sectors_(sector_names(draft)), walls_(wall_names(draft)), twins_(draft.map) {}

    void resolve(WallId id) {
        const WallRecord& record = *draft_.walls[id.index].record;
        refuse_stray_rise(id);
        if (record.mirror) return resolve_mirror(id);
        if (record.next.empty()) return refuse_stray_link(id);
        Wall& wall = draft_.map.walls[id.index];
        wall.behind = sector_behind(id);
        if (wall.behind.is_none() || !draft_.sectors[wall.behind.index].measurable) return;
        if (!draft_.sectors[wall.sector.index].measurable) return;
        wall.kind = WallKind::portal;
        if (record.via.empty())
            wall.exit = twin_of(id);
        else
            wall.exit = named_exit(id);
    }

private:
    void resolve_mirror(WallId id) {
        Wall& wall = draft_.map.walls[id.index];
        const WallDraft& written = draft_.walls[id.index];
        if (!written.record->next.empty() || !written.record->via.empty())
            draft_.error(std::max(key_place(*written.record, "mirror"), key_place(*written.record, "next")),
                         "mirror-portal", "a wall is a mirror or a portal, this one is both; drop mirror or next");
        wall.kind = WallKind::mirror;
        wall.behind = wall.sector;
        wall.exit = id;
    }

    /// What only a link can have.
    void refuse_stray_rise(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        if (written.record->rise && written.record->via.empty())
            draft_.error(*written.record, "rise", "rise-without-via",
                         "rise is what a link adds to heights, but this wall has no via; drop rise, or name the wall "
                         "to come out of in via");
    }

    void refuse_stray_link(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        if (!written.record->via.empty())
            draft_.error(*written.record, "via", "via-without-next",
                         "via names a wall of the sector in next, but there is no next; add next = \"its sector\"");
    }

    SectorId sector_behind(WallId id) {
        const WallDraft& written = draft_.walls[id.index];
        const std::string& name = written.record->next;
        if (const auto found = sectors_.find(0, name)) return SectorId(*found);
        if (draft_.has_nameless_sectors) return {};
        draft_.error(*written.record, "next", "unknown-sector",
                     "expected the name of a sector in next, found " + in_quotes(name) + sectors_.suggestion(0, name));
        return {};
    }

    WallId named_exit(WallId id) {
        const SectorId behind = draft_.map[id].behind;
        const WallDraft& written = draft_.walls[id.index];
        const std::string& name = written.record->via;
        if (const auto found = walls_.find(behind.index, name)) return WallId(*found);
        draft_.error(*written.record, "via", "unknown-wall",
                     "expected the name of a wall of sector " + in_quotes(draft_.map[behind].name) + " in via, found " +
                         in_quotes(name) + walls_.suggestion(behind.index, name));
        return {};
    }

    WallId twin_of(WallId id) {
        const Wall& wall = draft_.map[id];
        if (const WallId twin = twins_.find(wall.behind, wall.a, wall.b)) return twin;
        // The tutorial never looks at the neighbour's edge; one that is longer still takes whoever passes in.
        const WallId longer = draft_.is_strict() ? WallId() : twins_.covering(wall.behind, wall.a, wall.b);
        if (draft_.sectors[wall.behind.index].is_only_one) report_missing_twin(id, longer);
        return longer;
    }

    void report_missing_twin(WallId id, WallId longer) {
        const Wall& wall = draft_.map[id];
        const std::string& behind = draft_.map[wall.behind].name;
        std::string sentence = "expected an edge " + edge_text(wall.b, wall.a) + " in sector " + in_quotes(behind) +
                               ", which this portal leads into, found none";
        if (twins_.find(wall.behind, wall.b, wall.a))
            sentence += "; it has that edge the same way round, so both sectors lie on one side of it";
        else if (const WallId near = twins_.nearest(wall.behind, wall.a, wall.b))
            sentence += "; its nearest edge is " + edge_text(draft_.map[near].a, draft_.map[near].b);
        sentence += "; give both sectors the same vertices, or link the walls by name with via";
        if (longer)
            draft_.warning(draft_.walls[id.index].place, "missing-twin", std::move(sentence));
        else
            draft_.error(draft_.walls[id.index].place, "missing-twin", std::move(sentence));
    }

    Draft& draft_;
    NameIndex sectors_, walls_;
    TwinIndex twins_;
};

/// What keeps a wall from leaving a way back; empty: nothing does.
std::string fault_of_way_back(const Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    if (wall.kind != WallKind::portal)
        return "way_back is for portals, and this wall is none; give it next, or drop way_back";
    const Wall& exit = draft.map[wall.exit];
    const std::string there = "the wall one comes out of, in sector " + in_quotes(draft.map[wall.behind].name) + ", ";
    if (draft.walls[id.index].record->blocks) return "nobody passes a wall that blocks; drop blocks or way_back";
    if (exit.exit == id) return there + "leads back already; drop way_back here, or next there";
    if (exit.kind == WallKind::way_back)
        return there + "is the way back to another wall; let each of the two have a wall of its own to come out of";
    if (exit.kind != WallKind::solid || !draft.walls[wall.exit.index].record->next.empty())
        return there + "must be a plain wall to become a way back; drop its next or its mirror, or way_back here";
    if (draft.walls[id.index].record->via.empty() && (exit.a != wall.b || exit.b != wall.a))
        return there + "is longer than this one; cut it at the ends of this wall";
    return {};
}

void make_way_back(Draft& draft, WallId id) {
    const WallRecord& record = *draft.walls[id.index].record;
    const Wall& wall = draft.map[id];
    // A portal whose other end was not found has been reported as that.
    if (!record.way_back || !record.places.is_sound() ||
        (wall.kind == WallKind::portal ? !wall.exit : !record.next.empty()))
        return;
    if (std::string fault = fault_of_way_back(draft, id); !fault.empty())
        return draft.error(record, "way_back", "no-way-back", std::move(fault));
    Wall& exit = draft.map.walls[wall.exit.index];
    exit.kind = WallKind::way_back;
    exit.behind = wall.sector;
    exit.exit = id;
    draft.map.has_ways_back = true;
}

/// A room that opens onto the solid wall of its neighbour: one gets in, and not back.
void check_open_one_way(Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    if (wall.kind != WallKind::portal || !wall.exit || !draft.walls[id.index].record->via.empty()) return;
    const Wall& exit = draft.map[wall.exit];
    const WallDraft &written = draft.walls[wall.exit.index], &from = draft.walls[id.index];
    if (exit.kind != WallKind::solid || !written.record->next.empty() || exit.a != wall.b) return;
    const std::string here = in_quotes(draft.map[wall.sector].name);
    const std::string line = from.place.line != 0 ? " in line " + std::to_string(from.place.line) : std::string();
    draft.warning(known(written.record->place, written.place), "open-one-way",
                  "sector " + here + " opens onto this edge " + edge_text(exit.a, exit.b) + " of sector " +
                      in_quotes(draft.map[exit.sector].name) + line +
                      ", but from here it is a solid wall: one looks and gets in there, and not back; give it next = " +
                      here + ", or if that is meant, name this wall and add via there");
}

/// What blocks one way blocks the way back.
void block(Draft& draft, WallId id) {
    Wall& wall = draft.map.walls[id.index];
    if (wall.kind != WallKind::portal || !draft.walls[id.index].record->blocks) return;
    wall.blocks = true;
    if (wall.exit && draft.map[wall.exit].exit == id) draft.map.walls[wall.exit.index].blocks = true;
}

}  // namespace

void resolve_portals(Draft& draft) {
    Resolver resolver(draft);
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) resolver.resolve(WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) make_way_back(draft, WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) check_open_one_way(draft, WallId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) block(draft, WallId(i));
}

}  // namespace enfilade
